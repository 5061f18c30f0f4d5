#ifndef galaxy_ErrorFunction_h
#define galaxy_ErrorFunction_h

#include <algorithm>
#include <cmath>

namespace galaxy
{
/// The error function by cubics between values that have its slope too: 1e-12.
class ErrorFunction
{
public:
  ErrorFunction()
  {
    for (int k = 0; k <= 2 * half; ++k)
    {
      const double x = (k - half) / perUnit;
      this->values[k] = std::erf(x);
      this->slopes[k] = 2 / std::sqrt(M_PI) * std::exp(-x * x) / perUnit;
    }
  }
  double operator()(double x) const
  {
    const double at = x > -end ? std::min((x + end) * perUnit, 2.0 * half) : 0;
    const int k = std::min(static_cast<int>(at), 2 * half - 1);
    const double t = at - k, rise = this->values[k + 1] - this->values[k];
    const double a = this->slopes[k] - rise, b = rise - this->slopes[k + 1];
    return this->values[k] + t * (rise + (1 - t) * (a * (1 - t) + b * t));
  }

private:
  static constexpr double perUnit = 256;
  static constexpr double end = 6; ///< beyond, it is 1
  static constexpr int half = 6 * 256;
  double values[2 * half + 1], slopes[2 * half + 1];
};
} // namespace galaxy

#endif
