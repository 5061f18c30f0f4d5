#include "Filters/Model/Background.h"
#include "Filters/Model/ImageCleaning.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

namespace galaxy
{
namespace
{
const SkyFrame m83Frame(m83Centre, m83Distance);

SeedLayer layerOf(const SkyImage& image, const LayerDescription& description)
{
  return { &image, IntensityScale(description, image.values(), "test.galaxy"),
    description.threshold, description.weight, description.color };
}

LayerDescription clippedLayer()
{
  LayerDescription layer;
  layer.image = "picture";
  layer.clips = true;
  return layer;
}

SkyImage skyImage(int size, const std::function<double(double, double)>& f, double pixel)
{
  return SkyImage(skyPicture(size, f, pixel), pictureDescription("picture", pixel), m83Frame, 100);
}
} // namespace

TEST(SineCosine, AgreesWithTheLibrary)
{
  for (double x = -50000; x < 50000; x += 0.7310585)
  {
    const auto [sine, cosine] = sineCosine(x);
    ASSERT_NEAR(sine, std::sin(x), 3e-16) << x;
    ASSERT_NEAR(cosine, std::cos(x), 3e-16) << x;
  }
  EXPECT_EQ(sineCosine(0).sine, 0);
  EXPECT_EQ(sineCosine(0).cosine, 1);
}

TEST(Random, IsUniformNormalAndAPureFunction)
{
  std::vector<double> uniforms, normals;
  for (std::uint64_t particle = 0; particle < 20000; ++particle)
  {
    Random random({ 7, 3 }, RandomStream::SeedPlace, particle);
    uniforms.push_back(random.uniform());
    normals.push_back(random.normal());
    normals.push_back(random.normal());
  }
  EXPECT_LT(kolmogorov(uniforms, [](double u) { return u; }), 1.95);
  EXPECT_LT(
    kolmogorov(normals, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }), 1.95);
  EXPECT_EQ(Random({ 7, 3 }, RandomStream::SeedPlace, 5).uniform(), uniforms[5]);
  EXPECT_NE(Random({ 8, 3 }, RandomStream::SeedPlace, 5).uniform(), uniforms[5]);
  EXPECT_NE(Random({ 7, 4 }, RandomStream::SeedPlace, 5).uniform(), uniforms[5]);
  EXPECT_NE(Random({ 7, 3 }, RandomStream::ChildPlace, 5).uniform(), uniforms[5]);
}

TEST(SkyFrame, IsRightHandedAndInvertible)
{
  const auto& axes = m83Frame.axes();
  EXPECT_NEAR(length(cross(axes[0], axes[1]) - axes[2]), 0, 1e-15);
  EXPECT_NEAR(length(m83Frame.centre()), 4900, 1e-9);
  for (const double x : { -60.0, 0.0, 35.0 })
  {
    for (const double y : { -50.0, 10.0 })
    {
      double u, v;
      ASSERT_TRUE(m83Frame.skyToPlane(m83Frame.planeToSky(x, y), u, v));
      EXPECT_NEAR(u, x, 1e-9);
      EXPECT_NEAR(v, y, 1e-9);
    }
  }
  // East (larger right ascension) is -X, North +Y.
  double x, y;
  ASSERT_TRUE(m83Frame.skyToPlane({ m83Centre.ra + 0.01, m83Centre.dec }, x, y));
  EXPECT_NEAR(x, -4900 * 0.01 * degree * std::cos(m83Centre.dec * degree), 1e-6);
  ASSERT_TRUE(m83Frame.skyToPlane({ m83Centre.ra, m83Centre.dec + 0.01 }, x, y));
  EXPECT_NEAR(y, 4900 * std::tan(0.01 * degree), 1e-9);
  EXPECT_FALSE(m83Frame.skyToPlane({ m83Centre.ra + 180, -m83Centre.dec }, x, y));
}

