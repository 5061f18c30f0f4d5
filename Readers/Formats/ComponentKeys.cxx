#include "Readers/Formats/AbsorptionKeys.h"
#include "Readers/Formats/GalaxyKeys.h"

namespace galaxy
{
namespace
{
constexpr const char* rgb = "red, green, blue in linear light";

void readLayers(const KeyValue& value, ComponentDescription& out)
{
  for (const toml::table* table : value.tables())
  {
    LayerDescription& layer = out.layers.emplace_back();
    readTable(value.file, "layers", *table, layerKeys(), layer);
    if (layer.clips && layer.clipsByPercentile)
    {
      KeyValue(value.file, "clip_percentile", *table->get("clip_percentile")).contradicts("clip");
    }
  }
}

void readParticles(const KeyValue& value, ComponentDescription& out)
{
  constexpr long long mostParticles = 1LL << 40;
  out.automaticCount = value.isAuto();
  if (!out.automaticCount)
  {
    out.particles = value.integer(0, mostParticles);
  }
}

void readDust(const KeyValue& value, ComponentDescription& out)
{
  out.hasDust = true;
  readTable(value.file, "[component.dust]", value.table(), dustKeys(), out.dust);
}

void readSmoothing(const KeyValue& value, ComponentDescription& out)
{
  SmoothingDescription& smoothing = out.smoothing;
  readTable(value.file, "[component.smoothing]", value.table(), smoothingKeys(), smoothing);
  if (smoothing.minimum > smoothing.maximum)
  {
    const toml::node* maximum = value.table().get("maximum");
    KeyValue(value.file, "maximum", maximum != nullptr ? *maximum : value.node)
      .fail("must be at least the minimum");
  }
}

void readSmoothingLength(const KeyValue& value, ComponentDescription& out)
{
  const double length = value.number(Range::notNegative());
  if (length > 0)
  {
    out.smoothing.model = SmoothingModel::Constant;
    out.smoothing.length = length;
  }
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

const Keys<ComponentDescription>& componentKeys()
{
  using C = ComponentDescription;
  static const Keys<C> keys = [] {
    Keys<C> own = {
      required(textKey<C>("name", &C::name, "Name, unlike that of any other component.")),
      choiceKey<C>("type", &C::type, { "Disk", "Spheroid" }, "Shape of the population."),
      choiceKey<C>("role", &C::role, { "Emits", "Absorbs" }, "Stars and glowing gas, or dust."),
      { "particles", "whole number, at least 0, or \"Auto\"", std::to_string(C().particles),
        "Seeds of a disk before culling; particles of a spheroid. Auto: as many as `noise` asks "
        "for.",
        readParticles },
      numberKey<C>("noise", &C::noise, Range::positive(), "",
        "Relative noise of the light in a beam of its image that particles = \"Auto\" aims at."),
      choiceKey<C>("sampling", &C::sampling, { "ImageDriven", "SurfaceUniform" },
        "Seeds of a disk in proportion to its light, or evenly over its surface, the dark culled."),
      choiceKey<C>("normalize_at", &C::normalizeAt, { "Child", "Seed", "None" },
        "What shares the flux of an image's pixel: the particles seen on it, its seeds, or "
        "nothing: "
        "every seed has its pixel's intensity, however many there are."),
      choiceKey<C>("profile", &C::profile, { "Images", "Exponential" },
        "Where a disk's brightness comes from: its layers, or exp(-r / scale_length)."),
      numberKey<C>("scale_length", &C::scaleLength, Range::positive(), "kpc",
        "Scale length of profile Exponential."),
      numberKey<C>(
        "inner_radius", &C::innerRadius, Range::notNegative(), "kpc", "No seeds within it."),
      withDefault(numberKey<C>("outer_radius", &C::outerRadius, Range::positive(), "kpc",
                    "No seeds beyond it."),
        "the last ring"),
      listKey<C>("color", &C::color, Range::notNegative(), rgb,
        "Colour where no layer gives one; 1 is full."),
      { "layers", "list of layers", "none", "The images that make it; keys in `layers` below.",
        readLayers },
      { "smoothing_length", writtenType("number", "kpc", Range::notNegative()),
        "from the particles' distances",
        "Radius at which a particle's footprint ends: model Constant of `[component.smoothing]`; "
        "0: as that section says.",
        readSmoothingLength },
      numberKey<C>("size", &C::size, Range::positive(), "", "Factor on the radius when drawn."),
      numberKey<C>("brightness", &C::brightness, Range::notNegative(), "",
        "Factor on the light, or on the opacity, when drawn."),
      numberKey<C>("optical_depth", &C::opticalDepth, Range::notNegative(), "",
        "Of an absorber: depth in V along the line of sight at intensity 1."),
      listKey<C>("absorption", &C::absorption, Range::notNegative(), "red, green, blue",
        "Of an absorber: absorption relative to V."),
      numberKey<C>("velocity_dispersion", &C::velocityDispersion, Range::notNegative(), "km/s",
        "Random motion of the particles of a disk or a spheroid along every axis."),
      sectionKey<C>(
        "thickness", [](const KeyValue& value, C& out) { readThickness(value, out.thickness); }),
      sectionKey<C>("smoothing", readSmoothing),
      sectionKey<C>("dust", readDust),
      sectionKey<C>(
        "spheroid", [](const KeyValue& value, C& out) { readSpheroid(value, out.spheroid); }),
    };
    const Keys<C> absorption = absorptionKeys();
    own.insert(own.end(), absorption.begin(), absorption.end());
    return own;
  }();
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
  const bool hasImages =
    component.type == ComponentType::Disk && component.profile == DiskProfile::Images;
  if (hasImages && component.layers.empty())
  {
    failAt("layers", "missing; give a disk layers, or profile = \"Exponential\"");
  }
  if (hasImages && !component.hasDust && component.normalizeAt == NormalizeAt::Child &&
    component.thickness.childLight == ChildLight::Inherit)
  {
    KeyValue(file, "child_light", *table["thickness"]["child_light"].node())
      .fail("\"Inherit\" does nothing where a pixel's particles share its flux; set "
            "normalize_at = \"Seed\" or \"None\"");
  }
  finishAbsorption(file, table, component);
  if (table.contains("smoothing") && table["smoothing_length"].value_or(0.0) > 0)
  {
    KeyValue(file, "smoothing_length", *table.get("smoothing_length"))
      .contradicts("[component.smoothing]");
  }
  if (component.automaticCount && !hasImages)
  {
    failAt("particles", "\"Auto\" counts by the images of a disk; give a number here");
  }
  return component;
}
} // namespace galaxy
