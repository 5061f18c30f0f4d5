#include "Filters/Model/ImageCleaning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace galaxy
{
namespace
{
template <typename T>
T median(std::vector<T>& values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 != 0)
  {
    return *middle;
  }
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

std::vector<double> borderValues(const Image& image)
{
  const int thickness = std::max(1, std::min(image.width, image.height) / 10);
  std::vector<double> border;
  for (int row = 0; row < image.height; ++row)
  {
    const bool wholeRow = row < thickness || row >= image.height - thickness;
    for (int column = 0; column < image.width; ++column)
    {
      if (!wholeRow && column == thickness)
      {
        column = std::max(thickness, image.width - thickness);
      }
      const double value = column < image.width ? image.at(column, row) : std::nan("");
      if (std::isfinite(value))
      {
        border.push_back(value);
      }
    }
  }
  return border;
}

/// The pixels within 2 pixels of one above the limit.
std::vector<std::uint8_t> starMask(
  int width, int height, double limit, const std::vector<float>& values)
{
  constexpr int reach = 2;
  std::vector<std::uint8_t> mask(values.size(), 0);
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      if (!(values[static_cast<std::size_t>(row) * width + column] > limit))
      {
        continue;
      }
      for (int v = std::max(0, row - reach); v <= std::min(height - 1, row + reach); ++v)
      {
        for (int u = std::max(0, column - reach); u <= std::min(width - 1, column + reach); ++u)
        {
          mask[static_cast<std::size_t>(v) * width + u] = 1;
        }
      }
    }
  }
  return mask;
}

float medianAbout(int column, int row, int width, int height, const std::vector<float>& values,
  const std::vector<std::uint8_t>& mask)
{
  constexpr std::size_t enough = 12;
  std::vector<float> sky;
  for (int reach = 5;; reach *= 2)
  {
    sky.clear();
    for (int v = std::max(0, row - reach); v <= std::min(height - 1, row + reach); ++v)
    {
      for (int u = std::max(0, column - reach); u <= std::min(width - 1, column + reach); ++u)
      {
        const std::size_t pixel = static_cast<std::size_t>(v) * width + u;
        if (mask[pixel] == 0 && !std::isnan(values[pixel]))
        {
          sky.push_back(values[pixel]);
        }
      }
    }
    if (sky.size() >= enough || reach > std::max(width, height))
    {
      return sky.empty() ? std::numeric_limits<float>::quiet_NaN() : median(sky);
    }
  }
}
} // namespace

double borderBackground(const Image& image)
{
  std::vector<double> values = borderValues(image);
  std::vector<double> deviations;
  double centre = 0;
  for (std::size_t before = values.size() + 1; !values.empty() && values.size() < before;)
  {
    before = values.size();
    centre = median(values);
    deviations.resize(values.size());
    std::transform(values.begin(), values.end(), deviations.begin(),
      [centre](double value) { return std::abs(value - centre); });
    const double reach = 3 * 1.4826 * median(deviations);
    values.erase(std::remove_if(values.begin(), values.end(),
                   [=](double value) { return std::abs(value - centre) > reach; }),
      values.end());
  }
  return centre;
}

void replaceStars(int width, int height, double limit, std::vector<float>& values)
{
  const std::vector<std::uint8_t> mask = starMask(width, height, limit, values);
  const std::vector<float> original = values;
#pragma omp parallel for schedule(dynamic, 16)
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const std::size_t pixel = static_cast<std::size_t>(row) * width + column;
      if (mask[pixel] != 0 && !std::isnan(original[pixel]))
      {
        values[pixel] = medianAbout(column, row, width, height, original, mask);
      }
    }
  }
}

std::vector<float> cleanedValues(const Image& image, const ImageDescription& description)
{
  const double background =
    description.automaticBackground ? borderBackground(image) : description.background;
  std::vector<float> values(image.values.size());
  std::transform(image.values.begin(), image.values.end(), values.begin(),
    [background](double value) { return static_cast<float>(value - background); });
  if (description.maskStarsAbove < std::numeric_limits<double>::infinity())
  {
    replaceStars(image.width, image.height, description.maskStarsAbove, values);
  }
  return values;
}
} // namespace galaxy