TEST(SkyFrame, WorksAtThePoleAndAcrossZeroHours)
{
  for (const SkyPosition& centre : { SkyPosition{ 10, 89.999 }, SkyPosition{ 359.999, -5 } })
  {
    const SkyFrame frame(centre, 3);
    double x, y;
    ASSERT_TRUE(frame.skyToPlane(frame.planeToSky(-2, 1.5), x, y));
    EXPECT_NEAR(x, -2, 1e-9);
    EXPECT_NEAR(y, 1.5, 1e-9);
  }
}

TEST(SkyImage, LatticeFollowsTheWorldCoordinates)
{
  // A wide image about another point, turned and mirrored: the projections differ visibly.
  ImageDescription description = pictureDescription("picture", 20);
  description.coordinates.centre = { m83Centre.ra + 1, m83Centre.dec - 0.7 };
  description.coordinates.positionAngle = 33;
  description.coordinates.mirrored = true;
  const Image picture = skyPicture(
    801, [](double, double) { return 1.0; }, 20);
  const SkyImage image(picture, description, m83Frame, 200);
  int inside = 0;
  for (double x = -190; x < 190; x += 3.7)
  {
    for (double y = -190; y < 190; y += 4.3)
    {
      const PixelPosition near = image.pixelAt(x, y);
      const PixelPosition exact = image.exactPixelAt(x, y);
      if (exact.x > 0.5 && exact.x < 801.5 && exact.y > 0.5 && exact.y < 801.5)
      {
        ++inside;
        EXPECT_LT(std::hypot(near.x - exact.x, near.y - exact.y), 0.011);
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

TEST(SkyImage, PixelsLieWhereTheSkyIs)
{
  // Brighter to the West and, twice as much, to the North.
  const SkyImage image = skyImage(
    201, [](double x, double y) { return x + 2 * y; }, 10);
  const double pixel = 10 * m83Kpc;
  EXPECT_NEAR(image.value(0, 0), 0, 1e-9);
  EXPECT_NEAR(image.value(30 * pixel, 0), 30 * pixel, 1e-4);
  EXPECT_NEAR(image.value(0, 30 * pixel), 60 * pixel, 1e-4);
  EXPECT_NEAR(image.value(30.4 * pixel, -17.4 * pixel), (30 - 34) * pixel, 1e-4);
  EXPECT_FALSE(std::isnan(image.value(-100.4 * pixel, 0)));
  EXPECT_TRUE(std::isnan(image.value(-100.6 * pixel, 0)));
  EXPECT_TRUE(std::isnan(image.value(0, 500 * pixel)));
}

TEST(SkyImage, BackgroundAndStarsAreTakenOut)
{
  Image picture = skyPicture(
    100, [](double, double) { return 5.0; }, 10);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
  {
    picture.values[i] += 0.01 * ((i * 7919) % 101 - 50.0);
  }
  picture.values[3 * 100 + 3] = 1e6; // a star in the border
  picture.values[50 * 100 + 50] = 200;
  picture.values[20 * 100 + 99] = std::nan("");
  EXPECT_NEAR(borderBackground(picture), 5, 0.05);
  ImageDescription description = pictureDescription("picture", 10);
  description.automaticBackground = true;
  description.maskStarsAbove = 100;
  const std::vector<float> values = cleanedValues(picture, description);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i != 20 * 100 + 99)
    {
      EXPECT_LT(std::abs(values[i]), 0.56) << i;
    }
  }
  EXPECT_TRUE(std::isnan(values[20 * 100 + 99]));
  EXPECT_NEAR(values[10 * 100 + 70], picture.values[10 * 100 + 70] - 5, 0.06);
}

TEST(IntensityScale, ClampsAndStretches)
{
  LayerDescription layer = clippedLayer();
  layer.clip = { 10, 30 };
  const IntensityScale linear(layer, {}, "");
  EXPECT_EQ(linear(5), 0);
  EXPECT_EQ(linear(15), 0.25);
  EXPECT_EQ(linear(99), 1);
  EXPECT_EQ(linear(std::nan("")), 0);
  layer.stretch = IntensityStretch::Sqrt;
  EXPECT_EQ(IntensityScale(layer, {}, "")(15), 0.5);
  layer.stretch = IntensityStretch::Asinh;
  EXPECT_NEAR(IntensityScale(layer, {}, "")(15), std::asinh(2.5) / std::asinh(10.0), 1e-15);
  layer.clip = { 1, 1 };
  EXPECT_THROW(IntensityScale(layer, {}, ""), Error);

  layer.clips = false;
  layer.stretch = IntensityStretch::Linear;
  std::vector<float> values(2002, -1);
  std::iota(values.begin(), values.begin() + 1001, 0.0f);
  EXPECT_NEAR(IntensityScale(layer, values, "")(499.5), 0.5, 0.001);
  EXPECT_EQ(IntensityScale(layer, { -1, 0 }, "")(5), 0);
}

TEST(Seeds, FillTheDiscUniformly)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const SkyImage image = skyImage(
    600, [](double, double) { return 1.0; }, 10);
  ComponentDescription component;
  component.innerRadius = 4;
  component.outerRadius = 12;
  const Seeds seeds =
    sampleSeeds(disk, component, { layerOf(image, clippedLayer()) }, {}, 50000, "");
  ASSERT_EQ(seeds.size(), 50000u);
  EXPECT_LT(kolmogorov({ seeds.radius.begin(), seeds.radius.end() },
              [](double r) { return (r * r - 16) / (144 - 16); }),
    1.95);
  EXPECT_LT(kolmogorov({ seeds.azimuth.begin(), seeds.azimuth.end() },
              [](double theta) { return theta / (2 * pi); }),
    1.95);
}

TEST(Seeds, LightOfTheSkyIsTheImages)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const double pixel = 5;
  const SkyImage image = skyImage(
    1601,
    [](double x, double y) { return std::exp(-std::hypot(x, y) / 20) * (0.7 + 0.3 * std::cos(x)); },
    pixel);
  const Seeds seeds = sampleSeeds(disk, {}, { layerOf(image, clippedLayer()) }, {}, 300000, "");
  const int annuli = 9;
  const double width = 5; // kpc; the projected disc reaches farther than 45 everywhere
  std::vector<double> light(annuli), variance(annuli), expected(annuli);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Vec3 p = disk.position(seeds.radius[i], seeds.azimuth[i]);
    const auto annulus = static_cast<int>(std::hypot(p.x, p.y) / width);
    if (annulus < annuli)
    {
      light[annulus] += seeds.light[i];
      variance[annulus] += seeds.light[i] * seeds.light[i];
    }
  }
  const double step = pixel * m83Kpc;
  for (int row = 0; row < 1601; ++row)
  {
    for (int column = 0; column < 1601; ++column)
    {
      const auto annulus = static_cast<int>(step * std::hypot(column - 800, row - 800) / width);
      if (annulus < annuli)
      {
        expected[annulus] += image.values()[row * 1601 + column] * step * step;
      }
    }
  }
  for (int k = 0; k < annuli; ++k)
  {
    EXPECT_NEAR(light[k], expected[k], 4 * std::sqrt(variance[k]) + 0.003 * expected[k]) << k;
    EXPECT_LT(std::sqrt(variance[k]), 0.03 * expected[k]);
  }
}

