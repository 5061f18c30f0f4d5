#include "Filters/Splatting/Footprint.h"

namespace galaxy
{
const ErfPolynomial erfPolynomial;

ErfPolynomial::ErfPolynomial()
{
  // erf(u)/u as a sum of Chebyshev polynomials in s = u^2/8 - 1, then expanded in powers of s.
  constexpr int n = degree + 1;
  double power[n] = {};
  double previous[n] = { 1 };   // T_0
  double current[n] = { 0, 1 }; // T_1
  for (int k = 0; k < n; ++k)
  {
    double moment = 0;
    for (int j = 0; j < n; ++j)
    {
      const double angle = M_PI * (j + 0.5) / n;
      const double u = std::sqrt(8 * (std::cos(angle) + 1));
      moment += std::erf(u) / u * std::cos(k * angle);
    }
    const double weight = (k == 0 ? 1.0 : 2.0) / n * moment;
    const double* T = k == 0 ? previous : current;
    for (int m = 0; m < n; ++m)
    {
      power[m] += weight * T[m];
    }
    for (int m = n - 1; k > 0 && m >= 0; --m)
    {
      const double next = (m > 0 ? 2 * current[m - 1] : 0) - previous[m];
      previous[m] = next;
    }
    if (k > 0)
    {
      std::swap_ranges(previous, previous + n, current);
    }
  }
  std::copy(power, power + n, this->coefficients);
}

float SplineFootprint::Points::at(int k) const
{
  constexpr float offset[2] = { 0.211324865f, 0.788675135f }; // 1/2 -+ 1/sqrt(12)
  return ((k >> 1) + offset[k & 1]) * this->cell;
}

SplineFootprint::Points SplineFootprint::points(float center, float h, int pixels, int n)
{
  const float low = std::max((center - h) * n, 0.0f);
  const float high = std::min((center + h) * n + 1, float(pixels) * n);
  return { 2 * static_cast<int>(low), 2 * static_cast<int>(high), 1.0f / n };
}

bool SplineFootprint::prepare(const Splat& splat)
{
  const float h = std::max(splat.h, 1e-3f);
  if (!this->box.clip(splat, h))
  {
    return false;
  }
  const int n = static_cast<int>(std::ceil(std::max(1.0f, 4 / h)));
  const float x = this->box.centerX(splat);
  const float y = this->box.centerY(splat);
  const Points across = points(x, h, this->box.columns, n);
  const Points along = points(y, h, this->box.rows, n);
  for (int row = 0; row < this->box.rows; ++row)
  {
    std::fill_n(this->pixel[row], this->box.columns, 0.0f);
  }
  static const CubicSplineTable table;
  const float toUnit = 1 / (h * h);
  const float share = toUnit / (4.0f * n * n);
  for (int j = along.first; j < along.last; ++j)
  {
    const float dy = along.at(j) - y;
    float* row = this->pixel[j / (2 * n)];
    for (int i = across.first; i < across.last; ++i)
    {
      const float dx = across.at(i) - x;
      row[i / (2 * n)] += share * table((dx * dx + dy * dy) * toUnit);
    }
  }
  for (int j = 0; j < this->box.rows; ++j)
  {
    for (int i = 0; i < this->box.steps() * laneCount; ++i)
    {
      this->weights[j][i] = i < 3 * this->box.columns ? this->pixel[j][i / 3] : 0.0f;
    }
  }
  return true;
}
} // namespace galaxy
