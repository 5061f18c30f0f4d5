#ifndef galaxy_CubicSpline_h
#define galaxy_CubicSpline_h

#include <algorithm>
#include <vector>

namespace galaxy
{
/// The line integral of the cubic spline M4 of support 1 at impact parameter b, normalised so that
/// its integral over the plane is 1 (Monaghan & Lattanzio 1985; the integral in closed form).
double projectedCubicSpline(double b);

/// The most of its light that a pixel can have, h in pixels: no more than all, nor than the peak,
/// 1.91 where h is 1.
inline float splineMostOfAPixel(float h)
{
  return std::min(1.0F, 2 / (h * h));
}

/// projectedCubicSpline() from a table linear in b^2, never negative; 3e-6 of the centre at worst.
class CubicSplineTable
{
public:
  static constexpr int entries = 2048;
  CubicSplineTable();
  /// `b2` is b^2, in [0, infinity).
  float operator()(float b2) const
  {
    const float s = b2 * entries;
    if (!(s < entries))
    {
      return 0;
    }
    const int i = static_cast<int>(s);
    return this->values[i] + (s - i) * (this->values[i + 1] - this->values[i]);
  }

private:
  std::vector<float> values;
};
} // namespace galaxy

#endif
