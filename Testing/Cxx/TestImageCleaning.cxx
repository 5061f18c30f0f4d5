#include "Filters/Model/ImageCleaning.h"

#include "Filters/Model/Background.h"
#include "Filters/Model/ForegroundStars.h"
#include "Filters/Model/HoleFilling.h"
#include "Filters/Model/IntensityScale.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

namespace galaxy
{
namespace
{
/// A sky of level 100 and noise 5, with an exponential disc of `length` pixels, its shape `axes`,
/// and `stars` stars with Moffat wings.
Image syntheticSky(int size, double length, double axes, int stars)
{
  std::mt19937 random(11);
  std::normal_distribution<double> noise(100, 5);
  std::uniform_real_distribution<double> place(0, size), unit(0, 1);
  Image image;
  image.width = image.height = size;
  const double middle = 0.5 * (size - 1);
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double r = std::hypot(column - middle, (row - middle) / axes);
      image.values.push_back(noise(random) + 1000 * std::exp(-r / length));
    }
  }
  for (int k = 0; k < stars; ++k)
  {
    const double x = place(random), y = place(random), width = 1 + 1.5 * unit(random);
    const double peak = std::pow(10.0, 1 + 3 * unit(random));
    for (std::size_t i = 0; i < image.values.size(); ++i)
    {
      const double u = (i % size) - x, v = double(i / size) - y;
      image.values[i] += peak * std::pow(1 + (u * u + v * v) / (3 * width * width), -2.5);
    }
  }
  return image;
}

struct Sky
{
  int size;
  double gradient;
  std::vector<float> values;

  explicit Sky(int size, double gradient = 0)
    : size(size)
    , gradient(gradient)
  {
    for (int i = 0; i < size * size; ++i)
    {
      this->values.push_back(static_cast<float>(this->smooth(i % size, i / size)));
    }
  }
  double smooth(int x, int y) const { return 10 + this->gradient * (x + 0.5 * y); }
  float& at(int x, int y) { return this->values[y * this->size + x]; }

  template <typename Profile>
  void add(int x, int y, Profile profile)
  {
    for (int i = 0; i < this->size * this->size; ++i)
    {
      this->values[i] +=
        static_cast<float>(profile(std::hypot(i % this->size - x, i / this->size - y)));
    }
  }
};
} // namespace

TEST(Background, IsTheSkysUnderStarsAndGalaxies)
{
  // sigma is 5; the disc fills a growing part of the frame.
  EXPECT_NEAR(skyOf(syntheticSky(300, 1, 1, 0)).level, 100, 0.5);
  EXPECT_NEAR(skyOf(syntheticSky(300, 20, 0.9, 100)).level, 100, 1.5);
  EXPECT_NEAR(skyOf(syntheticSky(300, 50, 0.3, 100)).level, 100, 2);
  EXPECT_NEAR(skyOf(syntheticSky(300, 80, 0.25, 0)).level, 100, 2);
  // No sky is left in the frame: no more than the least of the disc there, exp(-3.2), and its
  // slope.
  EXPECT_NEAR(skyOf(syntheticSky(300, 50, 0.9, 0)).level, 110, 25);
  Image blank = syntheticSky(20, 1, 1, 0);
  std::fill(blank.values.begin(), blank.values.end(), std::nan(""));
  EXPECT_EQ(skyOf(blank).level, 0);
  blank.values[3] = 7;
  EXPECT_EQ(skyOf(blank).level, 7);
}

TEST(HoleFilling, ContinuesAGradient)
{
  Sky sky(80, 0.5);
  std::vector<std::uint8_t> mask(80 * 80, 0);
  for (int i = 0; i < 80 * 80; ++i)
  {
    mask[i] = std::hypot(i % 80 - 40, i / 80 - 30) < 15;
    sky.values[i] = mask[i] ? 1e6f : sky.values[i];
  }
  fillHoles(80, 80, mask, sky.values);
  for (int i = 0; i < 80 * 80; ++i)
  {
    EXPECT_NEAR(sky.values[i] / sky.smooth(i % 80, i / 80), 1, 0.02) << i;
  }
}

TEST(HoleFilling, BlankPixelsTakeNoPart)
{
  Sky sky(40);
  std::vector<std::uint8_t> mask(1600, 0);
  for (int y = 10; y < 20; ++y)
  {
    for (int x = 10; x < 20; ++x)
    {
      mask[y * 40 + x] = 1;
      sky.at(x - 5, y) = std::nanf("");
      sky.at(x, y) = x < 15 ? 500 : std::nanf("");
    }
  }
  fillHoles(40, 40, mask, sky.values);
  EXPECT_NEAR(sky.at(14, 15), 10, 1e-4);
  EXPECT_NEAR(sky.at(18, 15), 10, 1e-4);
  EXPECT_TRUE(std::isnan(sky.at(7, 15)));
  fillHoles(40, 40, std::vector<std::uint8_t>(1600, 1), sky.values);
  EXPECT_TRUE(std::isnan(sky.at(3, 3)));
}

