#ifndef galaxy_ThicknessFixtures_h
#define galaxy_ThicknessFixtures_h

#include "Filters/Model/Thickness.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <array>
#include <cmath>
#include <vector>

namespace galaxy
{
constexpr std::array<LayerLaw, 5> layerLaws = { LayerLaw::Gaussian, LayerLaw::Sech2,
  LayerLaw::Exponential, LayerLaw::Lorentzian, LayerLaw::Box };

/// Seeds at the given radii (kpc), their azimuths by the golden angle, all of intensity 1.
inline Seeds seedsAt(const std::vector<double>& radii)
{
  const std::size_t n = radii.size();
  Seeds seeds;
  seeds.radius = Buffer<float>(n);
  seeds.azimuth = Buffer<float>(n);
  seeds.intensity = Buffer<float>(n);
  seeds.light = Buffer<float>(n);
  seeds.color = Buffer<std::uint8_t>(3 * n);
  seeds.index = Buffer<std::uint32_t>(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    seeds.radius[i] = static_cast<float>(radii[i]);
    seeds.azimuth[i] = static_cast<float>(std::fmod(2.399963 * i, 2 * pi));
    seeds.intensity[i] = 1;
    seeds.light[i] = 0.5f + 0.001f * static_cast<float>(i % 1000);
    seeds.index[i] = static_cast<std::uint32_t>(3 * i + 1);
    for (int c = 0; c < 3; ++c)
    {
      seeds.color[3 * i + c] = static_cast<std::uint8_t>(i + 50 * c);
    }
    seeds.outerRadius = std::max(seeds.outerRadius, radii[i]);
  }
  seeds.drawn = n;
  return seeds;
}

/// `count` seeds uniform in area out to `outer` kpc.
inline Seeds seedsWithin(double outer, std::size_t count)
{
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i)
  {
    radii.push_back(outer * std::sqrt((i + 0.5) / count));
  }
  return seedsAt(radii);
}

/// Seeds, and the particles that a component's thickness makes of them.
struct ThickDisk
{
  ThickDisk(const RingTable& rings, const ComponentDescription& component, Seeds given,
    bool velocities = true)
    : disk(rings, m83Distance)
    , seeds(std::move(given))
    , starts(countChildren(this->seeds, this->disk, component, {}, "m.galaxy"))
    , particles(allocateParticles(this->starts[this->seeds.size()], velocities))
  {
    placeChildren(
      this->seeds, this->starts, this->disk, component, {}, 1, { this->particles, 0, 0 });
  }

  Vec3 position(std::size_t particle) const
  {
    const float* p = &this->particles.position[3 * particle];
    return { p[0], p[1], p[2] };
  }

  /// From the place of a seed to one of its children.
  Vec3 way(std::size_t seed, std::size_t particle) const
  {
    return this->position(particle) -
      this->disk.position(this->seeds.radius[seed], this->seeds.azimuth[seed]);
  }

  /// The heights of all particles over the plane of their seed's ring, in scale heights.
  std::vector<double> heights(double scaleHeight = 1) const
  {
    std::vector<double> heights;
    for (std::size_t i = 0; i < this->seeds.size(); ++i)
    {
      const Vec3 n = this->disk.frame(this->seeds.radius[i]).n;
      for (std::uint64_t k = this->starts[i]; k < this->starts[i + 1]; ++k)
      {
        heights.push_back(dot(this->way(i, k), n) / scaleHeight);
      }
    }
    return heights;
  }

  TiltedDisk disk;
  Seeds seeds;
  ParticleStarts starts;
  Particles particles;
};

/// A component whose children only leave the plane along its normal.
inline ComponentDescription verticalLayer(ThicknessModel model, double children)
{
  ComponentDescription component;
  component.name = "layer";
  component.thickness.model = model;
  component.thickness.sigma = 0;
  component.thickness.compression = 1;
  component.thickness.children = children;
  component.thickness.maximumChildren = 100000;
  return component;
}
} // namespace galaxy

#endif
