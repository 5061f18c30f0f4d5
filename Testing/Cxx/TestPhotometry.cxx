#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Photometry.h"
#include "Filters/Model/PixelFill.h"
#include "Filters/Model/Random.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

namespace galaxy
{
namespace
{
double brightness(double x, double y)
{
  return 0.1 + 0.9 * std::exp(-std::hypot(x, y) / 5);
}

/// Particles strewn over the sky, their weights from 0 to 2.
Particles strewn(std::size_t count, double side)
{
  Particles particles = allocateParticles(count, false);
  for (std::size_t i = 0; i < count; ++i)
  {
    Random random({}, RandomStream::ChildPlace, i);
    particles.position[3 * i] = static_cast<float>(side * (random.uniform() - 0.5));
    particles.position[3 * i + 1] = static_cast<float>(side * (random.uniform() - 0.5));
    particles.position[3 * i + 2] = 0;
    particles.intensity[i] = static_cast<float>(2 * random.uniform());
  }
  std::fill(particles.color.begin(), particles.color.end(), 7);
  return particles;
}
} // namespace

TEST(Photometry, GivesEveryPixelItsFlux)
{
  const LightMap map = lightMap(50, brightness, 40);
  Particles particles = strewn(60000, 52 * 40 * m83Kpc);
  Photometry photometry(map, 1);
  photometry.weigh(particles, 0, particles.size());
  std::vector<double> exact(map.size(), 0), stored(map.size(), 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const std::uint32_t pixel = photometry.pixelOf(particles, i);
    if (pixel != LightMap::nowhere)
    {
      exact[pixel] += photometry.light(pixel, particles.intensity[i]);
    }
  }
  Particles lit = strewn(60000, 52 * 40 * m83Kpc);
  photometry.shine(lit, 0, lit.size(), 1);
  int off = 0;
  for (std::size_t i = 0; i < lit.size(); ++i)
  {
    const std::uint32_t pixel = photometry.pixelOf(lit, i);
    if (pixel == LightMap::nowhere || map.flux(pixel) == 0)
    {
      ++off;
      EXPECT_EQ(lit.intensity[i], 0);
    }
    else
    {
      stored[pixel] += lit.intensity[i];
      EXPECT_EQ(lit.color[3 * i], 255);
    }
  }
  EXPECT_GT(off, 1000); // strewn wider than the image
  int covered = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    if (map.flux(pixel) > 0)
    {
      ++covered;
      ASSERT_NEAR(exact[pixel] / map.flux(pixel), 1, 1e-12);
      ASSERT_NEAR(stored[pixel] / map.flux(pixel), 1, 1e-6);
    }
  }
  EXPECT_EQ(covered, 2500);
}

TEST(Photometry, DependsOnNeitherOrderNorThreads)
{
  const LightMap map = lightMap(50, brightness, 40);
  Particles particles = strewn(30000, 50 * 40 * m83Kpc);
  const auto lit = [&map](const Particles& unlit, int threads) {
    omp_set_num_threads(threads);
    Particles particles = allocateParticles(unlit.size(), false);
    std::copy(unlit.position.begin(), unlit.position.end(), particles.position.begin());
    std::copy(unlit.intensity.begin(), unlit.intensity.end(), particles.intensity.begin());
    Photometry photometry(map, 1);
    photometry.weigh(particles, 0, particles.size());
    photometry.shine(particles, 0, particles.size(), 1);
    return particles;
  };
  const Particles one = lit(particles, 1);
  EXPECT_TRUE(equalBits(one.intensity, lit(particles, 2).intensity));
  EXPECT_TRUE(equalBits(one.intensity, lit(particles, 16).intensity));
  Particles turned = allocateParticles(particles.size(), false);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const std::size_t k = particles.size() - 1 - i;
    std::copy_n(&particles.position[3 * k], 3, &turned.position[3 * i]);
    turned.intensity[i] = particles.intensity[k];
  }
  Particles other = lit(turned, 2);
  std::reverse(other.intensity.begin(), other.intensity.end());
  EXPECT_TRUE(equalBits(one.intensity, other.intensity));
}

TEST(Photometry, FindsThePixelsThatNothingFellOn)
{
  const LightMap map = lightMap(
    50, [](double x, double y) { return x > -10 ? brightness(x, y) : 0; }, 40);
  const TiltedDisk disk(flatDisk(15, 50, 30), m83Distance);
  const DiskInverse inverse(disk, 0, 15);
  Particles particles = strewn(3000, 50 * 40 * m83Kpc);
  Photometry photometry(map, 1);
  photometry.weigh(particles, 0, particles.size());
  const std::vector<std::uint32_t> uncovered = photometry.uncovered(inverse);
  EXPECT_GT(uncovered.size(), 20u);
  Particles filling = allocateParticles(uncovered.size(), true);
  const VerticalLayer layer = { LayerLaw::Sech2, [](double) { return 0.3; } };
  fillPixels(uncovered, map, disk, inverse, layer, 0, {}, 1, { filling, 0, 0 });
  double squares = 0;
  for (std::size_t i = 0; i < uncovered.size(); ++i)
  {
    EXPECT_EQ(photometry.pixelOf(filling, i), uncovered[i]);
    EXPECT_EQ(filling.intensity[i], 1);
    const float* p = &filling.position[3 * i];
    const double z = dot({ p[0], p[1], p[2] }, disk.frame(0).n);
    squares += z * z;
  }
  // They have the layer's thickness too.
  EXPECT_NEAR(std::sqrt(squares / uncovered.size()), 0.3 * pi / std::sqrt(12), 0.15);
  photometry.weigh(filling, 0, filling.size());
  EXPECT_TRUE(photometry.uncovered(inverse).empty());
}

TEST(Photometry, TakesLightFromPixelsOnlyOnce)
{
  LightMap map = lightMap(50, brightness, 40);
  const LightMap before = map;
  Particles particles = strewn(20000, 10);
  // A third of the particles' pixels cannot give an even share.
  const double wanted = 0.0021 * 20000;
  Photometry::takeLight(particles, 0, particles.size(), wanted, map);
  const Photometry photometry(map, 1);
  std::vector<double> taken(map.size(), 0);
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    EXPECT_LE(particles.intensity[i], static_cast<float>(2 * wanted / 20000));
    sum += particles.intensity[i];
    taken[photometry.pixelOf(particles, i)] += particles.intensity[i];
  }
  EXPECT_NEAR(sum / wanted, 1, 1e-6);
  int emptied = 0, left = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    EXPECT_GE(map.flux(pixel), 0);
    EXPECT_NEAR(map.flux(pixel) + taken[pixel], before.flux(pixel), 1e-6 * before.flux(pixel));
    emptied += map.flux(pixel) < 1e-6 * before.flux(pixel);
    left += taken[pixel] > 0 && map.flux(pixel) > 0.01 * before.flux(pixel);
  }
  EXPECT_GT(emptied, 5);
  EXPECT_GT(left, 10);
}
} // namespace galaxy
