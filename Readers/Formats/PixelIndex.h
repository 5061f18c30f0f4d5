#ifndef galaxy_PixelIndex_h
#define galaxy_PixelIndex_h

#include <cmath>

namespace galaxy
{
/// What lies within this of a border between pixels, in pixels, lies on it. Grids of one scale
/// often meet there, half a pixel apart, and the last bit of a coordinate must not decide whose it
/// is.
constexpr double borderWidth = 1e-6;

/// The index, from 0, of the pixel at a coordinate that FITS counts, with the centre of the first
/// at 1; a border belongs to the pixel after it.
inline double pixelIndex(double coordinate)
{
  return std::floor(coordinate - 0.5 + borderWidth);
}
} // namespace galaxy

#endif
