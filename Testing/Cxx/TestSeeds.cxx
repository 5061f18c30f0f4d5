#include "Filters/Model/PixelDraws.h"
#include "Filters/Model/Seeds.h"
#include "Filters/Model/SkyToDisk.h"
#include "Filters/Model/SurfaceDraws.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

namespace galaxy
{
namespace
{
ComponentDescription uniformComponent()
{
  ComponentDescription component;
  component.sampling = SeedSampling::SurfaceUniform;
  return component;
}

double brightness(double x, double y)
{
  return std::exp(-std::hypot(x, y) / 9) * (0.6 + 0.4 * std::cos(x) * std::sin(0.7 * y));
}

/// The light of the seeds on every pixel.
std::vector<double> lightByPixel(const Seeds& seeds, const TiltedDisk& disk, const LightMap& map)
{
  std::vector<double> light(map.size(), 0);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Vec3 p = disk.position(seeds.radius[i], seeds.azimuth[i]);
    light.at(map.pixelAt(static_cast<float>(p.x), static_cast<float>(p.y))) += seeds.light[i];
  }
  return light;
}

/// A fold: 40 degrees more of inclination and 60 of position angle between two rings, then flat.
TiltedDisk fold()
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 40, 0), ring(400, 100, 1, 40, 0), ring(600, 100, 1, 80, 60),
    ring(3000, 100, 1, 80, 60) };
  return TiltedDisk(table, m83Distance);
}

/// chi^2 of counts against expectations, less its mean, over its standard deviation.
double chiSquared(const std::vector<double>& counts, const std::vector<double>& expected)
{
  double sum = 0;
  for (std::size_t k = 0; k < counts.size(); ++k)
  {
    sum += (counts[k] - expected[k]) * (counts[k] - expected[k]) / expected[k];
  }
  const double freedom = static_cast<double>(counts.size()) - 1;
  return (sum - freedom) / std::sqrt(2 * freedom);
}
} // namespace

TEST(SurfaceUniformSeeds, HaveTheDensityOfTheWarpedSurface)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const double outer = disk.lastRadius();
  const SurfaceDraws surface(disk, 2, outer);
  // 40 ranges of radius by 8 of azimuth; their areas by the midpoint rule on the area element.
  const int radii = 40, azimuths = 8, fine = 40;
  const std::size_t count = 200000;
  std::vector<double> counts(radii * azimuths, 0), areas(radii * azimuths, 0);
  double area = 0;
  for (int u = 0; u < radii * fine; ++u)
  {
    for (int v = 0; v < azimuths * fine; ++v)
    {
      const double dr = (outer - 2) / (radii * fine), dTheta = 2 * pi / (azimuths * fine);
      const double element = disk.areaElement(2 + (u + 0.5) * dr, (v + 0.5) * dTheta) * dr * dTheta;
      areas[u / fine * azimuths + v / fine] += element;
      area += element;
    }
  }
  EXPECT_NEAR(surface.area() / area, 1, 1e-4); // the rule is crude where rings meet
  EXPECT_NEAR(area / (pi * (outer * outer - 4)), 1.218, 0.002); // M83's warp
  for (std::size_t i = 0; i < count; ++i)
  {
    const SurfaceDraws::Point point = surface.draw({}, i, count);
    const int u = static_cast<int>((point.r - 2) / (outer - 2) * radii);
    const int v = static_cast<int>(point.theta / (2 * pi) * azimuths);
    counts.at(u * azimuths + v) += 1;
  }
  std::vector<double> expected = areas;
  for (double& value : expected)
  {
    value *= count / area;
  }
  EXPECT_LT(chiSquared(counts, expected), 3);
  // A density in proportion to r alone does not pass.
  for (int u = 0; u < radii; ++u)
  {
    const double low = 2 + (outer - 2) * u / radii, high = 2 + (outer - 2) * (u + 1) / radii;
    for (int v = 0; v < azimuths; ++v)
    {
      expected[u * azimuths + v] =
        count * (high * high - low * low) / (outer * outer - 4) / azimuths;
    }
  }
  EXPECT_GT(chiSquared(counts, expected), 30);
}

TEST(SurfaceUniformSeeds, AreEvenerThanIndependentOnes)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  const SurfaceDraws surface(disk, 0, 10);
  std::vector<double> rings(50, 0);
  for (std::size_t i = 0; i < 50000; ++i)
  {
    const double r = surface.draw({}, i, 50000).r;
    rings[static_cast<int>(r * r / 2)] += 1;
  }
  // Independent ones would give chi^2 / 49 = 1, that is 0 here.
  EXPECT_LT(chiSquared(rings, std::vector<double>(50, 1000)), -4);
}

