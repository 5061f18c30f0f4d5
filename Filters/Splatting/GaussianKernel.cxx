#include "Filters/Splatting/GaussianKernel.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
const GaussianPolynomial gaussianPolynomial;

double gaussianCumulative(double s)
{
  const double edge = std::exp(-9.0), root = std::sqrt(M_PI);
  const double inside = std::clamp(s, -3.0, 3.0);
  return (0.5 * root * std::erf(inside) - edge * inside) / (root * std::erf(3.0) - 6 * edge);
}

GaussianPolynomial::GaussianPolynomial()
{
  // The share/u as a sum of Chebyshev polynomials in s = 2 u^2/end^2 - 1, then expanded in powers
  // of s.
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
      const double u = end * std::sqrt((std::cos(angle) + 1) / 2);
      moment += gaussianCumulative(u) / u * std::cos(k * angle);
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
} // namespace galaxy
