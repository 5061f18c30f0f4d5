#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/NumberRows.h"

#include <climits>

namespace galaxy
{
namespace
{
using T = ThicknessDescription;

const NumberRow<T> numbers[] = {
  { "children", &T::children, Range::notNegative(), "",
    "Children a seed, at intensity 1 (Gaussian) or at the centre (the others)." },
  { "sigma", &T::sigma, Range::notNegative(), "kpc",
    "Spread in all directions (Gaussian) or in the plane (the others)." },
  { "compression", &T::compression, Range::from(0, 1), "",
    "Exponent from the image's intensity to the seed's (Gaussian)." },
  { "scale_length", &T::scaleLength, Range::positive(), "kpc",
    "Radial scale length: of the children (Tapered) or the stars (Hydrostatic)." },
  { "scale_height", &T::scaleHeight, Range::positive(), "kpc",
    "Vertical scale: of the children (Tapered) or the stars (Hydrostatic)." },
  { "fwhm_centre", &T::fwhmCentre, Range::notNegative(), "kpc",
    "Full width at half maximum at the centre (Flared)." },
  { "fwhm_edge", &T::fwhmEdge, Range::positive(), "kpc",
    "Full width at half maximum at the stellar disc's edge (Flared)." },
  { "edge_radius", &T::edgeRadius, Range::positive(), "kpc",
    "Radius of the stellar disc's edge (Flared)." },
  { "flare_length", &T::flareLength, Range::positive(), "kpc",
    "Length of the exponential flare beyond the edge (Flared)." },
  { "fwhm_maximum", &T::fwhmMaximum, Range::positive(), "kpc",
    "Largest full width at half maximum (Flared)." },
  { "reference_velocity", &T::referenceVelocity, Range::positive(), "km/s",
    "Rotation velocity of a galaxy that has these widths (Flared)." },
  { "velocity_exponent", &T::velocityExponent, Range::any(), "",
    "Exponent of reference over rotation velocity, by which the widths are multiplied (Flared)." },
  { "gas_dispersion", &T::gasDispersion, Range::positive(), "km/s",
    "Velocity dispersion of the gas (Hydrostatic)." },
  { "stellar_surface_density", &T::stellarSurfaceDensity, Range::notNegative(), "Msun/pc^2",
    "Surface density of the stars at the centre (Hydrostatic)." },
  { "gas_surface_density", &T::gasSurfaceDensity, Range::notNegative(), "Msun/pc^2",
    "Surface density of the gas (Hydrostatic)." },
};

void readProfile(const KeyValue& value, T& out)
{
  out.profileFile = value.text();
}

Keys<T> makeKeys()
{
  Keys<T> keys = {
    choiceKey<T>("model", &T::model, { "Gaussian", "Tapered", "Flared", "Hydrostatic", "Rings" },
      "How a seed becomes a cloud of children; their heights are along the normal of their ring's "
      "plane."),
    choiceKey<T>("law", &T::law, { "Gaussian", "Sech2", "Exponential", "Lorentzian", "Box" },
      "Vertical density law of Tapered, Flared and Hydrostatic.", 1),
    choiceKey<T>("reading", &T::reading, { "RadialScale", "Literal" },
      "Of the paper's formula (Tapered): whether the children fall with scale_length or, to the "
      "letter, with scale_height; both are scale_height thick."),
    choiceKey<T>("child_light", &T::childLight, { "Share", "Inherit" },
      "Whether the children of a seed share its light or have all of it each, as normalize_at = "
      "Seed and None let them."),
    integerKey<T>("maximum_children", &T::maximumChildren, 1, INT_MAX, "Most children a seed."),
    flagKey<T>("taper_thickness", &T::taperThickness,
      "Whether the thickness falls with radius by scale_length (Tapered)."),
    choiceKey<T>("velocity_scaling", &T::velocityScaling, { "Maximum", "Local" },
      "The rotation velocity that the widths are inverse to (Flared): the disk's fastest, or the "
      "fastest from each radius outward. A disk without rings or rotation_velocity is not scaled."),
    { "profile_table", "file", "none",
      "Rows of radius and full width at half maximum, kpc, in place of all the formula (Flared).",
      readProfile },
  };
  for (const NumberRow<T>& row : numbers)
  {
    keys.push_back(row.key());
    if (row.name == std::string("children"))
    {
      keys.back().byDefault = "15 (Tapered), 1 (the others)";
    }
  }
  return keys;
}

bool isOneOf(int value, int first, int last)
{
  return value >= first && value <= last;
}
} // namespace

const Keys<T>& thicknessKeys()
{
  static const Keys<T> keys = makeKeys();
  return keys;
}

void readThickness(const KeyValue& value, T& out)
{
  const toml::table& table = value.table();
  readTable(value.file, "[component.thickness]", table, thicknessKeys(), out);
  if (!table.contains("children"))
  {
    out.children = usualChildren(out.model);
  }
  if (!out.profileFile.empty() && out.model != ThicknessModel::Flared)
  {
    KeyValue(value.file, "profile_table", *table.get("profile_table")).needs("model = \"Flared\"");
  }
}

void noteRotation(const toml::table& root, GalaxyDescription& galaxy)
{
  const bool known = !galaxy.rings.empty() || root["galaxy"]["rotation_velocity"].node() != nullptr;
  for (ComponentDescription& component : galaxy.components)
  {
    component.thickness.rotationKnown = known;
  }
}

void requireInRange(const T& thickness, const std::string& file, const std::string& component)
{
  const SectionCheck check(file, component, "thickness");
  check.requireNumbers(numbers, thickness);
  check.require(thickness.maximumChildren >= 1, "maximum_children", "at least 1");
  check.require(
    isOneOf(int(thickness.model), 0, int(ThicknessModel::Rings)), "model", "a known model");
  check.require(
    isOneOf(int(thickness.law), int(LayerLaw::Gaussian), int(LayerLaw::Box)), "law", "a known law");
  check.require(isOneOf(int(thickness.reading), 0, int(TaperReading::Literal)), "reading",
    "RadialScale or Literal");
  check.require(isOneOf(int(thickness.velocityScaling), 0, int(VelocityScaling::Local)),
    "velocity_scaling", "Maximum or Local");
  check.require(isOneOf(int(thickness.childLight), 0, int(ChildLight::Inherit)), "child_light",
    "Share or Inherit");
}
} // namespace galaxy
