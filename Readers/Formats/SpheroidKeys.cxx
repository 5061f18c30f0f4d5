#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/NumberRows.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <optional>

namespace galaxy
{
namespace
{
using S = SpheroidDescription;
using Profile = SpheroidProfile;

const std::vector<std::string> profileNames = { "Gaussian", "Sersic", "Hernquist", "Exponential",
  "Plummer", "NFW", "Cored" };
const std::vector<std::string> presetNames = { "None", "Bulge", "StellarHalo", "DarkHalo",
  "Elliptical", "DwarfSpheroidal", "DwarfElliptical", "DwarfIrregular" };

constexpr long long mostClusters = 1 << 24;
constexpr Range axisRange = { 0, 1, true };

const NumberRow<S> numbers[] = {
  { "effective_radius", &S::effectiveRadius, Range::positive(), "kpc",
    "Projected radius of half of the light (Sersic)." },
  { "sersic_index", &S::sersicIndex, Range::from(0.5, 10), "",
    "1 falls as a disk does, 4 as an elliptical (Sersic)." },
  { "scale_radius", &S::scaleRadius, Range::positive(), "kpc",
    "Scale of the density (all but Gaussian and Sersic)." },
  { "slope", &S::slope, Range::from(3.1, 20), "",
    "Exponent of the density's fall outside the core of scale_radius (Cored)." },
  { "concentration", &S::concentration, Range::from(0.01, 1e6), "",
    "Where there is no truncation, the spheroid ends at this many scale_radius (NFW, Cored)." },
  { "position_angle", &S::positionAngle, Range::any(), "degrees",
    "Of the first axis, which lies in the sky, North through East." },
  { "inclination", &S::inclination, Range::from(-180, 180), "degrees",
    "Of the plane of the first and second axis, tilted as the galaxy's disk is." },
  { "central_brightness", &S::centralBrightness, Range::notNegative(), "",
    "Brightness at the centre, seen along the third axis, where a layer's intensity 1 is 1; at "
    "effective_radius (Sersic) or at the radius of half of the mass (Hernquist, NFW). Of preset "
    "DarkHalo 0." },
  { "light_fraction", &S::lightFraction, Range::from(0, 1), "",
    "How much of all the light of light_from that lies on its disk is the spheroid's. Where the "
    "pixels under it have less than its profile asks for, others give up to twice their part; what "
    "is still missing the report and a warning say." },
  { "cluster_radius", &S::clusterRadius, Range::positive(), "kpc",
    "Plummer radius of a star cluster." },
};

Key<S> number(const std::string& name)
{
  return std::find_if(std::begin(numbers), std::end(numbers), [&](const NumberRow<S>& row) {
    return row.name == name;
  })->key();
}

/// An angle by which the spheroid leaves the rings' axes for its own.
Key<S> orienting(Key<S> key)
{
  key.byDefault = "the axes of tilted";
  key.set = [set = key.set](const KeyValue& value, S& out) {
    set(value, out);
    out.oriented = true;
  };
  return key;
}

class SpheroidCheck
{
public:
  SpheroidCheck(const KeyValue& section, const S& spheroid)
    : section(section)
    , table(section.table())
    , spheroid(spheroid)
  {
  }

  /// A length or a number that only some profiles look at.
  void belongsTo(const char* key, std::initializer_list<Profile> profiles) const
  {
    const Profile own = this->spheroid.profile;
    const auto value = this->given(key);
    if (value && std::find(profiles.begin(), profiles.end(), own) == profiles.end())
    {
      value->fail("is no key of profile " + profileNames[static_cast<int>(own)] + "; leave it out");
    }
  }

  void excludes(const char* key, std::initializer_list<const char*> others) const
  {
    for (const char* other : others)
    {
      const auto value = this->given(other);
      if (value && this->given(key))
      {
        value->contradicts(key);
      }
    }
  }

  void needs(const char* key, bool has, const char* what) const
  {
    const auto value = this->given(key);
    if (value && !has)
    {
      value->needs(what);
    }
  }

