#include "Filters/Model/GaussianBlur.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Weights at 0, 1, 2, ... pixels.
std::vector<float> halfKernel(double sigma)
{
  const int reach = std::max(1, static_cast<int>(std::ceil(4 * sigma)));
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i <= reach; ++i)
  {
    weights.push_back(std::exp(-0.5 * (i / sigma) * (i / sigma)));
    sum += (i == 0 ? 1 : 2) * weights.back();
  }
  std::vector<float> kernel;
  for (const double weight : weights)
  {
    kernel.push_back(static_cast<float>(weight / sum));
  }
  return kernel;
}

void addShifted(float weight, const float* from, float* to, std::size_t count)
{
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i)
  {
    to[i] += weight * from[i];
  }
}
} // namespace

std::vector<float> gaussianBlur(
  int width, int height, double sigma, const std::vector<float>& values)
{
  if (!(sigma > 0))
  {
    return values;
  }
  const std::vector<float> kernel = halfKernel(sigma);
  const int reach = static_cast<int>(kernel.size()) - 1;
  const auto rowOf = [width](int row) { return static_cast<std::size_t>(row) * width; };
  std::vector<float> across(values.size(), 0), blurred(values.size(), 0);
#pragma omp parallel for
  for (int row = 0; row < height; ++row)
  {
    for (int shift = -std::min(reach, width - 1); shift <= std::min(reach, width - 1); ++shift)
    {
      const std::size_t from = rowOf(row) + std::max(0, -shift);
      const std::size_t to = rowOf(row) + std::max(0, shift);
      addShifted(kernel[std::abs(shift)], &values[from], &across[to], width - std::abs(shift));
    }
  }
#pragma omp parallel for
  for (int row = 0; row < height; ++row)
  {
    for (int from = std::max(0, row - reach); from <= std::min(height - 1, row + reach); ++from)
    {
      addShifted(kernel[std::abs(from - row)], &across[rowOf(from)], &blurred[rowOf(row)], width);
    }
  }
  return blurred;
}
} // namespace galaxy
