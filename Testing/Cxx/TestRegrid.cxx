#include "Filters/Model/Regrid.h"

#include "Filters/Model/GaussianBlur.h"
#include "Readers/Formats/PixelLattice.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

namespace galaxy
{
namespace
{
/// A Gaussian of `fwhm` arcsec at (x, y) arcsec from the middle, along the grid's axes.
CleanImage gaussianImage(int size, double pixel, double angle, double fwhm, double x, double y)
{
  CleanImage image;
  image.grid = tangentGrid(size, pixel, angle);
  const double sigma = fwhm / 2.3548 / pixel;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const double u = column - 0.5 * (size - 1) - x / pixel;
      const double v = row - 0.5 * (size - 1) - y / pixel;
      image.values.push_back(
        static_cast<float>(std::exp(-0.5 * (u * u + v * v) / (sigma * sigma))));
    }
  }
  return image;
}
} // namespace

TEST(Regrid, KeepsTheFlux)
{
  // To smaller and larger pixels and the same, turned: sharp sources of 2 to 3 pixels.
  for (const double fwhm : { 20.0, 30.0 })
  {
    const CleanImage image = gaussianImage(101, 10, 0, fwhm, 37, -52);
    const double flux = fluxOf(image.values, 10);
    for (const double pixel : { 3.0, 7.0, 10.0, 23.0 })
    {
      for (const double angle : { 0.0, 31.0, 90.0 })
      {
        const int size = static_cast<int>(1500 / pixel);
        const std::vector<float> values = regrid(image, tangentGrid(size, pixel, angle));
        EXPECT_NEAR(fluxOf(values, pixel) / flux, 1, 1e-3) << pixel << " " << angle << " " << fwhm;
      }
    }
  }
}

TEST(Regrid, KeepsThePlace)
{
  // A source 100 arcsec up a grid turned by 90 degrees is 100 arcsec to the East of the middle.
  const CleanImage image = gaussianImage(101, 10, 90, 60, 0, 100);
  const SkyGrid grid = tangentGrid(121, 5, 0);
  const std::vector<float> values = regrid(image, grid);
  const std::size_t peak = std::max_element(values.begin(), values.end()) - values.begin();
  EXPECT_EQ(peak % 121, 60u - 20u);
  EXPECT_EQ(peak / 121, 60u);
  EXPECT_NEAR(values[peak], 1, 0.02);
}

TEST(Regrid, ConstantStaysConstant)
{
  CleanImage image = gaussianImage(80, 10, 20, 30, 0, 0);
  std::fill(image.values.begin(), image.values.end(), 7.0f);
  for (const double pixel : { 2.0, 10.0, 35.0 })
  {
    const int size = static_cast<int>(1600 / pixel);
    const std::vector<float> values = regrid(image, tangentGrid(size, pixel, -15));
    int blank = 0;
    for (const float value : values)
    {
      blank += std::isnan(value);
      EXPECT_TRUE(std::isnan(value) || std::abs(value - 7) < 1e-5);
    }
    // The grid is four times as large as the image, which lies whole within it.
    EXPECT_NEAR(double(blank) / values.size(), 0.75, 0.02);
  }
}

TEST(Regrid, BlankPixelsHaveNoWeight)
{
  CleanImage image = gaussianImage(60, 10, 0, 30, 0, 0);
  for (std::size_t i = 0; i < image.values.size(); ++i)
  {
    image.values[i] = i % 60 < 30 ? 3.0f : std::nanf("");
  }
  const std::vector<float> values = regrid(image, tangentGrid(60, 10, 0));
  EXPECT_NEAR(values[20 * 60 + 10], 3, 1e-6);
  EXPECT_NEAR(values[20 * 60 + 29], 3, 1e-6);
  EXPECT_TRUE(std::isnan(values[20 * 60 + 31]));
}

TEST(Regrid, IsTheSameForAnyNumberOfThreads)
{
  const CleanImage image = gaussianImage(101, 10, 0, 30, 37, -52);
  const SkyGrid grid = tangentGrid(120, 8, 33, 0.01);
  omp_set_num_threads(1);
  const std::vector<float> one = regrid(image, grid);
  const std::vector<float> blurredOnce = gaussianBlur(101, 101, 4, image.values);
  omp_set_num_threads(3);
  const std::vector<float> three = regrid(image, grid);
  EXPECT_EQ(std::memcmp(one.data(), three.data(), one.size() * sizeof(float)), 0);
  EXPECT_EQ(blurredOnce, gaussianBlur(101, 101, 4, image.values));
}

TEST(GaussianBlur, WidensAGaussian)
{
  // Widths add in squares, the sum stays.
  const CleanImage image = gaussianImage(121, 1, 0, 3 * 2.3548, 5, -7);
  const std::vector<float> blurred = gaussianBlur(121, 121, 4, image.values);
  EXPECT_NEAR(fluxOf(blurred, 1) / fluxOf(image.values, 1), 1, 1e-4);
  const double peak = *std::max_element(blurred.begin(), blurred.end());
  EXPECT_NEAR(peak, 9.0 / 25, 1e-3);
  EXPECT_EQ(gaussianBlur(121, 121, 0, image.values), image.values);
}
} // namespace galaxy
