#ifndef galaxy_GaussianKernel_h
#define galaxy_GaussianKernel_h

#include <algorithm>

namespace galaxy
{
/// Along each axis of the image a Gaussian kernel of smoothing length h is exp(-s^2) - exp(-9),
/// s = 3 x / h, which ends at |x| = h without a step. Its share of light below s: 0 up to s = -3,
/// 1/2 in the middle, less that half here, so that it is odd.
double gaussianCumulative(double s);

/// The most of its light that a pixel can have, a = 3 / h with h in pixels: no more than all, nor
/// than the peak.
inline constexpr float gaussianPeak = 0.3187F; ///< where a is 1
inline float gaussianMostOfAPixel(float a)
{
  return std::min(1.0F, gaussianPeak * a * a);
}

/// The round kernel exp(-r^2/sigma^2) - exp(-9), r < 3 sigma, of integral 1 in units of sigma^2.
inline constexpr double nearPeak = 1 / (3.14159265358979323846 * (1 - 10 * 1.2340980408667956e-4));

/// gaussianCumulative() for |s| <= end in single precision, to 1e-7: s P(2 s^2/end^2 - 1), P
/// through the Chebyshev nodes.
struct GaussianPolynomial
{
  static constexpr int degree = 11;
  static constexpr float end = 3;
  GaussianPolynomial();
  float coefficients[degree + 1];
};
extern const GaussianPolynomial gaussianPolynomial;
} // namespace galaxy

#endif
