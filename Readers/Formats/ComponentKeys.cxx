#include "Readers/Formats/GalaxyKeys.h"

#include <climits>

namespace galaxy
{
namespace
{
constexpr const char* rgb = "red, green, blue in linear light";

/// A section that is read into a member of the component.
template <class Part>
Key<ComponentDescription> partKey(
  const char* name, Part ComponentDescription::*part, const Keys<Part>& (*keys)())
{
  return sectionKey<ComponentDescription>(
    name, [=](const KeyValue& value, ComponentDescription& out) {
      readTable(
        value.file, std::string("[component.") + name + "]", value.table(), keys(), out.*part);
    });
}

void readLayers(const KeyValue& value, ComponentDescription& out)
{
  for (const toml::table* table : value.tables())
  {
    LayerDescription& layer = out.layers.emplace_back();
    readTable(value.file, "layers", *table, layerKeys(), layer);
    if (layer.clips && layer.clipsByPercentile)
    {
      KeyValue(value.file, "clip_percentile", *table->get("clip_percentile"))
        .fail("contradicts clip: give one or the other");
    }
  }
}

void readDust(const KeyValue& value, ComponentDescription& out)
{
  out.hasDust = true;
  readTable(value.file, "[component.dust]", value.table(), dustKeys(), out.dust);
}

void readClip(const KeyValue& value, LayerDescription& out)
{
  const std::vector<double> clip = value.numbers(2, Range::any());
  if (!(clip[1] > clip[0]))
  {
    value.fail("the second value must be greater than the first");
  }
  out.clips = true;
  out.clip = { clip[0], clip[1] };
}

void readClipPercentile(const KeyValue& value, LayerDescription& out)
{
  const std::vector<double> clip = value.numbers(2, Range::from(0, 100));
  if (!(clip[1] > clip[0]))
  {
    value.fail("the second value must be greater than the first");
  }
  out.clipsByPercentile = true;
  out.clipPercentile = { clip[0], clip[1] };
}
} // namespace

const Keys<LayerDescription>& layerKeys()
{
  using L = LayerDescription;
  static const Keys<L> keys = {
    required(textKey<L>("image", &L::image, "The image that gives the values, by its name.")),
    listKey<L>("color", &L::color, Range::notNegative(), rgb, "Colour of the layer; 1 is full."),
    numberKey<L>("weight", &L::weight, Range::notNegative(), "", "Factor on the intensity."),
    { "clip", "2 numbers, the image's unit", "0 and the 99.9th percentile of what is positive",
      "Values that become intensity 0 and 1.", readClip },
    { "clip_percentile", "2 numbers 0 to 100", "none",
      "The same as percentiles of the valid pixels, in place of clip.", readClipPercentile },
    numberKey<L>("threshold", &L::threshold, Range::notNegative(), "",
      "Seeds of a lower intensity are culled."),
    choiceKey<L>("stretch", &L::stretch, { "Linear", "Sqrt", "Asinh", "Density", "Log" },
      "From the clipped value t to the intensity: t, sqrt(t), asinh(10 t)/asinh(10), for a "
      "photographic plate (10^t - 1)/9, or log10(1 + 1000 t)/log10(1001)."),
  };
  return keys;
}

const Keys<ThicknessDescription>& thicknessKeys()
{
  using T = ThicknessDescription;
  static const Keys<T> keys = {
    choiceKey<T>("model", &T::model, { "Gaussian", "Tapered", "Flared", "Hydrostatic", "Rings" },
      "How a seed becomes a cloud of children."),
    choiceKey<T>("law", &T::law, { "Gaussian", "Sech2", "Exponential", "Lorentzian", "Box" },
      "Vertical density law of Tapered, Flared and Hydrostatic.", 1),
    numberKey<T>("children", &T::children, Range::notNegative(), "",
      "Children a seed, at intensity 1 (Gaussian) or at the centre (the others)."),
    integerKey<T>("maximum_children", &T::maximumChildren, 1, INT_MAX,
      "Most children a seed; the light is kept."),
    numberKey<T>("sigma", &T::sigma, Range::notNegative(), "kpc",
      "Spread in all directions (Gaussian) or in the plane (the others)."),
    numberKey<T>("compression", &T::compression, Range::from(0, 1), "",
      "Exponent from the image's intensity to the seed's (Gaussian)."),
    numberKey<T>("scale_length", &T::scaleLength, Range::positive(), "kpc",
      "Radial scale length: of the children (Tapered) or the stars (Hydrostatic)."),
    numberKey<T>("scale_height", &T::scaleHeight, Range::positive(), "kpc",
      "Vertical scale: of the children (Tapered) or the stars (Hydrostatic)."),
    flagKey<T>("taper_thickness", &T::taperThickness,
      "Whether the thickness falls with radius as the children do (Tapered)."),
    numberKey<T>("fwhm_centre", &T::fwhmCentre, Range::notNegative(), "kpc",
      "Full width at half maximum at the centre (Flared)."),
    numberKey<T>("fwhm_edge", &T::fwhmEdge, Range::positive(), "kpc",
      "Full width at half maximum at the stellar disc's edge (Flared)."),
    numberKey<T>("edge_radius", &T::edgeRadius, Range::positive(), "kpc",
      "Radius of the stellar disc's edge (Flared)."),
    numberKey<T>("flare_length", &T::flareLength, Range::positive(), "kpc",
      "Length of the exponential flare beyond the edge (Flared)."),
    numberKey<T>("fwhm_maximum", &T::fwhmMaximum, Range::positive(), "kpc",
      "Largest full width at half maximum (Flared)."),
    numberKey<T>("reference_velocity", &T::referenceVelocity, Range::positive(), "km/s",
      "Rotation velocity at which the widths hold (Flared)."),
    numberKey<T>("velocity_exponent", &T::velocityExponent, Range::any(), "",
      "Exponent of reference over rotation velocity (Flared)."),
    numberKey<T>("gas_dispersion", &T::gasDispersion, Range::positive(), "km/s",
      "Velocity dispersion of the gas (Hydrostatic)."),
    numberKey<T>("stellar_surface_density", &T::stellarSurfaceDensity, Range::notNegative(),
      "Msun/pc^2", "Surface density of the stars at the centre (Hydrostatic)."),
    numberKey<T>("gas_surface_density", &T::gasSurfaceDensity, Range::notNegative(), "Msun/pc^2",
      "Surface density of the gas (Hydrostatic)."),
  };
  return keys;
}

const Keys<DustDescription>& dustKeys()
{
  using D = DustDescription;
  static const Keys<D> keys = {
    choiceKey<D>("model", &D::model, { "RingVelocity", "DiskRotation" },
      "Whether a filament keeps its seed's velocity or follows the rotation."),
    integerKey<D>("steps", &D::steps, 1, INT_MAX, "Particles a filament."),
    numberKey<D>("step_length", &D::stepLength, Range::positive(), "kpc",
      "Distance between the particles of a filament."),
    numberKey<D>("velocity_dispersion", &D::velocityDispersion, Range::positive(), "km/s",
      "Random velocity in the plane."),
    numberKey<D>("vertical_dispersion", &D::verticalDispersion, Range::positive(), "km/s",
      "Random velocity across the plane."),
    numberKey<D>(
      "scale_height", &D::scaleHeight, Range::positive(), "kpc", "Root mean square height."),
    numberKey<D>("damping_time", &D::dampingTime, Range::positive(), "Myr",
      "Time in which a random velocity is forgotten."),
  };
  return keys;
}

const Keys<SpheroidDescription>& spheroidKeys()
{
  using S = SpheroidDescription;
  static const Keys<S> keys = {
    listKey<S>(
      "sigma", &S::sigma, Range::positive(), "kpc", "Standard deviations along the three axes."),
    flagKey<S>("tilted", &S::tilted,
      "Whether the axes are the innermost ring's rather than the sky's West, North and depth."),
    numberKey<S>("central_brightness", &S::centralBrightness, Range::notNegative(), "",
      "Brightness at the centre, seen along the third axis, where a layer's intensity 1 is 1."),
  };
  return keys;
}

const Keys<ComponentDescription>& componentKeys()
{
  using C = ComponentDescription;
  constexpr long long mostParticles = 1LL << 40;
  static const Keys<C> keys = {
    required(textKey<C>("name", &C::name, "Name, unlike that of any other component.")),
    choiceKey<C>("type", &C::type, { "Disk", "Spheroid" }, "Shape of the population."),
    choiceKey<C>("role", &C::role, { "Emits", "Absorbs" }, "Stars and glowing gas, or dust."),
    integerKey<C>("particles", &C::particles, 0, mostParticles,
      "Seeds of a disk before culling; particles of a spheroid."),
    choiceKey<C>("profile", &C::profile, { "Images", "Exponential" },
      "Where a disk's brightness comes from: its layers, or exp(-r / scale_length)."),
    numberKey<C>("scale_length", &C::scaleLength, Range::positive(), "kpc",
      "Scale length of profile Exponential."),
    numberKey<C>(
      "inner_radius", &C::innerRadius, Range::notNegative(), "kpc", "No seeds within it."),
    withDefault(numberKey<C>(
                  "outer_radius", &C::outerRadius, Range::positive(), "kpc", "No seeds beyond it."),
      "the last ring"),
    listKey<C>(
      "color", &C::color, Range::notNegative(), rgb, "Colour where no layer gives one; 1 is full."),
    { "layers", "list of layers", "none", "The images that make it; keys in `layers` below.",
      readLayers },
    withDefault(numberKey<C>("smoothing_length", &C::smoothingLength, Range::notNegative(), "kpc",
                  "Radius at which a particle's footprint ends."),
      "from the particles' distances"),
    numberKey<C>("size", &C::size, Range::positive(), "", "Factor on the radius when drawn."),
    numberKey<C>("brightness", &C::brightness, Range::notNegative(), "",
      "Factor on the light, or on the opacity, when drawn."),
    numberKey<C>("optical_depth", &C::opticalDepth, Range::notNegative(), "",
      "Of an absorber: depth in V along the line of sight at intensity 1."),
    listKey<C>("absorption", &C::absorption, Range::notNegative(), "red, green, blue",
      "Of an absorber: absorption relative to V."),
    partKey("thickness", &C::thickness, &thicknessKeys),
    sectionKey<C>("dust", readDust),
    partKey("spheroid", &C::spheroid, &spheroidKeys),
  };
  return keys;
}

ComponentDescription readComponent(const std::string& file, const toml::table& table)
{
  ComponentDescription component;
  readTable(file, "[[component]]", table, componentKeys(), component);
  const auto failAt = [&](const char* key, const std::string& what) {
    const toml::node* node = table.get(key);
    KeyValue(file, key, node != nullptr ? *node : table).fail(what);
  };
  if (!(component.outerRadius > component.innerRadius))
  {
    failAt("outer_radius", "must be greater than inner_radius");
  }
  if (component.type == ComponentType::Disk && component.profile == DiskProfile::Images &&
    component.layers.empty())
  {
    failAt("layers", "missing: a disk needs layers, or profile = \"Exponential\"");
  }
  return component;
}
} // namespace galaxy
