#include "Filters/Splatting/SplineWeights.h"

#include "Filters/Splatting/CubicSpline.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
float SplineWeights::Points::at(int k) const
{
  constexpr float offset[2] = { 0.211324865f, 0.788675135f }; // 1/2 -+ 1/sqrt(12)
  return ((k >> 1) + offset[k & 1]) * this->cell;
}

SplineWeights::Points SplineWeights::points(float center, float h, int pixels, int n)
{
  const float most = float(pixels) * n;
  const float low = std::min(std::max((center - h) * n, 0.0f), most);
  const float high = std::max(std::min((center + h) * n + 1, most), 0.0f);
  return { 2 * static_cast<int>(low), 2 * static_cast<int>(high), 1.0f / n };
}

void SplineWeights::fill(float x, float y, float h, int columns, int rows)
{
  static const CubicSplineTable table;
  const int n = static_cast<int>(std::ceil(std::max(1.0f, 4 / h)));
  const Points across = points(x, h, columns, n);
  const Points along = points(y, h, rows, n);
  for (int row = 0; row < rows; ++row)
  {
    std::fill_n(this->weights[row], tileStride, 0.0f);
  }
  const float toUnit = 1 / (h * h);
  const float share = toUnit / (4.0f * n * n);
  for (int j = along.first; j < along.last; ++j)
  {
    const float dy = along.at(j) - y;
    float* row = this->weights[j / (2 * n)];
    for (int i = across.first; i < across.last; ++i)
    {
      const float dx = across.at(i) - x;
      row[i / (2 * n)] += share * table((dx * dx + dy * dy) * toUnit);
    }
  }
}
} // namespace galaxy