TEST(SurfaceUniformSeeds, CullDarkPixelsAndShareTheFluxOfTheOthers)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const LightMap map = lightMap(
    160, [](double x, double y) { return x > 0 ? brightness(x, y) : 0; }, 30);
  const Seeds seeds = sampleSeeds(disk, uniformComponent(), &map, {}, 200000, "");
  EXPECT_GT(seeds.size(), 60000u);
  EXPECT_LT(seeds.size(), 140000u);
  const std::vector<double> light = lightByPixel(seeds, disk, map);
  int covered = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    if (light[pixel] > 0)
    {
      ++covered;
      ASSERT_NEAR(light[pixel] / map.flux(pixel), 1, 1e-6);
    }
  }
  EXPECT_GT(covered, 4000);
}

TEST(SurfaceUniformSeeds, ThePapersRuleKeepsThePixelsIntensity)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const LightMap map = lightMap(160, brightness, 30);
  ComponentDescription component = uniformComponent();
  component.normalizeAt = NormalizeAt::None;
  const Seeds seeds = sampleSeeds(disk, component, &map, {}, 100000, "");
  const double perIntensity = seeds.light[0] / seeds.intensity[0];
  std::vector<double> gain(map.size(), 0);
  const std::vector<double> light = lightByPixel(seeds, disk, map);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    ASSERT_NEAR(seeds.light[i] / seeds.intensity[i] / perIntensity, 1, 1e-5);
  }
  // Its light scatters from pixel to pixel.
  double largest = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    largest = std::max(largest, map.flux(pixel) > 0 ? light[pixel] / map.flux(pixel) : 0);
  }
  EXPECT_GT(largest, 2);
}

TEST(ImageDrivenSeeds, ShareEveryPixelsFluxExactly)
{
  const TiltedDisk disk(m83Rings(), m83Distance, SpinSense::Clockwise);
  const LightMap map = lightMap(160, brightness, 30);
  const Seeds seeds = sampleSeeds(disk, {}, &map, {}, 120000, "");
  ASSERT_EQ(seeds.size(), 120000u); // none is culled
  const std::vector<double> light = lightByPixel(seeds, disk, map);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  int lit = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    const PixelPosition centre = map.pointIn(pixel, 0.5, 0.5);
    if (map.flux(pixel) > 0 && inverse.covers(centre.x, centre.y))
    {
      ++lit;
      ASSERT_NEAR(light[pixel] / map.flux(pixel), 1, 1e-6) << pixel;
    }
    else
    {
      ASSERT_EQ(light[pixel], 0) << pixel;
    }
  }
  EXPECT_GT(lit, 10000);
}

TEST(ImageDrivenSeeds, AreDrawnInProportionToTheLight)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  const LightMap map = lightMap(160, brightness, 30);
  // Fewer than two a pixel: in proportion, to within one.
  const PixelDraws few(map, inverse, 5000, 0.3);
  // More: beside one for every pixel.
  const PixelDraws many(map, inverse, 100000, 0.3);
  ASSERT_GT(few.size(), 10000u);
  double least = 1e300;
  for (std::size_t k = 0; k < few.size(); ++k)
  {
    const double drawn = static_cast<double>(few.firstSeed(k + 1) - few.firstSeed(k));
    ASSERT_LE(std::abs(drawn - few.expected(k)), 1 + 1e-9);
    ASSERT_NEAR(few.expected(k) / map.flux(few.pixel(k)), few.expected(0) / map.flux(few.pixel(0)),
      1e-6 * few.expected(0) / map.flux(few.pixel(0)));
    least = std::min(least, many.expected(k));
    ASSERT_GE(many.firstSeed(k + 1), many.firstSeed(k) + 1);
  }
  EXPECT_NEAR(least, 1, 1e-9);
  EXPECT_EQ(few.firstSeed(few.size()), 5000u);
  EXPECT_EQ(many.firstSeed(many.size()), 100000u);
  for (const std::size_t seed : { 0, 17, 4999 })
  {
    const std::size_t k = few.pixelOfSeed(seed);
    EXPECT_LE(few.firstSeed(k), seed);
    EXPECT_GT(few.firstSeed(k + 1), seed);
  }
}

TEST(ImageDrivenSeeds, FoldsShareTheirLightByArea)
{
  const TiltedDisk disk = fold();
  const LightMap map = lightMap(
    100, [](double, double) { return 1.0; }, 12);
  const Seeds seeds = sampleSeeds(disk, {}, &map, {}, 200000, "");
  // Beside a point that shows three sheets, the light of each.
  DiskInverse inverse(disk, 0, disk.lastRadius());
  EXPECT_FALSE(inverse.isSimple());
  DiskInverse::Sheets sheets;
  double x = 0, y = 0;
  for (x = 0.05; x < 13 && inverse.find(x, y, sheets) != 3; x += 0.1)
  {
    for (y = -13; y < 13 && inverse.find(x, y, sheets) != 3; y += 0.1)
    {
    }
    if (inverse.find(x, y, sheets) == 3)
    {
      break;
    }
  }
  ASSERT_EQ(inverse.find(x, y, sheets), 3);
  EXPECT_NEAR(sheets[0].share + sheets[1].share + sheets[2].share, 1, 1e-12);
  for (int k = 0; k < 3; ++k)
  {
    const double theta = std::atan2(sheets[k].sinTheta, sheets[k].cosTheta);
    const double perSky =
      disk.areaElement(sheets[k].r, theta) / disk.skyJacobian(sheets[k].r, theta);
    EXPECT_NEAR(sheets[k].share / sheets[0].share,
      perSky * disk.skyJacobian(sheets[0].r, std::atan2(sheets[0].sinTheta, sheets[0].cosTheta)) /
        disk.areaElement(sheets[0].r, std::atan2(sheets[0].sinTheta, sheets[0].cosTheta)),
      1e-6);
  }
  // All that is seen of the disc has the map's light, wherever it folds (hard case 17).
  const std::vector<double> light = lightByPixel(seeds, disk, map);
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    if (light[pixel] > 0)
    {
      ASSERT_NEAR(light[pixel] / map.flux(pixel), 1, 1e-6);
    }
  }
}

