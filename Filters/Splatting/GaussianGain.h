#ifndef galaxy_GaussianGain_h
#define galaxy_GaussianGain_h

#include <algorithm>
#include <cmath>

namespace galaxy
{
/// What a Gaussian splat's light is multiplied with so that its pixels have all of it. A footprint
/// is exp(-b^2/sigma^2), sigma = h/3, averaged over each of the pixels that touch the disc b < h;
/// what these leave out, averaged over the centre's place in its pixel: a disc of radius h touches
/// pi h^2 + 4 h + 1 pixels, those of a disc 2/pi wider. The sum over all pixels is then 1 to 2e-5
/// for any size and place. `h` in pixels.
template <typename Real>
Real gaussianGain(Real h)
{
  const Real edge = 3 + Real(6 / M_PI) / std::max(h, Real(1e-4));
  return 1 / (1 - std::exp(-edge * edge));
}
} // namespace galaxy

#endif
