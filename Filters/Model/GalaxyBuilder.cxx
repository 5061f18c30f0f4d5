#include "Filters/Model/GalaxyBuilder.h"

#include "Filters/Model/AutomaticCount.h"
#include "Filters/Model/BlockSum.h"
#include "Filters/Model/DrawnLayer.h"
#include "Filters/Model/DustFilaments.h"
#include "Filters/Model/FiniteParticles.h"
#include "Filters/Model/ImageStore.h"
#include "Filters/Model/ModelMemory.h"
#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Photometry.h"
#include "Filters/Model/PixelFill.h"
#include "Filters/Model/RadialProfile.h"
#include "Filters/Model/SightLines.h"
#include "Filters/Model/SmoothingLength.h"
#include "Filters/Model/Spheroid.h"
#include "Filters/Model/Stopwatch.h"
#include "Filters/Model/SurfaceDraws.h"
#include "Filters/Model/Thickness.h"
#include "Readers/Formats/ComponentLimit.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace galaxy
{
namespace
{
ComponentInfo infoOf(const ComponentDescription& component)
{
  return { component.name, component.role == ComponentRole::Absorbs, component.absorption,
    component.size, component.brightness };
}

double largestRadius(const GalaxyDescription& galaxy, const TiltedDisk& disk)
{
  double largest = 0;
  for (const ComponentDescription& component : galaxy.components)
  {
    largest = std::max(largest, outerRadiusOf(component, disk));
  }
  return largest;
}

/// Builds components of one galaxy.
class Builder
{
public:
  Builder(const Galaxy& input, const BuildOptions& options, BuildReport& report)
    : input(input)
    , galaxy(input.description)
    , options(options)
    , report(report)
    , disk(input.rings, this->galaxy.distance, this->galaxy.spin, this->galaxy.interpolation,
        this->galaxy.beyondLastRing)
    , store(input, this->disk, largestRadius(this->galaxy, this->disk))
  {
    requireUsable(options, this->galaxy.file);
    if (this->galaxy.components.size() > mostComponents)
    {
      throw Error(this->galaxy.file, "component", "more than 256 components; leave some out");
    }
    this->report = {};
    this->report.components.resize(this->galaxy.components.size());
    this->components = this->galaxy.components.size();
    this->particles.velocity.resize(0);
  }

  std::size_t indexOf(const std::string& name) const
  {
    const auto& components = this->galaxy.components;
    const auto found = std::find_if(components.begin(), components.end(),
      [&name](const ComponentDescription& component) { return component.name == name; });
    if (found == components.end())
    {
      throw Error(this->galaxy.file, name,
        "there is no component of this name; choose one of the .galaxy file's");
    }
    return found - components.begin();
  }

  Particles build()
  {
    requireMemoryFor({ &this->galaxy }, this->options);
    this->proceed();
    for (std::size_t k = 0; k < this->galaxy.components.size(); ++k)
    {
      const ComponentDescription& component = this->galaxy.components[k];
      if (component.type == ComponentType::Disk)
      {
        this->appendDisk(k);
      }
      else if (component.spheroid.lightFrom.empty())
      {
        this->appendSpheroid(k, nullptr, 0);
      }
    }
    for (const ComponentDescription& component : this->galaxy.components)
    {
      this->particles.components.push_back(infoOf(component));
    }
    this->tell(1);
    return std::move(this->particles);
  }

  Seeds seedsOf(std::size_t index)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    if (component.type != ComponentType::Disk)
    {
      throw Error(this->galaxy.file, component.name,
        "only components of type Disk have seeds; choose one, or use GalaxyModel");
    }
    this->components = 1;
    this->proceed();
    std::optional<LightMap> map = this->lightOf(index, false);
    return this->sample(index, map);
  }

  Particles fromSeeds(std::size_t index, const Seeds& seeds)
  {
    this->components = 1;
    this->proceed();
    this->report.components[index].seedsKept = seeds.size();
    this->placeDisk(index, seeds);
    this->proceed();
    this->smooth(index, 0);
    this->drawnLayer(index).settle(this->particles, 0, this->particles.size());
    this->showDiskToEarth(0);
    this->particles.components = { infoOf(this->galaxy.components[index]) };
    std::fill(this->particles.component.begin(), this->particles.component.end(), 0);
    return std::move(this->particles);
  }

private:
  /// Says that another stage is done; its seconds.
  double proceed()
  {
    this->tell(this->after(this->stagesDone++));
    return this->watch.lap();
  }

  /// The fraction that is done after so many stages.
  double after(double stages) const
  {
    constexpr double stagesOfOne = 6;
    return std::min(1.0, stages / (stagesOfOne * std::max<double>(1, this->components)));
  }

  Progress presentStage() const
  {
    return partOf(
      this->options.progress, this->after(this->stagesDone - 1), this->after(this->stagesDone));
  }

  void tell(double fraction)
  {
    const bool isGivenUp = this->work && this->work->isAborted();
    if (isGivenUp || (this->options.progress && !this->options.progress(fraction)))
    {
      throw Aborted(this->galaxy.file, "", "the model was given up");
    }
  }

  RandomKey keyOf(std::size_t index) const
  {
    return { this->options.seed, static_cast<std::uint32_t>(index) };
  }

  std::size_t scaled(const ComponentDescription& component, double particles) const
  {
    return scaledCount(this->options, particles, this->galaxy.file, component.name);
  }

  double outerRadius(const ComponentDescription& component) const
  {
    return outerRadiusOf(component, this->disk);
  }

  DiskInverse inverseOf(const ComponentDescription& component) const
  {
    return { this->disk, std::max(0.0, component.innerRadius), this->outerRadius(component) };
  }

  /// What the component should look like, less what spheroids take; they are built where `takes`.
  std::optional<LightMap> lightOf(std::size_t index, bool builds)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    if (!usesImages(component))
    {
      return std::nullopt;
    }
    StageSeconds& seconds = this->report.components[index].seconds;
    this->report.components[index].dark = countPixels(this->input, component);
    this->store.prepare(component);
    seconds.images += this->proceed();
    double beyond = 0;
    std::optional<LightMap> map =
      this->store.lightOf(component, this->outerRadius(component), builds ? &beyond : nullptr);
    this->report.components[index].images = this->store.reportOf(component);
    seconds.light += this->proceed();
    std::optional<double> light; // before any is taken
    for (std::size_t k = 0; k < this->galaxy.components.size(); ++k)
    {
      const ComponentDescription& spheroid = this->galaxy.components[k];
      if (spheroid.type == ComponentType::Spheroid && spheroid.spheroid.lightFrom == component.name)
      {
        const std::size_t before = this->particles.size();
        light = light ? light : map->fluxOn(this->inverseOf(component));
        this->appendSpheroid(k, &*map, *light);
        if (!builds)
        {
          resizeParticles(this->particles, before, this->options.velocities);
        }
      }
    }
    this->report.components[index].flux = (map->totalFlux() + beyond) * lightFactor(component);
    return map;
  }

  Seeds sample(std::size_t index, std::optional<LightMap>& map)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    ComponentReport& done = this->report.components[index];
    double seedCount = static_cast<double>(component.particles);
    if (component.automaticCount && map)
    {
      const double beam =
        std::max({ this->store.beamOf(component), map->pixelSide(), this->options.viewPixel });
      const DiskInverse inverse = this->inverseOf(component);
      const double area = component.sampling == SeedSampling::ImageDriven
        ? effectiveArea(*map, inverse)
        : SurfaceDraws(
            this->disk, std::max(0.0, component.innerRadius), this->outerRadius(component))
            .skyArea();
      seedCount = automaticCount(area, beam, component.noise);
    }
    const std::size_t count = this->scaled(component, seedCount);
    if (map && component.normalizeAt != NormalizeAt::None)
    {
      const DiskInverse inverse = this->inverseOf(component);
      while (map->litPixels(inverse) > std::max<std::size_t>(1, count))
      {
        map->halve();
      }
      done.bins = map->bins();
    }
    Seeds seeds = sampleSeeds(
      this->disk, component, map ? &*map : nullptr, this->keyOf(index), count, this->galaxy.file);
    done.seedsDrawn = seeds.drawn;
    done.seedsKept = seeds.size();
    done.seconds.seeds += this->proceed();
    return seeds;
  }

  void appendDisk(std::size_t index)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    ComponentReport& done = this->report.components[index];
    done.name = component.name;
    std::optional<LightMap> map = this->lightOf(index, true);
    const std::size_t first = this->particles.size();
    Seeds seeds = this->sample(index, map);
    this->placeDisk(index, seeds);
    done.seconds.thickness += this->proceed();
    // As thick as they will be drawn before the pixels are looked at from Earth.
    this->smooth(index, first);
    DrawnLayer layer = this->drawnLayer(index);
    layer.settle(this->particles, first, this->particles.size());
    done.seconds.smoothing += this->proceed();
    if (map && component.normalizeAt == NormalizeAt::Child && seeds.drawn > 0)
    {
      this->normalize(index, *map, first, layer);
    }
    done.seconds.photometry += this->proceed();
    const std::size_t last = this->particles.size();
    done.light = blockSum(this->particles.intensity, first, last);
    done.layer = layer.heights(this->particles, first, last);
    this->showDiskToEarth(first);
    this->summarize(index, first);
  }

  DrawnLayer drawnLayer(std::size_t index) const
  {
    const ComponentDescription& component = this->galaxy.components[index];
    return { this->disk, component, std::max(0.0, component.innerRadius),
      this->outerRadius(component) };
  }

  void placeDisk(std::size_t index, const Seeds& seeds)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    const RandomKey key = this->keyOf(index);
    const std::size_t first = this->particles.size();
    if (component.hasDust)
    {
      requireStableFilaments(seeds, this->disk, component, this->galaxy.file);
    }
    const ParticleStarts starts = component.hasDust
      ? countFilaments(seeds, this->disk, component, key)
      : countChildren(seeds, this->disk, component, key, this->galaxy.file);
    addParticles(
      starts[seeds.size()], this->options, this->galaxy.file, component, this->particles);
    const ParticleWriter writer = this->writerOf(index, first);
    const auto place = component.hasDust ? placeFilaments : placeChildren;
    place(seeds, starts, this->disk, component, key, lightFactor(component), writer);
  }

  void normalize(std::size_t index, const LightMap& map, std::size_t first, const DrawnLayer& layer)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    const std::size_t placed = this->particles.size();
    const double typical = placed > first
      ? blockSum(this->particles.intensity, first, placed) / static_cast<double>(placed - first)
      : 1;
    Photometry photometry(map, typical);
    photometry.weigh(this->particles, first, placed);
    const DiskInverse inverse = this->inverseOf(component);
    const std::vector<std::uint32_t> uncovered = photometry.uncovered(inverse);
    addParticles(uncovered.size(), this->options, this->galaxy.file, component, this->particles);
    fillPixels(uncovered, map, this->disk, inverse, layer.layer(), component.velocityDispersion,
      this->keyOf(index), static_cast<float>(typical), this->writerOf(index, placed));
    photometry.weigh(this->particles, placed, this->particles.size());
    photometry.shine(this->particles, first, this->particles.size(), lightFactor(component));
    this->report.components[index].filled = uncovered.size();
    smoothAmongOthers(this->particles, first, placed, component.smoothing);
    layer.lower(this->particles, placed, this->particles.size());
  }

  ParticleWriter writerOf(std::size_t index, std::size_t first)
  {
    this->stage = this->presentStage();
    this->work = std::make_unique<WorkProgress>(this->stage);
    this->work->begin(1, this->particles.size() - first);
    return { this->particles, first, static_cast<std::uint8_t>(index), this->work.get() };
  }

  /// With a map, the spheroid takes its fraction of `light` from that.
  void appendSpheroid(std::size_t index, LightMap* map, double light)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    ComponentReport& done = this->report.components[index];
    done.name = component.name;
    const std::size_t first = this->particles.size();
    const std::size_t count = this->scaled(component, static_cast<double>(component.particles));
    addParticles(count, this->options, this->galaxy.file, component, this->particles);
    placeSpheroid(this->disk, component, this->keyOf(index), count, lightFactor(component),
      this->writerOf(index, first));
    if (component.spheroid.listed.empty())
    {
      const RadialProfile profile(component.spheroid);
      done.end = profile.end() * scaleOf(component.spheroid);
      done.beyond = profile.beyond();
    }
    done.seconds.thickness += this->proceed();
    if (map)
    {
      done.asked = count > 0 ? component.spheroid.lightFraction * light : 0;
      Photometry::takeLight(this->particles, first, first + count, done.asked, *map);
    }
    done.seconds.photometry += this->proceed();
    this->smooth(index, first);
    done.light = blockSum(this->particles.intensity, first, this->particles.size());
    if (map)
    {
      this->showToEarth(first);
    }
    this->summarize(index, first);
    done.seconds.smoothing += this->proceed();
  }

  void showDiskToEarth(std::size_t first)
  {
    if (hasDiskWithImages(this->galaxy))
    {
      this->showToEarth(first);
    }
  }

  /// What was placed as the images show it is moved to where it is seen so from Earth.
  void showToEarth(std::size_t first)
  {
    moveToSightLines(1000 * this->galaxy.distance, this->particles, first, this->particles.size());
  }

  void smooth(std::size_t index, std::size_t first)
  {
    const ComponentDescription& component = this->galaxy.components[index];
    const std::size_t last = this->particles.size();
    requireFinite(this->particles, first, last, this->galaxy.file, component.name);
    setSmoothingLengths(this->particles, first, last, component.smoothing, this->presentStage());
  }

  void summarize(std::size_t index, std::size_t first)
  {
    ComponentReport& done = this->report.components[index];
    const std::size_t last = this->particles.size();
    requireFiniteLengths(
      this->particles, first, last, this->galaxy.file, this->galaxy.components[index].name);
    done.particles = last - first;
    done.smoothingLength = done.particles > 0
      ? blockSum(this->particles.smoothingLength, first, last) / static_cast<double>(done.particles)
      : 0;
  }

  const Galaxy& input;
  const GalaxyDescription& galaxy;
  const BuildOptions& options;
  BuildReport& report;
  TiltedDisk disk;
  ImageStore store;
  Particles particles;
  Stopwatch watch;
  std::size_t components = 0; ///< to be built
  double stagesDone = 0;
  Progress stage;
  std::unique_ptr<WorkProgress> work; ///< of the stage, where it writes particles
};
} // namespace

Particles buildGalaxy(const Galaxy& input, const BuildOptions& options, BuildReport* report)
{
  BuildReport unread;
  return Builder(input, options, report ? *report : unread).build();
}

Seeds buildSeeds(const Galaxy& input, const std::string& componentName, const BuildOptions& options)
{
  BuildReport report;
  Builder builder(input, options, report);
  return builder.seedsOf(builder.indexOf(componentName));
}

Particles buildFromSeeds(const Galaxy& input, const std::string& componentName, const Seeds& seeds,
  const BuildOptions& options)
{
  BuildReport report;
  Builder builder(input, options, report);
  return builder.fromSeeds(builder.indexOf(componentName), seeds);
}
} // namespace galaxy
