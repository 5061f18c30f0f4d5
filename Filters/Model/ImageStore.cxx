#include "Filters/Model/ImageStore.h"

#include "Filters/Model/Deredden.h"
#include "Filters/Model/ImageCleaning.h"
#include "Filters/Model/IntensityScale.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace galaxy
{
namespace
{
/// What images show farther than 10 degrees from the galaxy is not its light.
constexpr double widest = 10 * 3.14159265358979323846 / 180;
} // namespace

ImageStore::ImageStore(const Galaxy& input, const TiltedDisk& disk, double radius)
  : galaxy(input.description)
  , images(input.images)
  , disk(disk)
  , sky(this->galaxy.centre, this->galaxy.distance)
  , radius(std::max(radius, 1000 * this->galaxy.distance * std::tan(widest)))
{
}

void ImageStore::prepare(const ComponentDescription& component)
{
  for (const LayerDescription& layer : component.layers)
  {
    this->prepared(layer.image);
  }
}

LightMap ImageStore::lightOf(const ComponentDescription& component, double radius, double* beyond)
{
  std::vector<SeedLayer> layers;
  for (const LayerDescription& layer : component.layers)
  {
    layers.push_back(this->layerOf(component, layer));
  }
  const LightMap::ChangeColor change = this->dereddeningOf(component);
  LightMap map(layers, component, radius, this->galaxy.file, change);
  if (beyond)
  {
    *beyond = map.fluxBeyond(layers, change);
  }
  return map;
}

SeedLayer ImageStore::layerOf(const ComponentDescription& component, const LayerDescription& layer)
{
  const SkyImage& image = this->prepared(layer.image);
  const IntensityScale scale(layer, image.values(), this->galaxy.file);
  this->clips[&layer] = scale.clip();
  const SeedLayer made = { &image, [scale](double value, double, double) { return scale(value); },
    layer.threshold, layer.weight, layer.color };
  return component.role == ComponentRole::Absorbs &&
      component.depth.calibration != DepthCalibration::Given
    ? this->calibratedLayerOf(component, layer, made)
    : made;
}

SeedLayer ImageStore::calibratedLayerOf(
  const ComponentDescription& component, const LayerDescription& layer, SeedLayer uncalibrated)
{
  SeedLayer calibrated = uncalibrated;
  if (component.depth.calibration == DepthCalibration::FaceOn)
  {
    const OpticalDepth depth(component, this->galaxy.file);
    calibrated.threshold = 0; // of the intensity, before it becomes a depth
    calibrated.scale = [=, inverse = this->inverseOf(component), &disk = this->disk](
                         double value, double x, double y) {
      const double intensity = uncalibrated.scale(value, x, y);
      if (!(intensity >= uncalibrated.threshold))
      {
        return 0.0;
      }
      DiskInverse::Sheets sheets;
      const int count = inverse.find(x, y, sheets);
      return std::accumulate(
        sheets.begin(), sheets.begin() + count, 0.0, [&](double sum, const DiskSheet& sheet) {
          return sum + depth(intensity, 0, std::abs(disk.frame(sheet.r).n.z));
        });
    };
    return calibrated;
  }
  const std::string companionName = OpticalDepth::companionOf(component);
  const SkyImage* companion = companionName.empty() ? nullptr : &this->prepared(companionName);
  const DepthImage own = this->depthImageOf(layer.image);
  const DepthImage other = companion ? this->depthImageOf(companionName) : DepthImage{};
  OpticalDepth depth(component, this->galaxy.file, &own, companion ? &other : nullptr);
  const auto companionAt = [companion](double x, double y) {
    return companion ? companion->smoothValue(x, y) : 0;
  };
  if (depth.needsReference())
  {
    // A sunflower of points, even in the disc's area.
    constexpr std::size_t points = 100000;
    constexpr double goldenAngle = 2.3999632297286533;
    const double outer =
      std::min(component.depth.referenceRadius, outerRadiusOf(component, this->disk));
    const auto radiusOf = [=](std::size_t k) { return outer * std::sqrt((k + 0.5) / points); };
    depth.setReference(meanWithin(points, outer, radiusOf, [&](std::size_t k) {
      const Vec3 p = this->disk.position(radiusOf(k), k * goldenAngle);
      return depth.signal(uncalibrated.image->value(p.x, p.y), companionAt(p.x, p.y));
    }));
  }
  calibrated.scale = [depth, companionAt](double value, double x, double y) {
    return depth(value, companionAt(x, y));
  };
  return calibrated;
}

DepthImage ImageStore::depthImageOf(const std::string& name) const
{
  const std::size_t index = this->indexOf(name);
  const Image& image = this->images[index];
  const bool converts = !isColumnDensity(image.unit);
  return { name, image.unit,
    converts ? brightnessOf(image, this->galaxy.images[index]) : Brightness{} };
}

DiskInverse ImageStore::inverseOf(const ComponentDescription& component) const
{
  return { this->disk, std::max(0.0, component.innerRadius), outerRadiusOf(component, this->disk) };
}

LightMap::ChangeColor ImageStore::dereddeningOf(const ComponentDescription& component)
{
  if (component.deredden.empty())
  {
    return {};
  }
  const auto& components = this->galaxy.components;
  const auto dust = std::find_if(components.begin(), components.end(),
    [&](const ComponentDescription& other) { return other.name == component.deredden; });
  if (dust == components.end() || !usesImages(*dust))
  {
    throw Error(this->galaxy.file, component.name,
      "deredden: " + component.deredden + " must be a disk with layers");
  }
  const auto map =
    std::make_shared<LightMap>(this->lightOf(*dust, outerRadiusOf(*dust, this->disk)));
  const double perIntensity = lightFactor(*dust);
  // The map is a square, but there is no dust off the dust's own disc.
  return [map, perIntensity, inverse = this->inverseOf(*dust), absorption = dust->absorption,
           geometry = component.dustGeometry](double x, double y, Color& color) {
    const std::uint32_t pixel = map->pixelAt(x, y);
    const bool isBehind = pixel != LightMap::nowhere && inverse.covers(x, y);
    const double tau = isBehind ? perIntensity * map->intensity(pixel) : 0;
    const Color factors = dereddening(geometry, tau, absorption);
    std::transform(
      color.begin(), color.end(), factors.begin(), color.begin(), std::multiplies<double>());
  };
}

std::vector<ImageReport> ImageStore::reportOf(const ComponentDescription& component) const
{
  std::vector<ImageReport> reports;
  const auto add = [&](const std::string& name) -> ImageReport& {
    const auto sky = this->skies.find(name);
    return reports.emplace_back(
      ImageReport{ name, sky == this->skies.end() ? SkyLevel{} : sky->second, std::nullopt,
        this->images[this->indexOf(name)].note });
  };
  for (const LayerDescription& layer : component.layers)
  {
    for (const std::string& source : this->galaxy.images[this->indexOf(layer.image)].combine)
    {
      add(source);
    }
    add(layer.image).clip = this->clips.at(&layer);
  }
  return reports;
}

double ImageStore::beamOf(const ComponentDescription& component) const
{
  double sharpest = std::numeric_limits<double>::infinity();
  for (const LayerDescription& layer : component.layers)
  {
    // One that is combined of others is as sharp as its first.
    const ImageDescription* description = &this->galaxy.images[this->indexOf(layer.image)];
    while (!description->combine.empty())
    {
      description = &this->galaxy.images[this->indexOf(description->combine.front())];
    }
    const Image& image = this->images[description - this->galaxy.images.data()];
    const SkyGrid grid = gridOf(image, *description);
    sharpest = std::min(sharpest, resolutionOf(image, *description, grid).beam);
  }
  constexpr double perRadian = 206264.80624709636;
  return sharpest / perRadian * 1000 * this->galaxy.distance;
}

const SkyImage& ImageStore::prepared(const std::string& name)
{
  std::unique_ptr<SkyImage>& image = this->skyImages[name];
  if (!image)
  {
    const std::size_t index = this->indexOf(name);
    const ImageDescription& description = this->galaxy.images[index];
    image = std::make_unique<SkyImage>(description.combine.empty()
        ? cleanedImage(this->images[index], description)
        : this->combined(description),
      this->sky, this->radius);
    if (description.combine.empty())
    {
      this->skies[name] = image->skyLevel();
    }
  }
  return *image;
}

std::size_t ImageStore::indexOf(const std::string& name) const
{
  const auto& known = this->galaxy.images;
  const auto found = std::find_if(known.begin(), known.end(),
    [&name](const ImageDescription& description) { return description.name == name; });
  if (found == known.end())
  {
    throw Error(
      this->galaxy.file, name, "an image is named that is not described; add [image." + name + "]");
  }
  if (this->images.size() != known.size())
  {
    throw Error(
      this->galaxy.file, name, "not every described image was given; connect GalaxyReader itself");
  }
  return found - known.begin();
}

CleanImage ImageStore::combined(const ImageDescription& description)
{
  std::vector<CombineSource> sources;
  for (const std::string& name : description.combine)
  {
    const std::size_t index = this->indexOf(name);
    const Image& image = this->images[index];
    const ImageDescription& own = this->galaxy.images[index];
    CleanImage clean = cleanedImage(image, own);
    this->skies[name] = clean.sky;
    const Resolution resolution = resolutionOf(image, own, clean.grid);
    sources.push_back({ name, std::move(clean), resolution });
  }
  return combineImages(sources, description.signalAbove, this->galaxy.file, description.name);
}

double lightFactor(const ComponentDescription& component)
{
  const DepthCalibration calibration = component.depth.calibration;
  const bool isGiven = calibration == DepthCalibration::Given ||
    (calibration == DepthCalibration::FaceOn && !usesImages(component));
  return component.role == ComponentRole::Absorbs && isGiven ? component.opticalDepth : 1;
}
} // namespace galaxy
