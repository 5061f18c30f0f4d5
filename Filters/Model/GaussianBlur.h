#ifndef galaxy_GaussianBlur_h
#define galaxy_GaussianBlur_h

#include <vector>

namespace galaxy
{
/// Convolves with a round Gaussian of unit sum and `sigma` pixels, cut off at 4 sigma; the sky
/// beyond the edges is 0. `values` must be finite.
std::vector<float> gaussianBlur(
  int width, int height, double sigma, const std::vector<float>& values);
} // namespace galaxy

#endif
