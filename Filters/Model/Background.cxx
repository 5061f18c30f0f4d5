#include "Filters/Model/Background.h"

#include "Filters/Model/Median.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace galaxy
{
namespace
{
/// 3 median - 2 mean of what clipping leaves, which holds at least one value.
double clippedMode(std::vector<double> values)
{
  std::vector<double> deviations;
  double centre = 0;
  for (std::size_t before = values.size() + 1; values.size() < before;)
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
  double deviation = 0;
  for (const double value : values)
  {
    deviation += value - centre;
  }
  return centre - 2 * deviation / values.size();
}
} // namespace

double borderBackground(const Image& image)
{
  constexpr int tiles = 10;
  std::vector<double> modes;
  for (int v = 0; v < tiles; ++v)
  {
    for (int u = 0; u < tiles; ++u)
    {
      if (u != 0 && u != tiles - 1 && v != 0 && v != tiles - 1)
      {
        continue;
      }
      std::vector<double> values;
      for (int row = v * image.height / tiles; row < (v + 1) * image.height / tiles; ++row)
      {
        for (int column = u * image.width / tiles; column < (u + 1) * image.width / tiles; ++column)
        {
          if (std::isfinite(image.at(column, row)))
          {
            values.push_back(image.at(column, row));
          }
        }
      }
      if (!values.empty())
      {
        modes.push_back(clippedMode(std::move(values)));
      }
    }
  }
  if (modes.empty())
  {
    return 0;
  }
  const auto quartile = modes.begin() + (modes.size() - 1) / 4;
  std::nth_element(modes.begin(), quartile, modes.end());
  return *quartile;
}
} // namespace galaxy
