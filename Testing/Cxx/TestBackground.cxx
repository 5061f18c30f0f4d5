#include "Filters/Model/Background.h"

#include "Readers/Formats/FitsFile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <random>

namespace galaxy
{
namespace
{
constexpr int side = 400;

/// A sky of a known level, to which all else is added.
class MadeSky
{
public:
  MadeSky(double level, double noise, int width = side, int height = side)
    : random(7)
  {
    this->image.width = width;
    this->image.height = height;
    std::normal_distribution<double> pixel(level, noise);
    for (int k = 0; k < width * height; ++k)
    {
      this->image.values.push_back(noise > 0 ? pixel(this->random) : level);
    }
  }

  /// Changes every pixel by its value and its place from the middle.
  MadeSky& change(const std::function<double(double value, double x, double y)>& to)
  {
    const int width = this->image.width;
    for (std::size_t k = 0; k < this->image.values.size(); ++k)
    {
      this->image.values[k] =
        to(this->image.values[k], static_cast<double>(k % width) - 0.5 * (width - 1),
          static_cast<double>(k / width) - 0.5 * (this->image.height - 1));
    }
    return *this;
  }

  /// An exponential disc, in the middle or beside it.
  MadeSky& disc(double peak, double length, double axes = 0.8, double x0 = 0, double y0 = 0)
  {
    return this->change([=](double value, double x, double y) {
      return value + peak * std::exp(-std::hypot(x - x0, (y - y0) / axes) / length);
    });
  }

  /// Stars of Moffat profiles, peaks from 10 to `brightest`.
  MadeSky& stars(int count, double brightest)
  {
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < count; ++k)
    {
      const int column = static_cast<int>(unit(this->random) * this->image.width);
      const int row = static_cast<int>(unit(this->random) * this->image.height);
      const double width = 1 + 1.5 * unit(this->random);
      const double peak = 10 * std::pow(brightest / 10, unit(this->random));
      for (int y = std::max(0, row - 30); y < std::min(this->image.height, row + 30); ++y)
      {
        for (int x = std::max(0, column - 30); x < std::min(this->image.width, column + 30); ++x)
        {
          const double r2 = (x - column) * (x - column) + (y - row) * (y - row);
          this->at(x, y) += peak * std::pow(1 + r2 / (3 * width * width), -2.5);
        }
      }
    }
    return *this;
  }

  /// As 8 bits hold it.
  MadeSky& bytes()
  {
    return this->change(
      [](double value, double, double) { return std::clamp(std::rint(value), 0.0, 255.0); });
  }

  /// A dark margin, `width` pixels to the sides asked for.
  MadeSky& margin(int width, bool left, bool right, bool bottom, bool top)
  {
    std::normal_distribution<double> dark(6.9, 1.2);
    const double end = 0.5 * side - width;
    return this->change([&](double value, double x, double y) {
      const bool isMargin =
        (left && x < -end) || (right && x > end) || (bottom && y < -end) || (top && y > end);
      return isMargin ? std::max(0.0, std::rint(dark(this->random))) : value;
    });
  }

  double& at(int x, int y) { return this->image.values[y * this->image.width + x]; }
  double level() const { return skyOf(this->image).level; }

  Image image;
  std::mt19937 random;
};

/// An 8-bit plate of a galaxy with a sky of 45.
MadeSky plate()
{
  MadeSky sky(45, 3);
  return sky.disc(150, 40).stars(60, 200).bytes();
}

const double blank = std::nan("");
} // namespace

TEST(Background, IsTheSkysUnderAGalaxy)
{
  EXPECT_NEAR(MadeSky(100, 5).level(), 100, 0.3);
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 30).level(), 100, 1);
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 25, 0.8, -100, -90).level(), 100, 1);
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 90, 0.2).level(), 100, 1.5);
  EXPECT_NEAR(MadeSky(100, 5, 100, 100).disc(1000, 8).level(), 100, 2);
  EXPECT_NEAR(MadeSky(100, 5, 600, 90).disc(1000, 40, 0.15).level(), 100, 2);
  // In the corners the disc has 6 still, at the middle of the edges 40.
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 62).level(), 107, 7);
}

TEST(Background, IsTheSkysUnderStarsAndOutliers)
{
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 30).stars(150, 1e4).level(), 100, 1.5);
  EXPECT_NEAR(MadeSky(100, 5).disc(1000, 30).stars(600, 1e3).level(), 100, 2.5);
  MadeSky hit(100, 5);
  hit.disc(1000, 30).change([&](double value, double, double) {
    const unsigned dice = hit.random() % 100;
    return dice == 0 ? 65535 : dice == 1 ? -1e4 : dice == 2 ? blank : value;
  });
  EXPECT_NEAR(hit.level(), 100, 1);
  EXPECT_NEAR(skyOf(hit.image).scatter, 5, 0.5);
}

TEST(Background, IsTheSkysInTheMiddleOfAGradient)
{
  for (const double slope : { 0.04, 0.15 })
  {
    MadeSky sky(100, 3);
    sky.disc(1000, 30).stars(80, 1e3).change(
      [=](double value, double x, double y) { return value + slope * (x - 0.5 * y); });
    EXPECT_NEAR(sky.level(), 100, 1.5) << slope;
  }
}

