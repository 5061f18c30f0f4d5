#include "Filters/Model/Seeds.h"

#include "Filters/Model/ExponentialSeeds.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/PixelDraws.h"
#include "Filters/Model/SeedArrays.h"
#include "Filters/Model/SheetsInPixel.h"
#include "Filters/Model/SurfaceDraws.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// Draws of one unit of work.
constexpr std::size_t blockSize = 8192;
/// Of a random number that all seeds of a component share.
constexpr std::uint64_t common = ~0ULL;

Seeds planned(const TiltedDisk& disk, const ComponentDescription& component, std::size_t count,
  const DrawRange& range, const std::string& file)
{
  Seeds seeds;
  seeds.drawn = count;
  seeds.innerRadius = std::max(0.0, component.innerRadius);
  seeds.outerRadius = outerRadiusOf(component, disk);
  if (!(seeds.outerRadius > seeds.innerRadius))
  {
    throw Error(file, component.name,
      "inner_radius must be less than outer_radius and than the last ring's " +
        std::to_string(disk.lastRadius()) + " kpc");
  }
  if (range.first > range.last || range.last > count)
  {
    throw Error(file, component.name, "the range of draws must be among the component's draws");
  }
  if (count > std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(
      file, component.name, "particles must be no more than 4294967295 times ParticleScale");
  }
  return seeds;
}

// ---------------------------------------------------------------- in proportion to the light
class ImageDrivenSampler
{
public:
  ImageDrivenSampler(const TiltedDisk& disk, const ComponentDescription& component,
    const LightMap& map, const RandomKey& key, const DrawRange& range, Seeds& seeds)
    : map(map)
    , key(key)
    , range(range)
    , normalizes(component.normalizeAt != NormalizeAt::None)
    , seeds(seeds)
    , inverse(disk, seeds.innerRadius, seeds.outerRadius)
    , draws(map, this->inverse, seeds.drawn, Random(key, RandomStream::SeedPlace, common).uniform())
  {
    resizeSeeds(seeds, this->draws.size() > 0 ? range.size() : 0);
  }

  void sample()
  {
    const std::size_t blocks = (this->seeds.size() + blockSize - 1) / blockSize;
    parallelForDynamic<std::size_t>(0, blocks, 1, [&](std::size_t block) {
      const std::size_t first = this->range.first + block * blockSize;
      const std::size_t last = std::min(this->range.last, first + blockSize);
      std::size_t k = this->draws.pixelOfSeed(first);
      while (this->draws.firstSeed(k) > first)
      {
        --k;
      }
      std::size_t near = 0;
      for (std::size_t j = first; j < last; ++k)
      {
        j = this->samplePixel(k, j, last, near);
      }
    });
  }

private:
  /// Seeds j and on as far as they are pixel k's and below `last`; the first it leaves.
  std::size_t samplePixel(std::size_t k, std::size_t j, std::size_t last, std::size_t& near)
  {
    // The plane's golden ratio, the real root of x^3 = x + 1, and its square.
    constexpr double stepU = 0.7548776662466927, stepV = 0.5698402909980532;
    const std::size_t first = this->draws.firstSeed(k), end = this->draws.firstSeed(k + 1);
    if (j >= end)
    {
      return j;
    }
    const std::uint32_t pixel = this->draws.pixel(k);
    Random random(this->key, RandomStream::SeedPlace, pixel);
    const double u = random.uniform(), v = random.uniform();
    const double share =
      this->normalizes ? static_cast<double>(end - first) : this->draws.expected(k);
    const auto light = static_cast<float>(this->map.flux(pixel) / share);
    for (; j < std::min(end, last); ++j)
    {
      const double turn = static_cast<double>(j - first);
      const double across = u + stepU * turn, along = v + stepV * turn;
      this->place(
        j, pixel, inset(across - std::floor(across)), inset(along - std::floor(along)), near);
      this->seeds.light[j - this->range.first] = light;
    }
    return j;
  }

  /// So far from the pixel's edge that single precision cannot carry a seed over it.
  static double inset(double u) { return 0.002 + 0.996 * u; }

  void place(std::size_t j, std::uint32_t pixel, double u, double v, std::size_t& near)
  {
    SeenSheets seen;
    findInPixel(this->map, this->inverse, pixel, u, v, near, seen);
    const bool isFold = seen.count > 1;
    const DiskSheet& sheet =
      seen.byShare(isFold ? Random(this->key, RandomStream::SeedSheet, j).uniform() : 0);
    const double azimuth = std::atan2(sheet.sinTheta, sheet.cosTheta);
    setSeed(this->seeds, j - this->range.first, sheet.r, azimuth, this->map.intensity(pixel),
      this->map.color(pixel), j);
  }

  const LightMap& map;
  RandomKey key;
  DrawRange range;
  bool normalizes;
  Seeds& seeds;
  DiskInverse inverse;
  PixelDraws draws;
};

