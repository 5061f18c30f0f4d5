#include "Filters/Model/GalaxyBuilder.h"

#include "Filters/Model/CombineImages.h"
#include "Filters/Model/DustFilaments.h"
#include "Filters/Model/ImageCleaning.h"
#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/SmoothingLength.h"
#include "Filters/Model/Spheroid.h"
#include "Filters/Model/Thickness.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

namespace galaxy
{
namespace
{
class Stopwatch
{
public:
  /// Seconds since the last call.
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->last).count();
    this->last = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
};

/// One component on its way from description to particles.
struct Plan
{
  std::size_t index = 0; ///< in the description
  Seeds seeds;
  ParticleStarts starts; ///< of discs
  std::size_t particles = 0;
  double smoothingLength = 0;
};

ComponentInfo infoOf(const ComponentDescription& component)
{
  return { component.name, component.role == ComponentRole::Absorbs, component.absorption,
    component.size, component.brightness };
}

/// Builds components of one galaxy; images are prepared once, when first asked for.
class Builder
{
public:
  Builder(const Galaxy& input, const BuildOptions& options)
    : galaxy(input.description)
    , images(input.images)
    , options(options)
    , sky(this->galaxy.centre, this->galaxy.distance)
    , disk(input.rings, this->galaxy.distance, this->galaxy.spin, this->galaxy.interpolation,
        this->galaxy.beyondLastRing)
  {
    if (this->images.size() != this->galaxy.images.size())
    {
      throw Error(this->galaxy.file, "image", "not every described image was given");
    }
    if (this->galaxy.components.size() > 256)
    {
      throw Error(this->galaxy.file, "component", "a galaxy can have 256 components at most");
    }
  }

  std::size_t indexOf(const std::string& name) const
  {
    const auto& components = this->galaxy.components;
    const auto found = std::find_if(components.begin(), components.end(),
      [&name](const ComponentDescription& component) { return component.name == name; });
    if (found == components.end())
    {
      throw Error(this->galaxy.file, name, "there is no component of this name");
    }
    return found - components.begin();
  }

  void prepareImages(const ComponentDescription& component)
  {
    if (usesImages(component))
    {
      for (const LayerDescription& layer : component.layers)
      {
        this->prepared(layer.image);
      }
    }
  }

  Seeds seedsOf(std::size_t index)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    if (component.type != ComponentType::Disk)
    {
      throw Error(this->galaxy.file, component.name, "only components of type Disk have seeds");
    }
    std::vector<SeedLayer> layers;
    if (usesImages(component))
    {
      for (const LayerDescription& layer : component.layers)
      {
        const SkyImage& image = this->prepared(layer.image);
        layers.push_back({ &image, IntensityScale(layer, image.values(), this->galaxy.file),
          layer.threshold, layer.weight, layer.color });
      }
    }
    return sampleSeeds(this->disk, component, layers, this->keyOf(index),
      this->scaledCount(component), this->galaxy.file);
  }

  /// How many particles the component gets, and how large they are.
  void count(Plan& plan, const Seeds& seeds) const
  {
    const ComponentDescription& component = this->galaxy.components[plan.index];
    const RandomKey key = this->keyOf(plan.index);
    if (component.type == ComponentType::Spheroid)
    {
      plan.particles = this->scaledCount(component);
      plan.smoothingLength = spheroidSmoothingLength(component, plan.particles);
      return;
    }
    if (component.hasDust)
    {
      requireStableFilaments(seeds, this->disk, component, this->galaxy.file);
      plan.starts = countFilaments(seeds, this->disk, component, key);
      plan.smoothingLength = filamentSmoothingLength(component);
    }
    else
    {
      plan.starts = countChildren(seeds, this->disk, component, key, this->galaxy.file);
      plan.smoothingLength = diskSmoothingLength(seeds, plan.starts, this->disk, component);
    }
    plan.particles = plan.starts[seeds.size()];
  }

  void place(const Plan& plan, const Seeds& seeds, const ParticleWriter& writer) const
  {
    const ComponentDescription& component = this->galaxy.components[plan.index];
    const RandomKey key = this->keyOf(plan.index);
    const double factor = component.role == ComponentRole::Absorbs ? component.opticalDepth : 1;
    if (component.type == ComponentType::Spheroid)
    {
      placeSpheroid(this->disk, component, key, plan.particles, factor, writer);
    }
    else if (component.hasDust)
    {
      placeFilaments(seeds, plan.starts, this->disk, component, key, factor, writer);
    }
    else
    {
      placeChildren(seeds, plan.starts, this->disk, component, key, factor, writer);
    }
  }

private:
  static bool usesImages(const ComponentDescription& component)
  {
    return component.type == ComponentType::Disk && component.profile == DiskProfile::Images;
  }

  RandomKey keyOf(std::size_t index) const
  {
    return { this->options.seed, static_cast<std::uint32_t>(index) };
  }

  std::size_t scaledCount(const ComponentDescription& component) const
  {
    const double count = this->options.particleScale * static_cast<double>(component.particles);
    if (!(count >= 0 && count < 1e15))
    {
      throw Error(this->galaxy.file, component.name, "particles: no usable number");
    }
    return static_cast<std::size_t>(std::llround(count));
  }

