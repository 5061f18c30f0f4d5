#include "Filters/Model/Seeds.h"

#include "Filters/Model/SineCosine.h"
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

struct Seed
{
  float radius;
  float azimuth;
  float intensity;
  float light;
  std::array<std::uint8_t, 3> color;
  std::uint32_t index;
};

class SeedSampler
{
public:
  SeedSampler(const TiltedDisk& disk, const ComponentDescription& component,
    const std::vector<SeedLayer>& layers, const RandomKey& key, const Seeds& plan)
    : disk(disk)
    , component(component)
    , layers(layers)
    , key(key)
    , innerSquared(plan.innerRadius * plan.innerRadius)
    , squares(plan.outerRadius * plan.outerRadius - this->innerSquared)
    , areaPerDraw(plan.areaPerDraw())
  {
  }

  std::vector<Seed> sample(std::size_t first, std::size_t last) const
  {
    std::vector<Seed> kept;
    kept.reserve(last - first);
    for (std::size_t i = first; i < last; ++i)
    {
      Seed seed;
      seed.index = static_cast<std::uint32_t>(i);
      if (this->draw(seed))
      {
        kept.push_back(seed);
      }
    }
    return kept;
  }

private:
  bool draw(Seed& seed) const
  {
    Random random(this->key, RandomStream::SeedPlace, seed.index);
    const double r = std::sqrt(this->innerSquared + random.uniform() * this->squares);
    const double theta = 2 * pi * random.uniform();
    seed.radius = static_cast<float>(r);
    seed.azimuth = static_cast<float>(theta);
    if (this->component.profile == DiskProfile::Exponential)
    {
      return this->shine(
        seed, std::exp(-r / this->component.scaleLength), this->component.color, 1);
    }
    const RingFrame ring = this->disk.frame(r);
    const auto [sine, cosine] = sineCosine(theta);
    const Vec3 outward = cosine * ring.a + sine * ring.b;
    const double kappa = ring.bendA * cosine + ring.bendB * sine;
    // J_sky / (N pdf) = areaPerDraw J_sky / r.
    const double foreshortening = std::abs(ring.n.z + r * kappa * outward.z);

    double total = 0;
    Color color = { 0, 0, 0 };
    for (const SeedLayer& layer : this->layers)
    {
      const double intensity = layer.scale(layer.image->value(r * outward.x, r * outward.y));
      if (intensity >= layer.threshold)
      {
        total += layer.weight * intensity;
        for (int c = 0; c < 3; ++c)
        {
          color[c] += layer.weight * intensity * layer.color[c];
        }
      }
    }
    if (!(total > 0))
    {
      return false;
    }
    for (double& channel : color)
    {
      channel /= total;
    }
    return this->shine(seed, total, color, foreshortening);
  }

  bool shine(Seed& seed, double intensity, const Color& color, double foreshortening) const
  {
    const double largest = *std::max_element(color.begin(), color.end());
    const double shown =
      this->component.role == ComponentRole::Absorbs ? intensity : intensity * largest;
    seed.intensity = static_cast<float>(shown);
    seed.light = static_cast<float>(shown * this->areaPerDraw * foreshortening);
    for (int c = 0; c < 3; ++c)
    {
      const double ratio = largest > 0 ? color[c] / largest : 0;
      seed.color[c] = static_cast<std::uint8_t>(255 * std::clamp(ratio, 0.0, 1.0) + 0.5);
    }
    return shown > 0;
  }

  const TiltedDisk& disk;
  const ComponentDescription& component;
  const std::vector<SeedLayer>& layers;
  RandomKey key;
  double innerSquared;
  double squares;
  double areaPerDraw;
};

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

void gather(const std::vector<std::vector<Seed>>& blocks, Seeds& seeds)
{
  std::vector<std::size_t> starts(blocks.size() + 1, 0);
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    starts[k + 1] = starts[k] + blocks[k].size();
  }
  const std::size_t kept = starts.back();
  seeds.radius = Buffer<float>(kept);
  seeds.azimuth = Buffer<float>(kept);
  seeds.intensity = Buffer<float>(kept);
  seeds.light = Buffer<float>(kept);
  seeds.color = Buffer<std::uint8_t>(3 * kept);
  seeds.index = Buffer<std::uint32_t>(kept);
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    std::size_t i = starts[k];
    for (const Seed& seed : blocks[k])
    {
      seeds.radius[i] = seed.radius;
      seeds.azimuth[i] = seed.azimuth;
      seeds.intensity[i] = seed.intensity;
      seeds.light[i] = seed.light;
      std::copy(seed.color.begin(), seed.color.end(), &seeds.color[3 * i]);
      seeds.index[i] = seed.index;
      ++i;
    }
  }
}
} // namespace

double outerRadiusOf(const ComponentDescription& component, const TiltedDisk& disk)
{
  const double outer = std::min(component.outerRadius, disk.outerRadius());
  return std::isfinite(outer) ? outer : disk.lastRadius();
}

double Seeds::areaPerDraw() const
{
  const double area =
    pi * (this->outerRadius * this->outerRadius - this->innerRadius * this->innerRadius);
  return this->drawn > 0 ? area / this->drawn : 0;
}

Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const std::vector<SeedLayer>& layers, const RandomKey& key, std::size_t count,
  const std::string& file)
{
  Seeds seeds = planned(disk, component, count, file);
  const SeedSampler sampler(disk, component, layers, key, seeds);
  std::vector<std::vector<Seed>> blocks((count + blockSize - 1) / blockSize);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    blocks[k] = sampler.sample(k * blockSize, std::min(count, (k + 1) * blockSize));
  }
  gather(blocks, seeds);
  return seeds;
}
} // namespace galaxy
