#include "Filters/Model/SmoothingLength.h"
#include "Filters/Model/Spheroid.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace galaxy
{
namespace
{
Particles spheroid(const ComponentDescription& component, const TiltedDisk& disk, std::size_t count)
{
  Particles particles = allocateParticles(count, true);
  placeSpheroid(disk, component, {}, count, 1, ParticleWriter(particles, 0, 0, 0.1));
  return particles;
}

Vec3 at(const Buffer<float>& values, std::size_t i)
{
  return { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
}

/// A bulge of three different axes in a disc tilted about both angles.
ComponentDescription bulge()
{
  ComponentDescription component;
  component.type = ComponentType::Spheroid;
  component.spheroid.sigma = { 0.5, 0.3, 0.2 };
  component.spheroid.centralBrightness = 3;
  component.color = { 0.4, 0.8, 0.2 };
  return component;
}
} // namespace

TEST(Spheroid, MomentsLieAlongTheRing)
{
  const TiltedDisk disk(flatDisk(10, 50, 30), m83Distance);
  const std::size_t n = 200000;
  for (const bool tilted : { true, false })
  {
    ComponentDescription component = bulge();
    component.spheroid.tilted = tilted;
    const Particles particles = spheroid(component, disk, n);
    const RingFrame ring = disk.frame(0);
    const Vec3 axes[3] = { tilted ? ring.a : Vec3{ 1, 0, 0 }, tilted ? ring.b : Vec3{ 0, 1, 0 },
      tilted ? ring.n : Vec3{ 0, 0, 1 } };
    double moments[3][3] = {};
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vec3 p = at(particles.position, i);
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          moments[j][k] += dot(p, axes[j]) * dot(p, axes[k]) / n;
        }
      }
    }
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(std::sqrt(moments[j][j]) / component.spheroid.sigma[j], 1, 0.01);
      EXPECT_NEAR(moments[j][(j + 1) % 3], 0, 0.001);
    }
  }
}

TEST(Spheroid, LightGivesTheCentralBrightness)
{
  const TiltedDisk disk(flatDisk(10, 50, 30), m83Distance);
  const std::size_t n = 400000;
  const Particles particles = spheroid(bulge(), disk, n);
  const double total = std::accumulate(particles.intensity.begin(), particles.intensity.end(), 0.0);
  EXPECT_NEAR(total, 0.8 * 3 * 2 * pi * 0.5 * 0.3, 1e-5);
  // Seen along n, the light within 0.05 kpc of the centre over the area is the brightness there.
  const RingFrame ring = disk.frame(0);
  double central = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vec3 p = at(particles.position, i);
    central += std::hypot(dot(p, ring.a), dot(p, ring.b)) < 0.05 ? particles.intensity[i] : 0;
  }
  EXPECT_NEAR(central / (pi * 0.05 * 0.05), 0.8 * 3, 0.08);
  EXPECT_EQ(particles.color[0], 128);
  EXPECT_EQ(particles.color[1], 255);
  EXPECT_EQ(particles.color[2], 64);
  EXPECT_EQ(particles.velocity[5], 0);
}

TEST(Spheroid, SmoothingLengthFollowsTheDensity)
{
  const double volume = std::pow(4 * pi, 1.5) * 0.5 * 0.3 * 0.2;
  EXPECT_NEAR(spheroidSmoothingLength(bulge(), 5000), 1.5 * std::cbrt(volume / 5000), 1e-12);
}
} // namespace galaxy
