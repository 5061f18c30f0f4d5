#include "Filters/Model/CombineImages.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/GaussianBlur.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <random>

namespace galaxy
{
namespace
{
constexpr double bumps[][3] = { { 60, 20, 1.0 }, { -90, 40, 0.7 }, { 15, -110, 0.8 },
  { -40, -60, 0.5 } }; // x and y in arcsec, height

/// A disc of 150 arcsec with four clumps of 8 arcsec, seen with a round beam of `beam` (FWHM,
/// arcsec): the closed form of Gaussians convolved.
double brightness(double x, double y, double beam)
{
  const auto gaussian = [=](double u, double v, double sigma) {
    const double wide = sigma * sigma + beam * beam / (2.3548 * 2.3548);
    return sigma * sigma / wide * std::exp(-0.5 * (u * u + v * v) / wide);
  };
  double sum = 0.3 * gaussian(x, y, 150);
  for (const auto& bump : bumps)
  {
    sum += bump[2] * gaussian(x - bump[0], y - bump[1], 8);
  }
  return sum;
}

double totalFlux()
{
  double sum = 0.3 * 150 * 150;
  for (const auto& bump : bumps)
  {
    sum += bump[2] * 64;
  }
  return 2 * pi * sum;
}

CombineSource source(
  const char* name, int size, double pixel, double beam, double missing, double noise = 0)
{
  CombineSource made;
  made.name = name;
  made.image.grid = tangentGrid(size, pixel, 0);
  made.resolution = { beam, false };
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double x = (column - 0.5 * (size - 1)) * pixel;
      const double y = (row - 0.5 * (size - 1)) * pixel;
      const double seen = std::max(brightness(x, y, beam) - missing, 0.0);
      made.image.values.push_back(static_cast<float>(seen + noise * normal(random)));
    }
  }
  return made;
}

/// The value at (x, y) arcsec right of and above the middle.
double valueAt(const CleanImage& image, double pixel, double x, double y)
{
  const auto column = std::lround(x / pixel + 0.5 * (image.grid.width - 1));
  const auto row = std::lround(y / pixel + 0.5 * (image.grid.height - 1));
  return image.values[row * image.grid.width + column];
}

std::string messageOf(const std::vector<CombineSource>& sources)
{
  return errorOf([&] { combineImages(sources, 0, "m.galaxy", "hi"); });
}
} // namespace

TEST(CombineImages, KeepsTheWidestsFluxAndTheSharpestsDetail)
{
  // The sharper, the smaller the field and the more of the faint light is missing.
  const std::vector<CombineSource> sources = { source("high", 161, 4, 15, 0.15),
    source("medium", 121, 9, 45, 0.05), source("low", 81, 20, 100, 0) };
  const CleanImage combined = combineImages(sources, std::nan(""), "m.galaxy", "hi");
  EXPECT_GE(combined.grid.width, 405);
  EXPECT_LE(combined.grid.width, 407);
  EXPECT_NEAR(fluxOf(combined.values, 4) / totalFlux(), 1, 0.005);
  double worst = 0;
  for (const auto& bump : bumps)
  {
    const double truth = brightness(bump[0], bump[1], 15);
    worst = std::max(worst, std::abs(valueAt(combined, 4, bump[0], bump[1]) / truth - 1));
  }
  EXPECT_LT(worst, 0.1);
  // Where only the widest reaches it is as it was.
  EXPECT_NEAR(valueAt(combined, 4, 600, 0), brightness(600, 0, 100), 1e-5);
}

TEST(CombineImages, NothingMissingIsTheSharpImage)
{
  // With all of the light in the sharp image and a field as wide, the combination is that image.
  const CleanImage combined = combineImages(
    { source("high", 301, 4, 15, 0), source("low", 61, 20, 100, 0) }, 0, "m.galaxy", "hi");
  for (double x = -300; x <= 300; x += 20)
  {
    for (double y = -300; y <= 300; y += 20)
    {
      EXPECT_NEAR(valueAt(combined, 4, x, y), brightness(x, y, 15), 0.02);
    }
  }
}

