#include "Readers/Formats/AbsorptionKeys.h"

#include "Readers/Formats/Extinction.h"

#include <algorithm>

namespace galaxy
{
namespace
{
using C = ComponentDescription;

const std::vector<std::string> laws = { "Custom", "CCM89", "Calzetti", "Grey" };
const std::vector<std::string> calibrations = { "Given", "FaceOn", "PAH8um", "Gas", "Dust250um" };

/// The place of a member of `depth`, for the kinds of keys.
template <class Member>
auto ofDepth(Member DepthDescription::*member)
{
  return [member](C& component) -> Member& { return component.depth.*member; };
}

double bandOf(const KeyValue& value)
{
  if (!value.node.is_string())
  {
    return value.number(Range::positive());
  }
  std::vector<std::string> names;
  for (const Band& band : knownBands())
  {
    names.push_back(band.name);
  }
  return knownBands()[value.choice(names)].wavelength;
}

void readBands(const KeyValue& value, C& out)
{
  const toml::array* bands = value.node.as_array();
  if (bands == nullptr || bands->size() != out.bands.size())
  {
    value.fail("must be a list of 3 bands, names or wavelengths in um");
  }
  for (std::size_t c = 0; c < out.bands.size(); ++c)
  {
    out.bands[c] = bandOf(KeyValue(value.file, value.key, *bands->get(c)));
  }
}

/// A component's table, to fail at its keys.
struct Section
{
  const std::string& file;
  const toml::table& table;

