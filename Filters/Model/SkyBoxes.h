#ifndef galaxy_SkyBoxes_h
#define galaxy_SkyBoxes_h

#include "Readers/Formats/Image.h"

#include <cstdint>
#include <vector>

namespace galaxy
{
/// A part of an image and what its pixels are like once those that stand out are clipped.
struct SkyBox
{
  double x = 0; ///< of its middle, from -0.5 to 0.5 across the image
  double y = 0;
  double level = 0;   ///< mode
  double scatter = 0; ///< standard deviation
  double grain = 0;   ///< the same from the differences of neighbours, which know no structure
  double pixels = 0;  ///< of which that was taken
  bool isAtEdge = false;
};

/// 1 where a pixel may show the sky: not blank, not bad, and not in a border of one value, as rows
/// and columns that begin or end with a run of equal values have it where images were padded.
/// `padding` gets what those borders hold.
std::vector<std::uint8_t> skyPixels(const Image& image, std::vector<double>& padding);

/// The boxes of which at least half may show the sky: up to 16 to either side, of 8 pixels at
/// least.
std::vector<SkyBox> skyBoxes(const Image& image, const std::vector<std::uint8_t>& shows);

/// One box of all pixels that may show the sky, of which there is at least one.
SkyBox wholeSkyBox(const Image& image, const std::vector<std::uint8_t>& shows);
} // namespace galaxy

#endif
