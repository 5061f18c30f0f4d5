#ifndef galaxy_ForegroundStars_h
#define galaxy_ForegroundStars_h

#include <cstdint>
#include <vector>

namespace galaxy
{
/// Marks (1) the pixels of foreground stars, found by their shape, so that a nucleus, a smaller
/// galaxy or an arm is no star however bright.
///
/// With I(r) the median of the pixels at r pixels from a local maximum P (from the middle of its
/// top, where it is flat), let h be the least whole radius, up to 8, by which the light above I(6
/// h) has halved, where that light P - I(6 h) exceeds `contrast`. The maximum is a star where the
/// light
/// * ends as sharply as a point source's: I(3 h) - I(6 h) < 0.06 (P - I(6 h)). A Gaussian leaves
///   0.002 there, a Moffat profile of beta = 2.5 0.03, an exponential disc 0.11;
/// * has a round top, or a flat one where saturated: I((h - 1)/2) - I(6 h) > 0.8 (P - I(6 h)). A
///   Gaussian keeps 0.84, a bulge's cusp loses more;
/// * stands on level ground rather than in a bulge: I(6 h) - I(12 h) is less than 0.01 of its light
///   and 0.2 `contrast` together.
/// The mask reaches to where I(r) - I(6 h) falls below `contrast` / 10, to 6 h at most, and a pixel
/// farther.
std::vector<std::uint8_t> foregroundStars(
  int width, int height, double contrast, const std::vector<float>& values);
} // namespace galaxy

#endif
