#include "Filters/Model/Seeds.h"

#include "Filters/Model/BlockSum.h"
#include "Filters/Model/PixelDraws.h"
#include "Filters/Model/SineCosine.h"
#include "Filters/Model/SurfaceDraws.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
/// Draws of one unit of work.
constexpr std::size_t blockSize = 8192;
/// Of a random number that all seeds of a component share.
constexpr std::uint64_t common = ~0ULL;

Seeds planned(const TiltedDisk& disk, const ComponentDescription& component, std::size_t count,
  const std::string& file)
{
  Seeds seeds;
  seeds.drawn = count;
  seeds.innerRadius = std::max(0.0, component.innerRadius);
  seeds.outerRadius = outerRadiusOf(component, disk);
  if (!(seeds.outerRadius > seeds.innerRadius))
  {
    throw Error(file, component.name,
      "no part of the disc lies between inner_radius and outer_radius: the rings end at " +
        std::to_string(disk.lastRadius()) + " kpc");
  }
  if (count > std::numeric_limits<std::uint32_t>::max())
  {
    throw Error(file, component.name, "particles: more than 4294967295 seeds");
  }
  return seeds;
}

void resize(Seeds& seeds, std::size_t count)
{
  seeds.radius.resize(count);
  seeds.azimuth.resize(count);
  seeds.intensity.resize(count);
  seeds.light.resize(count);
  seeds.color.resize(3 * count);
  seeds.index.resize(count);
}

/// Everything of seed i but its light.
void setSeed(Seeds& seeds, std::size_t i, double r, double theta, double intensity,
  const std::uint8_t* color, std::size_t index)
{
  seeds.radius[i] = static_cast<float>(r);
  seeds.azimuth[i] = static_cast<float>(theta);
  seeds.intensity[i] = static_cast<float>(intensity);
  std::copy(color, color + 3, &seeds.color[3 * i]);
  seeds.index[i] = static_cast<std::uint32_t>(index);
}

// ---------------------------------------------------------------- in proportion to the light
class ImageDrivenSampler
{
public:
  ImageDrivenSampler(const TiltedDisk& disk, const ComponentDescription& component,
    const LightMap& map, const RandomKey& key, Seeds& seeds)
    : map(map)
    , key(key)
    , normalizes(component.normalizeAt != NormalizeAt::None)
    , seeds(seeds)
    , inverse(disk, seeds.innerRadius, seeds.outerRadius)
    , draws(map, this->inverse, seeds.drawn, Random(key, RandomStream::SeedPlace, common).uniform())
  {
    resize(seeds, this->draws.size() > 0 ? seeds.drawn : 0);
  }

  void sample()
  {
    const std::size_t blocks = (this->seeds.size() + blockSize - 1) / blockSize;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const std::size_t last = std::min(this->seeds.size(), (block + 1) * blockSize);
      std::size_t k = this->draws.pixelOfSeed(block * blockSize);
      while (this->draws.firstSeed(k) > block * blockSize)
      {
        --k;
      }
      std::size_t near = 0;
      for (std::size_t j = block * blockSize; j < last; ++k)
      {
        j = this->samplePixel(k, j, last, near);
      }
    }
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
      this->seeds.light[j] = light;
    }
    return j;
  }

  /// So far from the pixel's edge that single precision cannot carry a seed over it.
  static double inset(double u)
  {
    return 0.002 + 0.996 * u;
  }

  void place(std::size_t j, std::uint32_t pixel, double u, double v, std::size_t& near)
  {
    DiskInverse::Sheets sheets;
    PixelPosition at = this->map.pointIn(pixel, u, v);
    int found = this->inverse.find(at.x, at.y, sheets, near);
    if (found == 0)
    {
      // At the disc's edge: the middle of the pixel does show it.
      at = this->map.pointIn(pixel, 0.5, 0.5);
      found = this->inverse.find(at.x, at.y, sheets, near);
    }
    const DiskSheet& sheet = sheets[found > 1 ? this->choose(j, sheets, found) : 0];
    // In single precision, as it is kept.
    const float azimuth =
      std::atan2(static_cast<float>(sheet.sinTheta), static_cast<float>(sheet.cosTheta));
    setSeed(
      this->seeds, j, sheet.r, azimuth, this->map.intensity(pixel), this->map.color(pixel), j);
  }

  int choose(std::size_t j, const DiskInverse::Sheets& sheets, int found) const
  {
    double left = Random(this->key, RandomStream::SeedSheet, j).uniform();
    int k = 0;
    for (; k + 1 < found && left >= sheets[k].share; ++k)
    {
      left -= sheets[k].share;
    }
    return k;
  }

  const LightMap& map;
  RandomKey key;
  bool normalizes;
  Seeds& seeds;
  DiskInverse inverse;
  PixelDraws draws;
};