// ---------------------------------------------------------------- evenly over the surface
/// A draw that fell on light.
struct LitDraw
{
  SurfaceDraws::Point point;
  std::uint32_t index;
  std::uint32_t pixel;
};

/// All draws that fall on light, in their order by blocks.
std::vector<std::vector<LitDraw>> litDraws(const TiltedDisk& disk, const LightMap& map,
  const SurfaceDraws& surface, const RandomKey& key, std::size_t count)
{
  std::vector<std::vector<LitDraw>> blocks((count + blockSize - 1) / blockSize);
  parallelForDynamic<std::size_t>(0, blocks.size(), 1, [&](std::size_t block) {
    const std::size_t last = std::min(count, (block + 1) * blockSize);
    for (std::size_t j = block * blockSize; j < last; ++j)
    {
      const SurfaceDraws::Point point = surface.draw(key, j, count);
      // As the seed will have it in single precision.
      const Vec3 p = disk.position(static_cast<float>(point.r), static_cast<float>(point.theta));
      const std::uint32_t pixel = map.pixelAt(static_cast<float>(p.x), static_cast<float>(p.y));
      if (pixel != LightMap::nowhere && map.flux(pixel) > 0)
      {
        blocks[block].push_back({ point, static_cast<std::uint32_t>(j), pixel });
      }
    }
  });
  return blocks;
}

std::vector<std::uint32_t> countByPixel(
  const std::vector<std::vector<LitDraw>>& blocks, std::size_t pixels)
{
  std::vector<std::uint32_t> counts(pixels, 0);
  for (const std::vector<LitDraw>& block : blocks)
  {
    for (const LitDraw& draw : block)
    {
      ++counts[draw.pixel];
    }
  }
  return counts;
}

/// Where the draws of each block that lie in the range stand among the seeds.
std::vector<std::size_t> startsOf(
  const std::vector<std::vector<LitDraw>>& blocks, const DrawRange& range)
{
  std::vector<std::size_t> starts(blocks.size() + 1, 0);
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    starts[block + 1] = starts[block] +
      std::count_if(blocks[block].begin(), blocks[block].end(),
        [&range](const LitDraw& draw) { return range.holds(draw.index); });
  }
  return starts;
}

void sampleSurface(const TiltedDisk& disk, const ComponentDescription& component,
  const LightMap& map, const RandomKey& key, const DrawRange& range, Seeds& seeds)
{
  const SurfaceDraws surface(disk, seeds.innerRadius, seeds.outerRadius);
  const double skyPerDraw =
    surface.skyArea() / static_cast<double>(std::max<std::size_t>(1, seeds.drawn));
  const bool normalizes = component.normalizeAt != NormalizeAt::None;
  auto blocks = litDraws(disk, map, surface, key, seeds.drawn);
  // A pixel's flux is shared by all its draws, whoever has them.
  const std::vector<std::uint32_t> counts =
    normalizes ? countByPixel(blocks, map.size()) : std::vector<std::uint32_t>();
  const std::vector<std::size_t> starts = startsOf(blocks, range);
  resizeSeeds(seeds, starts.back());
  parallelFor<std::size_t>(0, blocks.size(), [&](std::size_t block) {
    std::size_t i = starts[block];
    for (const LitDraw& draw : blocks[block])
    {
      if (range.holds(draw.index))
      {
        setSeed(seeds, i, draw.point.r, draw.point.theta, map.intensity(draw.pixel),
          map.color(draw.pixel), draw.index);
        seeds.light[i++] = static_cast<float>(normalizes
            ? static_cast<double>(map.flux(draw.pixel)) / counts[draw.pixel]
            : map.intensity(draw.pixel) * skyPerDraw);
      }
    }
    blocks[block] = {};
  });
}

} // namespace

double outerRadiusOf(const ComponentDescription& component, const TiltedDisk& disk)
{
  const double outer = std::min(component.outerRadius, disk.outerRadius());
  return std::isfinite(outer) ? outer : disk.lastRadius();
}

Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const LightMap* map, const RandomKey& key, std::size_t count, const std::string& file)
{
  return sampleSeeds(disk, component, map, key, count, { 0, count }, file);
}

Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const LightMap* map, const RandomKey& key, std::size_t count, const DrawRange& range,
  const std::string& file)
{
  Seeds seeds = planned(disk, component, count, range, file);
  if (!map)
  {
    sampleExponential(disk, component, key, range, file, seeds);
  }
  else if (component.sampling == SeedSampling::ImageDriven)
  {
    ImageDrivenSampler(disk, component, *map, key, range, seeds).sample();
  }
  else
  {
    sampleSurface(disk, component, *map, key, range, seeds);
  }
  return seeds;
}
} // namespace galaxy