TEST(CombineImages, NoiseOfTheSharpImageStaysOut)
{
  const double noise = 0.01;
  const CleanImage combined =
    combineImages({ source("high", 301, 4, 15, 0.1, noise), source("low", 61, 20, 100, 0) },
      std::nan(""), "m.galaxy", "hi");
  EXPECT_NEAR(fluxOf(combined.values, 4) / totalFlux(), 1, 0.005);
  // Far out, where the wide image is all but dark, the sharp one's noise would be seen.
  double sum = 0;
  int count = 0;
  for (double x = -560; x < -480; x += 4)
  {
    for (double y = -560; y < -480; y += 4, ++count)
    {
      sum += std::pow(valueAt(combined, 4, x, y) - brightness(x, y, 100), 2);
    }
  }
  EXPECT_LT(std::sqrt(sum / count), 0.1 * noise);
}

TEST(CombineImages, PerBeamIsBroughtToTheFirstBeam)
{
  std::vector<CombineSource> sources = { source("high", 161, 4, 15, 0.15),
    source("low", 81, 20, 100, 0) };
  const CleanImage plain = combineImages(sources, 0, "m.galaxy", "hi");
  for (CombineSource& each : sources)
  {
    each.resolution.perBeam = true;
    for (float& value : each.image.values)
    {
      value *= static_cast<float>(std::pow(each.resolution.beam / 15, 2));
    }
  }
  const CleanImage perBeam = combineImages(sources, 0, "m.galaxy", "hi");
  ASSERT_EQ(plain.values.size(), perBeam.values.size());
  for (std::size_t i = 0; i < plain.values.size(); ++i)
  {
    ASSERT_NEAR(plain.values[i], perBeam.values[i], 1e-5);
  }
}

TEST(CombineImages, ErrorsNameTheImages)
{
  const CombineSource high = source("high", 41, 4, 15, 0), low = source("low", 41, 20, 100, 0);
  EXPECT_EQ(messageOf({ low, high }),
    "m.galaxy: hi: combine: high is not less sharp than low; name the sharpest first, or give "
    "each its `beam`");
  CombineSource other = low;
  other.resolution.perBeam = true;
  EXPECT_NE(messageOf({ high, other }).find("only one has values per beam"), std::string::npos);
  EXPECT_NE(messageOf({ source("tiny", 5, 0.01, 0.1, 0), low }).find("2^26"), std::string::npos);
}

TEST(CombineImages, ResolutionComesFromTheDescriptionOrTheHeader)
{
  const auto card = [](const std::string& text) {
    return text + std::string(80 - text.size(), ' ');
  };
  Image image;
  image.unit = "JY/BEAM";
  ImageDescription description;
  const SkyGrid grid = tangentGrid(50, 7, 30);
  Resolution resolution = resolutionOf(image, description, grid);
  EXPECT_NEAR(resolution.beam, 21, 1e-3);
  EXPECT_FALSE(resolution.perBeam);
  image.cards = card("BMAJ    =              0.01 / degrees") + card("BMIN    =           0.0025");
  resolution = resolutionOf(image, description, grid);
  EXPECT_NEAR(resolution.beam, 18, 1e-9);
  EXPECT_TRUE(resolution.perBeam);
  image.cards = card("HISTORY AIPS   CLEAN BMAJ=  2.0000E-02 BMIN=  5.0000E-03 BPA=  45.00");
  EXPECT_NEAR(resolutionOf(image, description, grid).beam, 36, 1e-9);
  description.beam = 11;
  EXPECT_EQ(resolutionOf(image, description, grid).beam, 11);
}

TEST(GalaxyBuilder, BuildsFromACombinedImage)
{
  Galaxy input;
  input.rings = flatDisk(12);
  const auto disc = [](double scale) {
    return [scale](double x, double y) { return std::exp(-(x * x + y * y) / (2 * scale)); };
  };
  input.images = { skyPicture(101, disc(9), 5), skyPicture(101, disc(9), 10), {} };
  GalaxyDescription& galaxy = input.description;
  galaxy.file = "m83.galaxy";
  galaxy.centre = m83Centre;
  galaxy.distance = m83Distance;
  galaxy.images = { pictureDescription("sharp", 5), pictureDescription("wide", 10), {} };
  galaxy.images[2].name = "both";
  galaxy.images[2].combine = { "sharp", "wide" };
  ComponentDescription gas;
  gas.name = "gas";
  gas.particles = 20000;
  gas.layers.emplace_back();
  gas.layers[0].image = "both";
  gas.layers[0].clips = true;
  galaxy.components = { gas };
  const Particles particles = buildGalaxy(input);
  double light = 0;
  for (const float intensity : particles.intensity)
  {
    light += intensity;
  }
  EXPECT_NEAR(light / (2 * pi * 9), 1, 0.05);
}
} // namespace galaxy