  bool has(const char* key) const { return this->table.contains(key); }
  [[noreturn]] void failAt(const char* key, const std::string& what) const
  {
    const toml::node* node = this->table.get(key);
    KeyValue(this->file, key, node != nullptr ? *node : this->table).fail(what);
  }
  /// Refuses a key where `condition`, which would give it a meaning, does not hold.
  void requireFor(const char* key, bool condition, const std::string& what) const
  {
    if (this->has(key) && !condition)
    {
      KeyValue(this->file, key, *this->table.get(key)).needs(what);
    }
  }
};

void applyExtinction(const Section& section, C& component)
{
  const ExtinctionLaw law = component.extinction;
  const bool hasCurve = law == ExtinctionLaw::CCM89 || law == ExtinctionLaw::Calzetti;
  section.requireFor("r_v", hasCurve, "extinction = \"CCM89\" or \"Calzetti\"");
  section.requireFor("bands", hasCurve, "extinction = \"CCM89\" or \"Calzetti\"");
  if (law == ExtinctionLaw::Custom)
  {
    return;
  }
  if (section.has("absorption"))
  {
    KeyValue(section.file, "absorption", *section.table.get("absorption"))
      .contradicts("extinction");
  }
  const auto [shortest, longest] = wavelengthRange(law);
  for (const double band : component.bands)
  {
    if (!(band >= shortest && band <= longest))
    {
      section.failAt("bands",
        "must be " + written(shortest) + " to " + written(longest) + " um of " + laws[int(law)] +
          ", not " + written(band) + " um");
    }
  }
  const double R_V =
    component.totalToSelective > 0 ? component.totalToSelective : usualTotalToSelective(law);
  component.absorption = absorptionInBands(law, component.bands, R_V);
  if (*std::min_element(component.absorption.begin(), component.absorption.end()) < 0)
  {
    section.failAt("r_v", "makes the extinction negative in one of the bands; give another");
  }
}

/// With these calibrations the image itself tells the depth: no clipped intensity comes between.
void checkCalibratedLayer(const Section& section, const C& component)
{
  section.requireFor("optical_depth", false, "calibration = \"Given\" or \"FaceOn\"");
  if (!usesImages(component) || component.layers.size() != 1)
  {
    section.failAt("calibration", "must be of a disk with one layer, the image that is calibrated");
  }
  for (const char* key : { "clip", "clip_percentile", "stretch" })
  {
    if (const toml::node* node = section.table["layers"][0][key].node())
    {
      KeyValue(section.file, key, *node)
        .fail("contradicts calibration = \"" + calibrations[int(component.depth.calibration)] +
          "\", which takes the image's values as they are; leave it out");
    }
  }
}

void checkDepth(const Section& section, const C& component)
{
  const DepthCalibration calibration = component.depth.calibration;
  const bool isPah = calibration == DepthCalibration::PAH8um;
  const bool isGas = calibration == DepthCalibration::Gas;
  const bool isWarm = calibration == DepthCalibration::Dust250um;
  section.requireFor("reference_optical_depth", isPah, "calibration = \"PAH8um\"");
  section.requireFor("reference_radius", isPah, "calibration = \"PAH8um\"");
  section.requireFor("stellar_image", isPah, "calibration = \"PAH8um\"");
  section.requireFor("molecular_image", isGas, "calibration = \"Gas\"");
  section.requireFor(
    "co_to_h2", isGas && !component.depth.molecularImage.empty(), "molecular_image");
  section.requireFor("dust_to_gas", isGas, "calibration = \"Gas\"");
  section.requireFor("dust_temperature", isWarm, "calibration = \"Dust250um\"");
  section.requireFor("v_over_250um", isWarm, "calibration = \"Dust250um\"");
  section.requireFor("calibration", component.role == ComponentRole::Absorbs, "role = \"Absorbs\"");
  if (isPah || isGas || isWarm)
  {
    checkCalibratedLayer(section, component);
  }
  else if (calibration == DepthCalibration::FaceOn && component.type != ComponentType::Disk)
  {
    section.failAt("calibration",
      "\"FaceOn\" is the depth across a disk; set type = \"Disk\" or another calibration");
  }
}

/// A section that the component's particles would be made without.
void checkSections(const Section& section, const C& component)
{
  section.requireFor("dust", component.type == ComponentType::Disk, "type = \"Disk\"");
  if (section.has("dust") && section.has("thickness"))
  {
    KeyValue(section.file, "thickness", *section.table.get("thickness"))
      .contradicts("[component.dust]");
  }
}

void requireImage(const Section& section, const char* key, const std::string& name,
  const std::vector<std::string>& images)
{
  if (!name.empty() && std::find(images.begin(), images.end(), name) == images.end())
  {
    section.failAt(key, "there is no [image." + name + "]" + suggestion(name, images));
  }
}
} // namespace

Keys<C> absorptionKeys()
{
  using D = DepthDescription;
  return {
    choiceKey<C>("extinction", &C::extinction, laws,
      "Of an absorber: the law that `absorption` follows from: Cardelli, Clayton & Mathis 1989, "
      "Calzetti et al. 2000, or the same in every band."),
    withDefault(numberKey<C>("r_v", &C::totalToSelective, Range::from(2, 6), "",
                  "R_V = A_V/E(B-V) of the law."),
      "3.1 of CCM89, 4.05 of Calzetti"),
    { "bands",
      "3 wavelengths in um or names: FUV, NUV, U, B, V, R, Halpha, I, J, H, K, 3.6um, 4.5um",
      "[\"R\", \"V\", \"B\"]", "What red, green and blue stand for, for the law.", readBands },
    choiceKey<C>("calibration", ofDepth(&D::calibration), calibrations,
      "Of an absorber: where its depth comes from: optical_depth at intensity 1, along the line of "
      "sight (across the disk with profile Exponential) or across the disk; an 8 um image, in "
      "proportion; hydrogen; dust emission at 250 um. Of the last three threshold is a depth."),
    numberKey<C>("reference_optical_depth", ofDepth(&D::referenceDepth), Range::notNegative(), "",
      "Of PAH8um: mean depth in V along the line of sight within reference_radius."),
    withDefault(numberKey<C>("reference_radius", ofDepth(&D::referenceRadius), Range::positive(),
                  "kpc", "Of PAH8um: where reference_optical_depth is the mean."),
      "the whole disk"),
    textKey<C>("stellar_image", ofDepth(&D::stellarImage),
      "Of PAH8um: image of 3.6 um; 0.232 of it, starlight, is taken off."),
    textKey<C>("molecular_image", ofDepth(&D::molecularImage),
      "Of Gas: image of CO(1-0) in K km/s, or of H2 per cm2, that is added to the layer's H I."),
    numberKey<C>("co_to_h2", ofDepth(&D::coToH2), Range::positive(), "per cm2 per K km/s",
      "Of Gas: H2 for the light of CO(1-0)."),
    numberKey<C>("dust_to_gas", ofDepth(&D::dustToGas), Range::notNegative(), "",
      "Of Gas: dust for the hydrogen, in units of the Milky Way's."),
    numberKey<C>("dust_temperature", ofDepth(&D::dustTemperature), Range::from(2.8, 1000), "K",
      "Of Dust250um: temperature of the dust."),
    numberKey<C>("v_over_250um", ofDepth(&D::extinctionOver250um), Range::positive(), "",
      "Of Dust250um: the dust's extinction in V over its absorption at 250 um."),
    textKey<C>("deredden", &C::deredden,
      "Of an emitter with layers: the absorber with layers, a disk, whose dust the images show it "
      "behind, to be undone."),
    choiceKey<C>("dust_geometry", &C::dustGeometry, { "Sheet", "Mixed" },
      "Of deredden: a thin sheet of dust halfway through the light, or both mixed evenly."),
  };
}

void finishAbsorption(const std::string& file, const toml::table& table, C& component)
{
  const Section section{ file, table };
  applyExtinction(section, component);
  checkDepth(section, component);
  checkSections(section, component);
  section.requireFor("deredden", component.role == ComponentRole::Emits, "role = \"Emits\"");
  section.requireFor("deredden", usesImages(component), "a disk with layers");
  section.requireFor("dust_geometry", !component.deredden.empty(), "deredden");
}

void checkAbsorption(const toml::table& root, const GalaxyDescription& galaxy)
{
  std::vector<std::string> images, absorbers;
  for (const ImageDescription& image : galaxy.images)
  {
    images.push_back(image.name);
  }
  for (const C& component : galaxy.components)
  {
    if (component.role == ComponentRole::Absorbs && usesImages(component))
    {
      absorbers.push_back(component.name);
    }
  }
  for (std::size_t c = 0; c < galaxy.components.size(); ++c)
  {
    const C& component = galaxy.components[c];
    const Section section{ galaxy.file, *root["component"][c].as_table() };
    requireImage(section, "stellar_image", component.depth.stellarImage, images);
    requireImage(section, "molecular_image", component.depth.molecularImage, images);
    const std::string& dust = component.deredden;
    if (!dust.empty() && std::find(absorbers.begin(), absorbers.end(), dust) == absorbers.end())
    {
      section.failAt("deredden",
        "there is no disk '" + dust + "' that absorbs by its layers" + suggestion(dust, absorbers));
    }
  }
}
} // namespace galaxy