TEST(ImageDrivenSeeds, ShareSheetsAsUniformOnesDo)
{
  const TiltedDisk disk = fold();
  const LightMap map = lightMap(
    100, [](double, double) { return 1.0; }, 12);
  // Where three sheets are seen, the mean share of the nearest in radius.
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  const auto innermost = [&](SeedSampling sampling) {
    ComponentDescription component;
    component.sampling = sampling;
    const Seeds seeds = sampleSeeds(disk, component, &map, {}, 300000, "");
    double first = 0, all = 0;
    for (std::size_t i = 0; i < seeds.size(); ++i)
    {
      const Vec3 p = disk.position(seeds.radius[i], seeds.azimuth[i]);
      DiskInverse::Sheets sheets;
      if (inverse.find(p.x, p.y, sheets) == 3)
      {
        all += seeds.light[i];
        first += std::abs(sheets[0].r - seeds.radius[i]) < 1e-4 ? seeds.light[i] : 0;
      }
    }
    return first / all;
  };
  EXPECT_NEAR(innermost(SeedSampling::ImageDriven), innermost(SeedSampling::SurfaceUniform), 0.02);
}

TEST(Seeds, ExponentialDiscHasItsLightAndItsDensity)
{
  const TiltedDisk disk(flatDisk(30, 60), m83Distance);
  ComponentDescription component;
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 2;
  component.color = { 0.5, 0.25, 0 };
  const double whole = 0.5 * 2 * pi * 4 * (1 - 16 * std::exp(-15.0));
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    component.sampling = sampling;
    const Seeds seeds = sampleSeeds(disk, component, {}, {}, 40000, "");
    const double total = std::accumulate(seeds.light.begin(), seeds.light.end(), 0.0);
    EXPECT_NEAR(total / whole, 1, 1e-6);
    EXPECT_EQ(seeds.color[0], 255);
    EXPECT_EQ(seeds.color[1], 128);
    EXPECT_EQ(seeds.color[2], 0);
    const auto within = sampling == SeedSampling::ImageDriven
      ? std::function<double(double)>([](double r) { return 1 - (1 + r / 2) * std::exp(-r / 2); })
      : [](double r) { return r * r / 900; };
    EXPECT_LT(kolmogorov({ seeds.radius.begin(), seeds.radius.end() }, within), 1.95);
    EXPECT_LT(kolmogorov({ seeds.azimuth.begin(), seeds.azimuth.end() },
                [](double theta) { return theta / (2 * pi); }),
      1.95);
  }
}

TEST(Seeds, AreTheSameForAnyNumberOfThreads)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const LightMap map = lightMap(
    400, [](double x, double y) { return std::sin(x) + 0.1 * y; }, 12);
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    ComponentDescription component;
    component.sampling = sampling;
    const auto drawn = [&](int threads) {
      omp_set_num_threads(threads);
      return sampleSeeds(disk, component, &map, {}, 50000, "");
    };
    const Seeds one = drawn(1);
    EXPECT_GT(one.size(), 10000u);
    for (const int threads : { 2, 16 })
    {
      const Seeds many = drawn(threads);
      EXPECT_TRUE(equalBits(one.radius, many.radius));
      EXPECT_TRUE(equalBits(one.azimuth, many.azimuth));
      EXPECT_TRUE(equalBits(one.light, many.light));
      EXPECT_TRUE(equalBits(one.color, many.color));
      EXPECT_TRUE(equalBits(one.index, many.index));
    }
    EXPECT_TRUE(std::is_sorted(one.index.begin(), one.index.end()));
  }
}

TEST(Seeds, DarkOrMissingImagesLeaveNone)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  const LightMap blank = lightMap(
    50, [](double, double) { return std::nan(""); }, 10);
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    ComponentDescription component;
    component.sampling = sampling;
    EXPECT_EQ(sampleSeeds(disk, component, &blank, {}, 1000, "").size(), 0u);
    component.innerRadius = 20;
    EXPECT_THROW(sampleSeeds(disk, component, {}, {}, 10, "a.galaxy"), Error);
  }
}
} // namespace galaxy
