// The light of seeds in sum, whatever their number, and in parts of their range.
#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/PixelFill.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

namespace galaxy
{
namespace
{
double brightness(double x, double y)
{
  return std::exp(-std::hypot(x, y) / 3) * (0.6 + 0.4 * std::cos(x));
}

double lightOf(const Seeds& seeds)
{
  return std::accumulate(seeds.light.begin(), seeds.light.end(), 0.0);
}

double fluxOnDisk(const LightMap& map, const DiskInverse& inverse)
{
  double flux = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    flux += map.isLitOn(inverse, pixel) ? map.flux(pixel) : 0;
  }
  return flux;
}

template <typename T>
Buffer<T> joined(const Buffer<T>& p, const Buffer<T>& q)
{
  Buffer<T> all(p.size() + q.size());
  std::copy(q.begin(), q.end(), std::copy(p.begin(), p.end(), all.begin()));
  return all;
}
} // namespace

TEST(SeedLight, NoPixelGoesWithoutFromAsManySeedsAsPixelsOn)
{
  const TiltedDisk disk(flatDisk(8), m83Distance);
  const LightMap map = lightMap(60, brightness, 15);
  const DiskInverse inverse(disk, 0, 8);
  const std::size_t lit = map.litPixels(inverse);
  for (const std::size_t count : { lit, lit + 1, lit + lit / 3, 2 * lit - 1, 2 * lit, 5 * lit })
  {
    const Seeds seeds = sampleSeeds(disk, {}, &map, {}, count, "");
    EXPECT_EQ(seeds.size(), count);
    EXPECT_NEAR(lightOf(seeds) / fluxOnDisk(map, inverse), 1, 1e-6) << count;
  }
}

TEST(SeedLight, ThePapersRuleIsRightInSum)
{
  for (const double inclination : { 0.0, 60.0, 75.0 })
  {
    const TiltedDisk disk(flatDisk(12, inclination, 30), m83Distance);
    const LightMap map = lightMap(400, brightness, 4);
    const double flux = fluxOnDisk(map, DiskInverse(disk, 0, 12));
    for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
    {
      ComponentDescription component;
      component.sampling = sampling;
      component.normalizeAt = NormalizeAt::None;
      const Seeds seeds = sampleSeeds(disk, component, &map, {}, 200000, "");
      EXPECT_NEAR(lightOf(seeds) / flux, 1, 0.01) << inclination << " " << int(sampling);
    }
  }
}

TEST(SeedLight, SeedsOfTwoRangesAreThoseOfTheWhole)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const LightMap map = lightMap(200, brightness, 15);
  for (const bool hasImage : { true, false })
  {
    for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
    {
      ComponentDescription component;
      component.sampling = sampling;
      component.scaleLength = 3;
      const LightMap* light = hasImage ? &map : nullptr;
      const std::size_t count = 50000;
      const Seeds whole = sampleSeeds(disk, component, light, {}, count, "");
      for (const std::size_t cut : { std::size_t(0), std::size_t(1), std::size_t(20011), count })
      {
        const Seeds low = sampleSeeds(disk, component, light, {}, count, { 0, cut }, "");
        const Seeds high = sampleSeeds(disk, component, light, {}, count, { cut, count }, "");
        EXPECT_TRUE(equalBits(whole.radius, joined(low.radius, high.radius)));
        EXPECT_TRUE(equalBits(whole.azimuth, joined(low.azimuth, high.azimuth)));
        EXPECT_TRUE(equalBits(whole.light, joined(low.light, high.light)));
        EXPECT_TRUE(equalBits(whole.color, joined(low.color, high.color)));
        EXPECT_TRUE(equalBits(whole.index, joined(low.index, high.index)));
      }
      EXPECT_THROW(sampleSeeds(disk, component, light, {}, count, { 0, count + 1 }, ""), Error);
    }
  }
}

TEST(SeedLight, AHoleManyScaleLengthsWideKeepsWhatIsLeft)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  ComponentDescription component;
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 0.1;
  component.innerRadius = 6;
  const double left = 2 * pi * std::exp(-60.0) * 0.1 * (6 + 0.1);
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    component.sampling = sampling;
    component.scaleLength = 0.1;
    EXPECT_NEAR(lightOf(sampleSeeds(disk, component, {}, {}, 10000, "")) / left, 1, 1e-6);
    component.scaleLength = 0.05; // exp(-120) is none in single precision
    EXPECT_THROW(sampleSeeds(disk, component, {}, {}, 10000, "a.galaxy"), Error);
  }
}

TEST(SeedLight, NoTwoSeedsShareAPlaceAtTheDiscsEdge)
{
  const TiltedDisk disk(flatDisk(8, 80, 20), m83Distance);
  const LightMap map = lightMap(
    60, [](double, double) { return 1.0; }, 15);
  const Seeds seeds = sampleSeeds(disk, {}, &map, {}, 100000, "");
  std::map<std::pair<float, float>, int> places;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    ++places[{ seeds.radius[i], seeds.azimuth[i] }];
  }
  EXPECT_GT(places.size(), 0.99 * static_cast<double>(seeds.size()));
}

TEST(PixelFill, ChoosesAmongSheetsAndMovesAsItsComponentDoes)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 40, 0), ring(400, 100, 1, 40, 0), ring(600, 100, 1, 80, 60),
    ring(3000, 100, 1, 80, 60) };
  const TiltedDisk disk(table, m83Distance);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  const LightMap map = lightMap(
    200, [](double, double) { return 1.0; }, 6);
  std::vector<std::uint32_t> pixels;
  double expected = 0; // particles on the innermost of three sheets
  DiskInverse::Sheets sheets;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    const PixelPosition at = map.pointIn(pixel, 0.5, 0.5);
    if (inverse.find(at.x, at.y, sheets) == 3)
    {
      pixels.push_back(pixel);
      expected += sheets[0].share;
    }
  }
  ASSERT_GT(pixels.size(), 500u);
  Particles particles = allocateParticles(pixels.size(), true);
  const VerticalLayer flat{ LayerLaw::Gaussian, [](double) { return 0.0; } };
  fillPixels(pixels, map, disk, inverse, flat, 25, {}, 1, ParticleWriter(particles, 0, 0));
  double innermost = 0, squares = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const float* p = &particles.position[3 * i];
    const int found = inverse.find(p[0], p[1], sheets);
    const auto radius = std::hypot(p[0], p[1], p[2]);
    const auto* sheet = std::min_element(
      sheets.data(), sheets.data() + found, [radius](const DiskSheet& a, const DiskSheet& b) {
        return std::abs(a.r - radius) < std::abs(b.r - radius);
      });
    innermost += found == 3 && sheet == sheets.data();
    const Vec3 ofRing = ringVelocity(disk.frame(sheet->r), sheet->cosTheta, sheet->sinTheta);
    const float* v = &particles.velocity[3 * i];
    const Vec3 motion = Vec3{ v[0], v[1], v[2] } - ofRing;
    squares += dot(motion, motion);
  }
  const double n = static_cast<double>(pixels.size());
  EXPECT_NEAR(innermost / n, expected / n, 4 * std::sqrt(0.25 / n) + 0.02);
  EXPECT_NEAR(std::sqrt(squares / (3 * n)), 25, 4 * 25 / std::sqrt(6 * n));
}
} // namespace galaxy