  std::optional<KeyValue> given(const char* key) const
  {
    const toml::node* node = this->table.get(key);
    return node ? std::make_optional<KeyValue>(this->section.file, key, *node) : std::nullopt;
  }

private:
  const KeyValue& section;
  const toml::table& table;
  const S& spheroid;
};

/// What is wrong with the truncation; empty where nothing is. Infinity is none.
std::string truncationComplaint(const S& spheroid)
{
  if (!(spheroid.truncation >= leastTruncation(spheroid)))
  {
    return "must be at least a millionth of the profile's scale";
  }
  const bool isTooFar =
    std::isfinite(spheroid.truncation) && spheroid.truncation > 1e12 * scaleOf(spheroid);
  return isTooFar ? "must be no more than 1e12 times the profile's scale" : "";
}

void checkSpheroid(const KeyValue& section, const S& spheroid)
{
  const SpheroidCheck check(section, spheroid);
  check.belongsTo("sigma", { Profile::Gaussian });
  check.belongsTo("effective_radius", { Profile::Sersic });
  check.belongsTo("sersic_index", { Profile::Sersic });
  check.belongsTo("scale_radius",
    { Profile::Hernquist, Profile::Exponential, Profile::Plummer, Profile::NFW, Profile::Cored });
  check.belongsTo("slope", { Profile::Cored });
  check.belongsTo("concentration", { Profile::NFW, Profile::Cored });
  check.belongsTo("axis_ratios",
    { Profile::Sersic, Profile::Hernquist, Profile::Exponential, Profile::Plummer, Profile::NFW,
      Profile::Cored });
  check.excludes("tilted", { "position_angle", "inclination", "shells" });
  check.excludes("shells", { "axis_ratios", "position_angle", "inclination" });
  check.excludes("luminosity", { "central_brightness" });
  check.excludes("clusters", { "cluster_list" });
  const bool hasSource = check.given("light_from").has_value();
  check.needs("light_fraction", hasSource, "light_from");
  check.needs("cluster_list", hasSource || check.given("luminosity"), "luminosity or light_from");
  const std::string complaint = truncationComplaint(spheroid);
  const auto truncation = check.given("truncation");
  if (truncation && !complaint.empty())
  {
    truncation->fail(complaint);
  }
}
} // namespace

double scaleOf(const SpheroidDescription& spheroid)
{
  switch (spheroid.profile)
  {
    case SpheroidProfile::Gaussian:
      return spheroid.sigma[0];
    case SpheroidProfile::Sersic:
      return spheroid.effectiveRadius;
    default:
      return spheroid.scaleRadius;
  }
}

// Beyond lie 1.5e-5 of a Gaussian, 4e-5 of an exponential, 0.4 % of a Plummer sphere, 5 % of
// Hernquist's and, of Sersic's, 1e-6 with n = 2 and 1 % with n = 4.
double usualTruncation(const SpheroidDescription& spheroid)
{
  const double scale = scaleOf(spheroid);
  switch (spheroid.profile)
  {
    case SpheroidProfile::Gaussian:
      return 5 * scale;
    case SpheroidProfile::Sersic:
    case SpheroidProfile::Plummer:
      return 20 * scale;
    case SpheroidProfile::Exponential:
      return 15 * scale;
    case SpheroidProfile::Hernquist:
      return 40 * scale;
    default:
      return std::numeric_limits<double>::infinity();
  }
}

double leastTruncation(const SpheroidDescription& spheroid)
{
  return 1e-6 * scaleOf(spheroid);
}

const Keys<SpheroidDescription>& spheroidKeys()
{
  static const Keys<S> keys = {
    choiceKey<S>("preset", &S::preset, presetNames,
      "Defaults of a kind of spheroid, which the keys beside it override."),
    choiceKey<S>("profile", &S::profile, profileNames, "Radial law of the density."),
    listKey<S>("sigma", &S::sigma, Range::positive(), "kpc",
      "Standard deviations along the three axes (Gaussian)."),
    number("effective_radius"),
    number("sersic_index"),
    number("scale_radius"),
    number("slope"),
    number("concentration"),
    withDefault(
      numberKey<S>("truncation", &S::truncation, Range::positive(), "kpc",
        "Where the spheroid ends along its first axis; luminosity is all that lies within."),
      "5 sigma (Gaussian), 20 effective_radius (Sersic), 40 (Hernquist), 15 (Exponential) or 20 "
      "(Plummer) scale_radius, concentration (NFW, Cored)"),
    listKey<S>("axis_ratios", &S::axisRatios, axisRange, "",
      "Second and third axis relative to the first (all but Gaussian)."),
    flagKey<S>("tilted", &S::tilted,
      "Whether the axes are the innermost ring's rather than the sky's West, North and depth."),
    orienting(number("position_angle")),
    orienting(number("inclination")),
    number("central_brightness"),
    withDefault(numberKey<S>("luminosity", &S::luminosity, Range::notNegative(), "kpc^2",
                  "Whole light, intensity times area, in place of central_brightness."),
      "from central_brightness"),
    textKey<S>("light_from", &S::lightFrom,
      "Disk component that emits the light of layers, from whose pixels the light is taken."),
    number("light_fraction"),
    integerKey<S>("clusters", &S::clusters, 0, mostClusters,
      "Star clusters that stand as the profile says and share the particles; 0: a smooth body."),
    textKey<S>("cluster_list", &S::clusterList,
      "File of star clusters, relative to this one: x, y, z or ra, dec, distance; luminosity, "
      "which "
      "is relative, radius."),
    number("cluster_radius"),
    textKey<S>("shells", &S::shells,
      "File of nested ellipsoids, relative to this one: semi_major, axis_ratio_b, axis_ratio_c, "
      "position_angle, inclination."),
  };
  return keys;
}

void requireInRange(const S& spheroid, const std::string& file, const std::string& component)
{
  const SectionCheck check(file, component, "spheroid");
  check.requireNumbers(numbers, spheroid);
  for (const double sigma : spheroid.sigma)
  {
    check.require(sigma, Range::positive(), "sigma");
  }
  for (const double ratio : spheroid.axisRatios)
  {
    check.require(ratio, axisRange, "axis_ratios");
  }
  const int profile = static_cast<int>(spheroid.profile);
  check.require(profile, Range::from(0, static_cast<double>(profileNames.size()) - 1), "profile");
  check.require(static_cast<double>(spheroid.clusters), Range::from(0, mostClusters), "clusters");
  check.require(
    std::isnan(spheroid.luminosity) ? 0 : spheroid.luminosity, Range::notNegative(), "luminosity");
  const std::string complaint = truncationComplaint(spheroid);
  if (!complaint.empty())
  {
    check.fail("truncation", complaint);
  }
}

void readSpheroid(const KeyValue& value, SpheroidDescription& out)
{
  const toml::table& table = value.table();
  if (const toml::node* preset = table.get("preset"))
  {
    out = spheroidPreset(
      static_cast<SpheroidPreset>(KeyValue(value.file, "preset", *preset).choice(presetNames)));
  }
  readTable(value.file, "[component.spheroid]", table, spheroidKeys(), out);
  if (std::isinf(out.truncation))
  {
    out.truncation = usualTruncation(out);
  }
  checkSpheroid(value, out);
}
} // namespace galaxy
