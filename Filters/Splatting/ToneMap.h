#ifndef galaxy_ToneMap_h
#define galaxy_ToneMap_h

#include "Filters/Splatting/Render.h"

#include <array>
#include <cstddef>
#include <vector>

namespace galaxy
{
/// From linear light to the display: exposure, black and white point of each channel, then asinh
/// stretch with the hue kept (Lupton et al. 2004, PASP 116, 133), then gamma.
struct ToneMap
{
  double exposure = 1; ///< factor on the radiance
  double stretch = 10; ///< softening Q: mean light x becomes asinh(Q x)/asinh(Q); 0 is linear
  double gamma = 1;    ///< displayed value is (stretched value)^(1/gamma)
  /// Before the stretch, exposed light x becomes (x - black)/(white - black) in each channel, and
  /// black below 0; white must be above black.
  std::array<double, 3> black = { 0, 0, 0 };
  std::array<double, 3> white = { 1, 1, 1 };
};

/// What error of the radiance is never seen: whichever way a picture is off by so much, no channel
/// of the display changes by more than `tolerance` (of white). Half of that is for either part.
ErrorBound allowedError(const ToneMap& map, double tolerance);

/// `count` RGB pixels of radiance to display values in [0, 1].
void applyToneMap(const ToneMap& map, const float* radiance, float* display, std::size_t count);
} // namespace galaxy

#endif