// ---------------------------------------------------------------- evenly over the surface
/// The draws that fall on light, in their order, with the pixel of each.
std::vector<std::uint32_t> sampleSurface(const TiltedDisk& disk, const LightMap& map,
  const SurfaceDraws& surface, const RandomKey& key, Seeds& seeds)
{
  struct Kept
  {
    SurfaceDraws::Point point;
    std::uint32_t index;
    std::uint32_t pixel;
  };
  std::vector<std::vector<Kept>> blocks((seeds.drawn + blockSize - 1) / blockSize);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    const std::size_t last = std::min(seeds.drawn, (block + 1) * blockSize);
    for (std::size_t j = block * blockSize; j < last; ++j)
    {
      const SurfaceDraws::Point point = surface.draw(key, j, seeds.drawn);
      // As the seed will have it in single precision.
      const Vec3 p = disk.position(static_cast<float>(point.r), static_cast<float>(point.theta));
      const std::uint32_t pixel = map.pixelAt(static_cast<float>(p.x), static_cast<float>(p.y));
      if (pixel != LightMap::nowhere && map.flux(pixel) > 0)
      {
        blocks[block].push_back({ point, static_cast<std::uint32_t>(j), pixel });
      }
    }
  }
  std::vector<std::size_t> starts(blocks.size() + 1, 0);
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    starts[block + 1] = starts[block] + blocks[block].size();
  }
  resize(seeds, starts.back());
  std::vector<std::uint32_t> pixels(starts.back());
#pragma omp parallel for schedule(static)
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    std::size_t i = starts[block];
    for (const Kept& kept : blocks[block])
    {
      setSeed(seeds, i, kept.point.r, kept.point.theta, map.intensity(kept.pixel),
        map.color(kept.pixel), kept.index);
      pixels[i++] = kept.pixel;
    }
    blocks[block] = {};
  }
  return pixels;
}

void lightSurface(const LightMap& map, const std::vector<std::uint32_t>& pixels, bool normalizes,
  double areaPerDraw, Seeds& seeds)
{
  std::vector<std::uint32_t> counts(map.size(), 0);
  for (const std::uint32_t pixel : pixels)
  {
    ++counts[pixel];
  }
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const double light = normalizes ? static_cast<double>(map.flux(pixels[i])) / counts[pixels[i]]
                                    : map.intensity(pixels[i]) * areaPerDraw;
    seeds.light[i] = static_cast<float>(light);
  }
}

// ---------------------------------------------------------------- without an image
/// The light of exp(-r/h) within a radius, over 2 pi h^2: 1 - (1 + x) exp(-x) by its stable form.
double enclosedLight(double x)
{
  return -std::expm1(-x) - x * std::exp(-x);
}

/// The radius within which the fraction u of the light between two radii lies, by bisection to the
/// last bit.
double exponentialRadius(double u, double inner, double outer, double h)
{
  const double low = enclosedLight(inner / h), high = enclosedLight(outer / h);
  const double wanted = low + u * (high - low);
  double left = inner, right = outer;
  for (double middle = 0.5 * (left + right); middle > left && middle < right;
       middle = 0.5 * (left + right))
  {
    (enclosedLight(middle / h) < wanted ? left : right) = middle;
  }
  return 0.5 * (left + right);
}

void sampleExponential(
  const TiltedDisk& disk, const ComponentDescription& component, const RandomKey& key, Seeds& seeds)
{
  const double h = component.scaleLength;
  const ShownColor shown = shownColor(component.color);
  const double brightest = component.role == ComponentRole::Absorbs ? 1 : shown.intensity;
  const bool byLight = component.sampling == SeedSampling::ImageDriven;
  const SurfaceDraws surface(disk, seeds.innerRadius, seeds.outerRadius);
  resize(seeds, brightest > 0 ? seeds.drawn : 0);
#pragma omp parallel for schedule(static)
  for (std::size_t j = 0; j < seeds.size(); ++j)
  {
    SurfaceDraws::Point point;
    if (byLight)
    {
      Random random(key, RandomStream::SeedPlace, j);
      const double u = (j + random.uniform()) / seeds.drawn;
      point = { exponentialRadius(u, seeds.innerRadius, seeds.outerRadius, h),
        2 * pi * random.uniform() };
    }
    else
    {
      point = surface.draw(key, j, seeds.drawn);
    }
    const double intensity = brightest * std::exp(-point.r / h);
    setSeed(seeds, j, point.r, point.theta, intensity, shown.ratios.data(), j);
    seeds.light[j] = byLight ? 1.0F : static_cast<float>(intensity);
  }
  const double total = 2 * pi * h * h * brightest *
    (enclosedLight(seeds.outerRadius / h) - enclosedLight(seeds.innerRadius / h));
  const double weights = blockSum(seeds.light, 0, seeds.size());
  const double factor = component.normalizeAt == NormalizeAt::None && !byLight
    ? surface.area() / static_cast<double>(seeds.drawn)
    : total / weights;
  for (float& light : seeds.light)
  {
    light = static_cast<float>(factor * light);
  }
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
  Seeds seeds = planned(disk, component, count, file);
  if (!map)
  {
    sampleExponential(disk, component, key, seeds);
  }
  else if (component.sampling == SeedSampling::ImageDriven)
  {
    ImageDrivenSampler(disk, component, *map, key, seeds).sample();
  }
  else
  {
    const SurfaceDraws surface(disk, seeds.innerRadius, seeds.outerRadius);
    const std::vector<std::uint32_t> pixels = sampleSurface(disk, *map, surface, key, seeds);
    lightSurface(*map, pixels, component.normalizeAt != NormalizeAt::None,
      surface.area() / static_cast<double>(std::max<std::size_t>(1, count)), seeds);
  }
  return seeds;
}
} // namespace galaxy