TEST(ForegroundStars, GoAndLeaveTheGradient)
{
  Sky sky(200, 0.05);
  const auto gaussian = [](double peak, double sigma) {
    return [=](double r) { return peak * std::exp(-0.5 * r * r / (sigma * sigma)); };
  };
  sky.add(40, 50, gaussian(300, 0.7));
  sky.add(120, 60, gaussian(2000, 2));
  sky.add(60, 140, [](double r) { return std::min(500.0, 4000 * std::exp(-0.5 * r * r / 9)); });
  sky.add(197, 100, gaussian(300, 1));
  sky.add(150, 150, [](double r) { return 100 * std::pow(1 + r * r / 12, -2.5); });
  const std::vector<std::uint8_t> mask = foregroundStars(200, 200, 20, sky.values);
  fillHoles(200, 200, mask, sky.values);
  int masked = 0;
  for (int i = 0; i < 200 * 200; ++i)
  {
    masked += mask[i];
    EXPECT_NEAR(sky.values[i] / sky.smooth(i % 200, i / 200), 1, 0.1) << i % 200 << " " << i / 200;
  }
  EXPECT_LT(masked, 2000);
}

TEST(ForegroundStars, NucleiDiscsAndFaintOnesStay)
{
  Sky sky(200, 0.05);
  sky.add(50, 50, [](double r) { return 1000 * std::exp(-r / 3); });
  sky.add(150, 60,
    [](double r) { return 3e4 * std::exp(-7.67 * std::pow(std::hypot(r, 2) / 20, 0.25)); });
  sky.add(60, 150, [](double r) { return 15 * std::exp(-r * r); });
  sky.add(150, 150, [](double r) { return 200 * std::exp(-r * r / 800); });
  const std::vector<std::uint8_t> mask = foregroundStars(200, 200, 20, sky.values);
  EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 0);
  omp_set_num_threads(3);
  const Image picture = syntheticSky(150, 20, 1, 40);
  const std::vector<float> values(picture.values.begin(), picture.values.end());
  const auto three = foregroundStars(150, 150, 50, values);
  omp_set_num_threads(1);
  EXPECT_EQ(foregroundStars(150, 150, 50, values), three);
  EXPECT_GT(std::count(three.begin(), three.end(), 1), 0);
}

TEST(ImageCleaning, MarkedPixelsAreFilled)
{
  Image image = syntheticSky(60, 1, 1, 0);
  image.values[20 * 60 + 20] = 1e5;
  ImageDescription description;
  EXPECT_GT(cleanedValues(image, description, 100)[20 * 60 + 20], 9e4);
  image.bad.assign(3600, 0);
  image.bad[20 * 60 + 20] = 1;
  EXPECT_NEAR(cleanedValues(image, description, 100)[20 * 60 + 20], 0, 10);
}

TEST(IntensityScale, ClipsByPercentile)
{
  LayerDescription layer;
  layer.image = "r";
  layer.clipsByPercentile = true;
  layer.clipPercentile = { 10, 60 };
  std::vector<float> values = { std::nanf(""), INFINITY };
  for (int i = 100; i >= 0; --i)
  {
    values.push_back(static_cast<float>(2 * i - 50));
  }
  const IntensityScale scale(layer, values, "");
  EXPECT_NEAR(scale(2 * 10 - 50), 0, 1e-12);
  EXPECT_NEAR(scale(2 * 35 - 50), 0.5, 1e-6);
  EXPECT_NEAR(scale(2 * 60 - 50), 1, 1e-12);
  layer.clipPercentile = { 0, 100 };
  EXPECT_NEAR(IntensityScale(layer, { 3, 4 }, "")(3.25), 0.25, 1e-6);
  layer.clipPercentile = { 25, 50 };
  EXPECT_NEAR(IntensityScale(layer, { 4, 0 }, "")(1.5), 0.5, 1e-6);
  EXPECT_THROW(IntensityScale(layer, { 3, 3 }, ""), Error);
  EXPECT_EQ(IntensityScale(layer, {}, "")(3), 0);
}

TEST(IntensityScale, LogIsThatOfDs9)
{
  LayerDescription layer;
  layer.clips = true;
  layer.stretch = IntensityStretch::Log;
  const IntensityScale scale(layer, {}, "");
  EXPECT_EQ(scale(0), 0);
  EXPECT_NEAR(scale(0.099), 2 / std::log10(1001.0), 1e-12);
  EXPECT_NEAR(scale(1), 1, 1e-15);
}
} // namespace galaxy