TEST(Seeds, LightDoesNotDependOnTheirNumber)
{
  const TiltedDisk disk(flatDisk(10, 60), m83Distance);
  const SkyImage image = skyImage(
    600, [](double, double) { return 0.5; }, 10);
  for (const std::size_t count : { 1000, 40000 })
  {
    const Seeds seeds = sampleSeeds(disk, {}, { layerOf(image, clippedLayer()) }, {}, count, "");
    const double total = std::accumulate(seeds.light.begin(), seeds.light.end(), 0.0);
    // A flat disc's seeds weigh the same: no Monte-Carlo error is left.
    EXPECT_NEAR(total, 0.5 * pi * 100 * 0.5, 1e-4);
  }
}

TEST(Seeds, ExponentialDiscHasItsLight)
{
  const TiltedDisk disk(flatDisk(30, 60), m83Distance);
  ComponentDescription component;
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 2;
  component.color = { 0.5, 0.25, 0 };
  const Seeds seeds = sampleSeeds(disk, component, {}, {}, 400000, "");
  const double total = std::accumulate(seeds.light.begin(), seeds.light.end(), 0.0);
  EXPECT_NEAR(total / (0.5 * 2 * pi * 4), 1, 0.02);
  EXPECT_EQ(seeds.color[0], 255);
  EXPECT_EQ(seeds.color[1], 128);
  EXPECT_EQ(seeds.color[2], 0);
}

