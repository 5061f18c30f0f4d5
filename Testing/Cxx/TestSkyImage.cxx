#include "Filters/Model/Background.h"
#include "Filters/Model/ImageCleaning.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/SineCosine.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace galaxy
{
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
  EXPECT_NEAR(skyOf(picture).level, 5, 0.05);
  ImageDescription description = pictureDescription("picture", 10);
  description.automaticBackground = true;
  description.maskStarsAbove = 100;
  const std::vector<float> values = cleanedImage(picture, description).values;
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
} // namespace galaxy