  const SkyImage& prepared(const std::string& name)
  {
    std::unique_ptr<SkyImage>& image = this->skyImages[name];
    if (!image)
    {
      const std::size_t index = this->imageIndex(name);
      const ImageDescription& description = this->galaxy.images[index];
      image = std::make_unique<SkyImage>(description.combine.empty()
          ? cleanedImage(this->images[index], description)
          : this->combined(description),
        this->sky, this->largestRadius());
    }
    return *image;
  }

  std::size_t imageIndex(const std::string& name) const
  {
    const auto& known = this->galaxy.images;
    const auto found = std::find_if(known.begin(), known.end(),
      [&name](const ImageDescription& description) { return description.name == name; });
    if (found == known.end())
    {
      throw Error(this->galaxy.file, name, "an image is named that is not described");
    }
    return found - known.begin();
  }

  CleanImage combined(const ImageDescription& description) const
  {
    std::vector<CombineSource> sources;
    for (const std::string& name : description.combine)
    {
      const std::size_t index = this->imageIndex(name);
      const Image& image = this->images[index];
      const ImageDescription& own = this->galaxy.images[index];
      CleanImage clean = cleanedImage(image, own);
      const Resolution resolution = resolutionOf(image, own, clean.grid);
      sources.push_back({ name, std::move(clean), resolution });
    }
    return combineImages(sources, description.signalAbove, this->galaxy.file, description.name);
  }

  double largestRadius() const
  {
    double largest = 0;
    for (const ComponentDescription& component : this->galaxy.components)
    {
      largest = std::max(largest, outerRadiusOf(component, this->disk));
    }
    return largest;
  }

  const GalaxyDescription& galaxy;
  const std::vector<Image>& images;
  const BuildOptions& options;
  SkyFrame sky;
  TiltedDisk disk;
  std::map<std::string, std::unique_ptr<SkyImage>> skyImages;
};

/// Tells the caller how far the work is; false once the caller wants no more of it.
bool proceed(const BuildOptions& options, BuildReport& report, double fraction)
{
  report.aborted = report.aborted || (options.progress && !options.progress(fraction));
  return !report.aborted;
}

std::vector<Plan> planComponents(const GalaxyDescription& galaxy, Builder& builder,
  const BuildOptions& options, BuildReport& report)
{
  std::vector<Plan> plans;
  const std::size_t count = galaxy.components.size();
  for (std::size_t k = 0; k < count && proceed(options, report, 0.5 * k / count); ++k)
  {
    const ComponentDescription& component = galaxy.components[k];
    ComponentReport done;
    done.name = component.name;
    Plan plan;
    plan.index = k;
    Stopwatch watch;
    builder.prepareImages(component);
    done.imageSeconds = watch.lap();
    if (component.type == ComponentType::Disk)
    {
      plan.seeds = builder.seedsOf(k);
    }
    done.seedSeconds = watch.lap();
    builder.count(plan, plan.seeds);
    done.thicknessSeconds = watch.lap();
    done.seedsDrawn = plan.seeds.drawn;
    done.seedsKept = plan.seeds.size();
    done.particles = plan.particles;
    done.smoothingLength = plan.smoothingLength;
    report.components.push_back(done);
    plans.push_back(std::move(plan));
  }
  return plans;
}
} // namespace

Particles buildGalaxy(const Galaxy& input, const BuildOptions& options, BuildReport* report)
{
  BuildReport unread;
  BuildReport& done = report ? *report : unread;
  done = {};
  Builder builder(input, options);
  std::vector<Plan> plans = planComponents(input.description, builder, options, done);
  std::size_t total = 0;
  for (const Plan& plan : plans)
  {
    total += plan.particles;
  }
  Particles particles = allocateParticles(total, options.velocities);
  std::size_t offset = 0;
  for (std::size_t k = 0; k < plans.size(); ++k)
  {
    if (!proceed(options, done, 0.5 + 0.5 * k / plans.size()))
    {
      break;
    }
    Stopwatch watch;
    builder.place(plans[k], plans[k].seeds,
      { particles, offset, static_cast<std::uint8_t>(k), plans[k].smoothingLength });
    offset += plans[k].particles;
    plans[k] = {};
    particles.components.push_back(infoOf(input.description.components[k]));
    done.components[k].thicknessSeconds += watch.lap();
  }
  return proceed(options, done, 1) ? std::move(particles) : Particles{};
}

Seeds buildSeeds(const Galaxy& input, const std::string& componentName, const BuildOptions& options)
{
  Builder builder(input, options);
  return builder.seedsOf(builder.indexOf(componentName));
}

Particles buildFromSeeds(const Galaxy& input, const std::string& componentName, const Seeds& seeds,
  const BuildOptions& options)
{
  Builder builder(input, options);
  Plan plan;
  plan.index = builder.indexOf(componentName);
  builder.count(plan, seeds);
  Particles particles = allocateParticles(plan.particles, options.velocities);
  builder.place(plan, seeds, { particles, 0, 0, plan.smoothingLength });
  particles.components.push_back(infoOf(input.description.components[plan.index]));
  return particles;
}
} // namespace galaxy