TEST(Background, KnowsMarginsAndLabels)
{
  EXPECT_NEAR(plate().level(), 45, 1);
  EXPECT_NEAR(plate().margin(40, true, false, false, false).level(), 45, 1);
  EXPECT_NEAR(plate().margin(45, true, false, true, false).level(), 45, 1.5);
  EXPECT_NEAR(plate().margin(60, true, true, false, true).level(), 45, 2);
  const auto label = [](double value, double x, double y) {
    const bool isLetter = std::fmod(x + side, 14) < 7;
    return y < -165 && y > -190 && x < 0 && isLetter ? 220 : value;
  };
  EXPECT_NEAR(plate().margin(50, true, true, true, true).change(label).level(), 45, 2);
  EXPECT_NEAR(plate()
                .change([](double value, double x, double y) {
                  return y < -130 && x < 40 ? (std::fmod(y + side, 10) < 2 ? 20 : 230) : value;
                })
                .level(),
    45, 1);
  EXPECT_NEAR(
    plate().change([](double value, double, double y) { return y > 110 ? 6.9 : value; }).level(),
    45, 1);
}

TEST(Background, KnowsBordersThatAreBlankOrConstant)
{
  for (const double filler : { 0.0, blank, -32768.0, 1e4 })
  {
    const auto padded = [filler](const std::function<bool(double x, double y)>& isOutside) {
      MadeSky sky(100, 5);
      return sky.disc(1000, 25)
        .change([&](double value, double x, double y) { return isOutside(x, y) ? filler : value; })
        .level();
    };
    const auto frame = [](double width) {
      return
        [=](double x, double y) { return std::max(std::abs(x), std::abs(y)) > 0.5 * side - width; };
    };
    EXPECT_NEAR(padded(frame(30)), 100, 1) << filler;
    EXPECT_NEAR(padded(frame(70)), 100, 2.5) << filler;
    EXPECT_NEAR(padded([](double x, double y) { return std::hypot(x, y) > 195; }), 100, 1)
      << filler;
    EXPECT_NEAR(padded([](double x, double y) { return std::abs(x) + std::abs(y) > 210; }), 100, 2)
      << filler;
    EXPECT_NEAR(padded([](double x, double) { return x < -60; }), 100, 1.5) << filler;
  }
  MadeSky marked(100, 5);
  marked.disc(1000, 25).image.bad.assign(side * side, 0);
  for (int k = 0; k < side * side; ++k)
  {
    if (k % side > side / 2)
    {
      marked.image.values[k] = 60 + k % 7;
      marked.image.bad[k] = 1;
    }
  }
  EXPECT_NEAR(marked.level(), 100, 1.5);
}

TEST(Background, IsFinerThanTheStepsOfCounts)
{
  const auto inSteps = [](double level, double noise, double step) {
    MadeSky sky(level, noise);
    return sky.disc(100 * step, 25)
      .change([=](double value, double, double) { return step * std::rint(value / step); })
      .level();
  };
  EXPECT_NEAR(inSteps(100.3, 0.5, 1), 100.3, 0.15);
  EXPECT_NEAR(inSteps(100.3, 1, 1), 100.3, 0.25);
  EXPECT_NEAR(inSteps(45.4, 3, 1), 45.4, 0.5);
  EXPECT_NEAR(inSteps(100, 5, 4), 100, 1);
  EXPECT_NEAR(inSteps(1003, 5, 10), 1003, 2);
  for (const double photons : { 0.05, 0.3, 1.0, 4.0 })
  {
    MadeSky sky(0, 0);
    sky.change(
      [&](double, double, double) { return std::poisson_distribution<int>(photons)(sky.random); });
    EXPECT_NEAR(sky.level(), photons, 0.05 + 0.35 * std::sqrt(photons)) << photons;
  }
}

TEST(Background, IsTheConstantUnderAGalaxyWithoutNoise)
{
  const auto cut = [](double floor, double level, double noise) {
    return [=](double value, double, double) mutable {
      return value + noise > floor ? value + level : level;
    };
  };
  EXPECT_EQ(MadeSky(7, 0).level(), 7);
  EXPECT_EQ(MadeSky(0, 0).disc(100, 30).change(cut(5, 0, 0)).level(), 0);
  EXPECT_NEAR(MadeSky(0, 0).disc(100, 30).change(cut(0.1, 40, 0)).level(), 40, 0.5);
  EXPECT_NEAR(MadeSky(0, 0).disc(1000, 15).level(), 0, 0.1);
  MadeSky moment(0, 2); // where nothing is found, 0
  EXPECT_NEAR(moment.disc(100, 30).change(cut(6, 0, 0)).level(), 0, 0.5);
}

TEST(Background, OfAPhotographicPlate)
{
  const std::string file = GALAXY_SOURCE_DIR "/../shared/data/M83/m83_dss1_J_671.fits";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << file << " is absent";
  }
  // The median of its corners, where M83 is faintest: 3743 to 3825.
  const SkyLevel sky = skyOf(readFitsImage(file));
  EXPECT_NEAR(sky.level, 3780, 60);
  EXPECT_NEAR(sky.scatter, 235, 40);
}
} // namespace galaxy
