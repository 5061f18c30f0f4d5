#include "Filters/Splatting/CubicSpline.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Antiderivatives in z of 1, r, r^2 and r^3 along the line r^2 = b^2 + z^2.
struct LineIntegrals
{
  double I0, I1, I2, I3;
  LineIntegrals(double b, double z)
  {
    const double r = std::sqrt(b * b + z * z);
    const double b2L = b > 0 ? b * b * std::log(z + r) : 0;
    this->I0 = z;
    this->I1 = 0.5 * (z * r + b2L);
    this->I2 = b * b * z + z * z * z / 3;
    this->I3 = z * r * r * r / 4 + 0.375 * b * b * (z * r + b2L);
  }
  /// 1 - 3/2 q^2 + 3/4 q^3, the spline for q < 1.
  double inner() const { return this->I0 - 1.5 * this->I2 + 0.75 * this->I3; }
  /// (2 - q)^3 / 4, the spline for 1 < q < 2.
  double outer() const { return 2 * this->I0 - 3 * this->I1 + 1.5 * this->I2 - 0.25 * this->I3; }
};
} // namespace

double projectedCubicSpline(double b)
{
  const double q = 2 * b; // the spline's own unit is half its support
  if (!(q < 2))
  {
    return 0;
  }
  const double zInner = std::sqrt(std::max(0.0, 1 - q * q));
  const double zOuter = std::sqrt(4 - q * q);
  const double half = LineIntegrals(q, zInner).inner() - LineIntegrals(q, 0).inner() +
    LineIntegrals(q, zOuter).outer() - LineIntegrals(q, zInner).outer();
  return std::max(0.0, 4 * 2 / M_PI * half);
}

CubicSplineTable::CubicSplineTable()
  : values(entries + 1)
{
  for (int i = 0; i < entries; ++i)
  {
    this->values[i] = static_cast<float>(projectedCubicSpline(std::sqrt(double(i) / entries)));
  }
}
} // namespace galaxy
