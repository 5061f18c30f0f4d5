#include "Readers/Formats/GalaxyKeys.h"

#include "Readers/Formats/ComponentLimit.h"
#include "Readers/Formats/RingHeading.h"
#include "Readers/Formats/SkyKeys.h"

#include <algorithm>
#include <climits>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double lightSpeed = 299792.458; // km/s

void readGalaxy(const KeyValue& value, GalaxyDescription& out)
{
  const toml::table& table = value.table();
  readTable(value.file, "[galaxy]", table, galaxyKeys(), out);
  for (const char* key : { "inclination", "position_angle", "rotation_velocity", "radius" })
  {
    if (!out.rings.empty() && table.contains(key))
    {
      KeyValue(value.file, key, *table.get(key)).contradicts("rings");
    }
  }
  for (const char* key :
    { "ring_disk", "ring_sides", "ring_law", "ring_pixel_scale", "ring_galaxy", "ring_columns" })
  {
    if (out.rings.empty() && table.contains(key))
    {
      KeyValue(value.file, key, *table.get(key)).needs("rings");
    }
  }
}

/// { quantity = "the table's name of its column", ... }
Key<GalaxyDescription> ringColumnsKey()
{
  return { "ring_columns", "section of texts", "the usual names",
    "What the table of rings calls the columns of r, vrot, Z0, i, PA, SBR, vrad, vsys and name, "
    "where "
    "it is not the usual: `{ vrot = \"V_c\" }`.",
    [](const KeyValue& value, GalaxyDescription& out) {
      std::vector<std::string> known = { "name" };
      for (const Quantity& quantity : ringQuantities())
      {
        known.push_back(quantity.symbol);
      }
      for (const auto& [name, node] : inTextOrder(value.table()))
      {
        const KeyValue column(value.file, name, *node);
        const Quantity* quantity = quantityOf(plainName(name));
        if (quantity == nullptr && name != "name")
        {
          failAtUnknownKey(column, "ring_columns", known);
        }
        out.ringOptions.columns[quantity == nullptr ? name : quantity->symbol] = column.text();
      }
    } };
}

void readComponents(const KeyValue& value, GalaxyDescription& out)
{
  for (const toml::table* table : value.tables())
  {
    if (out.components.size() == mostComponents)
    {
      KeyValue(value.file, "component", *table).fail("more than 256 components; leave some out");
    }
    const ComponentDescription component = readComponent(value.file, *table);
    for (const ComponentDescription& other : out.components)
    {
      if (other.name == component.name)
      {
        KeyValue(value.file, "name", *table->get("name"))
          .fail("there is another component '" + component.name + "'; give each its own name");
      }
    }
    out.components.push_back(component);
  }
}
} // namespace

const Keys<GalaxyDescription>& fileKeys()
{
  static const Keys<GalaxyDescription> keys = {
    required(sectionKey<GalaxyDescription>("galaxy", readGalaxy)),
    sectionKey<GalaxyDescription>("image", readImages),
    sectionKey<GalaxyDescription>("component", readComponents),
  };
  return keys;
}

const Keys<GalaxyDescription>& galaxyKeys()
{
  using G = GalaxyDescription;
  static const Keys<G> keys = {
    withDefault(textKey<G>("name", &G::name, "The galaxy's name."), "the file's name"),
    required(rightAscensionKey<G>(
      [](G& g) -> double& { return g.centre.ra; }, "Right ascension of the centre, ICRS.")),
    required(declinationKey<G>(
      [](G& g) -> double& { return g.centre.dec; }, "Declination of the centre, ICRS.")),
    required(numberKey<G>("distance", &G::distance, Range::positive(), "Mpc", "Distance.")),
    withDefault(textKey<G>("rings", &G::rings, "File of tilted rings, relative to this one."),
      "one flat disc, from the four keys below"),
    integerKey<G>(
      "ring_disk", [](G& g) -> int& { return g.ringOptions.disk; }, 1, INT_MAX,
      "Which disk of a TiRiFiC file with several."),
    choiceKey<G>(
      "ring_sides", [](G& g) -> RingSides& { return g.ringOptions.sides; },
      { "First", "Second", "Mean" },
      "Of a disk in two halves (AZ1P, AZ1W): its own values, the other half's, or the mean."),
    choiceKey<G>(
      "ring_law", [](G& g) -> LayerLaw& { return g.ringOptions.layerLaw; },
      { "FromFile", "Gaussian", "Sech2", "Exponential", "Lorentzian", "Box" },
      "Vertical law of the rings' scale heights."),
    withDefault(numberKey<G>(
                  "ring_pixel_scale", [](G& g) -> double& { return g.ringOptions.pixelScale; },
                  Range::positive(), "arcsec", "Size of the pixels that the rings count in."),
      "the file's"),
    textKey<G>(
      "ring_galaxy", [](G& g) -> std::string& { return g.ringOptions.galaxyName; },
      "Whose rows of a table with the rings of several galaxies."),
    ringColumnsKey(),
    numberKey<G>("inclination", &G::inclination, Range::from(-180, 180), "degrees",
      "Inclination of the flat disc; 0 is face-on."),
    positionAngleKey<G>(
      &G::positionAngle, "Of the flat disc's receding major axis, North through East."),
    numberKey<G>("rotation_velocity", &G::rotationVelocity, Range::from(-lightSpeed, lightSpeed),
      "km/s", "Rotation velocity of the flat disc."),
    numberKey<G>("radius", &G::radius, Range::positive(), "kpc", "Radius of the flat disc."),
    choiceKey<G>("spin", &G::spin, { "FromCode", "Clockwise", "CounterClockwise" },
      "Sense of rotation on the sky; FromCode is what the rings' program means."),
    choiceKey<G>("interpolation", &G::interpolation, { "LinearAngles", "Slerp" },
      "Between rings: angles linear in radius, or normals along great circles."),
    choiceKey<G>("beyond_last_ring", &G::beyondLastRing, { "Drop", "HoldLast" },
      "What happens beyond the last ring: nothing there, or its plane goes on."),
    flagKey<G>("mock", &G::mock, "Whether the data are made up; pictures then say so."),
    textKey<G>("credit", &G::credit, "Whose data these are."),
  };
  return keys;
}

std::string describeKeys()
{
  return "| section | key | type and unit | default | meaning |\n|---|---|---|---|---|\n" +
    describeSection("[galaxy]", galaxyKeys()) + describeSection("[image.NAME]", imageKeys()) +
    describeSection("[[component]]", componentKeys()) + describeSection("layers", layerKeys()) +
    describeSection("[component.thickness]", thicknessKeys()) +
    describeSection("[component.dust]", dustKeys()) +
    describeSection("[component.spheroid]", spheroidKeys()) +
    describeSection("[component.smoothing]", smoothingKeys()) +
    describeSection("[group]", groupKeys()) + describeSection("[[member]]", memberKeys());
}
} // namespace galaxy