TEST(Seeds, LayersMixTheirColours)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  const SkyImage even = skyImage(
    600, [](double, double) { return 0.8; }, 10);
  const SkyImage west = skyImage(
    600, [](double x, double) { return x > 0 ? 0.4 : 0.1; }, 10);
  LayerDescription red = clippedLayer();
  red.color = { 1, 0, 0 };
  red.weight = 0.5;
  LayerDescription blue = clippedLayer();
  blue.color = { 0, 0, 1 };
  blue.weight = 2;
  blue.threshold = 0.2;
  const std::vector<SeedLayer> layers = { layerOf(even, red), layerOf(west, blue) };
  const Seeds seeds = sampleSeeds(disk, {}, layers, {}, 4000, "");
  ASSERT_EQ(seeds.size(), 4000u);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const double x = disk.position(seeds.radius[i], seeds.azimuth[i]).x;
    if (std::abs(x) > 0.2)
    {
      EXPECT_NEAR(seeds.intensity[i], x > 0 ? 0.8 : 0.4, 1e-6);
      EXPECT_EQ(seeds.color[3 * i], x > 0 ? 128 : 255);
      EXPECT_EQ(seeds.color[3 * i + 1], 0);
      EXPECT_EQ(seeds.color[3 * i + 2], x > 0 ? 255 : 0);
    }
  }
  // Only the second layer: its dark half is culled.
  const Seeds half = sampleSeeds(disk, {}, { layers[1] }, {}, 40000, "");
  EXPECT_EQ(half.drawn, 40000u);
  EXPECT_NEAR(half.size(), 20000, 600);
  // An absorber counts optical depth, not colour.
  ComponentDescription dust;
  dust.role = ComponentRole::Absorbs;
  LayerDescription black = clippedLayer();
  black.color = { 0, 0, 0 };
  const Seeds absorbers = sampleSeeds(disk, dust, { layerOf(even, black) }, {}, 10, "");
  ASSERT_EQ(absorbers.size(), 10u);
  EXPECT_NEAR(absorbers.intensity[0], 0.8, 1e-6);
}

TEST(Seeds, AreTheSameForAnyNumberOfThreads)
{
  const TiltedDisk disk(m83Rings(), m83Distance);
  const SkyImage image = skyImage(
    400, [](double x, double y) { return std::sin(x) + y; }, 12);
  const auto drawn = [&](int threads) {
    omp_set_num_threads(threads);
    return sampleSeeds(disk, {}, { layerOf(image, clippedLayer()) }, {}, 50000, "");
  };
  const Seeds one = drawn(1);
  EXPECT_GT(one.size(), 10000u);
  EXPECT_LT(one.size(), 45000u);
  for (const int threads : { 2, 5 })
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

TEST(Seeds, DarkOrMissingImagesLeaveNone)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  const SkyImage blank = skyImage(
    50, [](double, double) { return std::nan(""); }, 10);
  EXPECT_EQ(sampleSeeds(disk, {}, { layerOf(blank, clippedLayer()) }, {}, 1000, "").size(), 0u);
  ComponentDescription component;
  component.innerRadius = 20;
  EXPECT_THROW(sampleSeeds(disk, component, {}, {}, 10, "a.galaxy"), Error);
}
} // namespace galaxy
