#ifndef galaxy_FitsCube_h
#define galaxy_FitsCube_h

#include "Readers/Formats/FitsHdu.h"

#include <array>
#include <string>
#include <vector>

namespace galaxy
{
/// A box of pixels of a cube, the image plane in full, that becomes one image by a weighted sum.
struct FitsSlab
{
  std::vector<long> first; ///< one-based, an entry an axis
  std::vector<long> last;
  std::size_t summedAxis = 0;  ///< zero-based; the only axis of some length beside x and y
  std::vector<double> weights; ///< of the pixels along summedAxis
};

/// How a selection is made from the pixels of an image.
struct FitsPlan
{
  std::array<int, 2> axes = { 1, 2 }; ///< FITS axis numbers of x and y
  std::vector<FitsSlab> slabs;
  bool isMean = false;    ///< the sum is divided by the weights of the pixels that are not blank
  std::string unitSuffix; ///< to the image's unit
};

/// The axes of the image plane: longitude and latitude of one celestial system, the lower number
/// first; axes 1 and 2 where the header has no such pair.
std::array<int, 2> imagePlane(const FitsHdu& hdu);

/// Throws Error where the selection names a plane that the image does not have, or a velocity
/// range where the image has no velocity axis or no channel in it.
FitsPlan planOf(const std::string& file, const FitsHdu& hdu, const FitsSelection& selection);
} // namespace galaxy

#endif
