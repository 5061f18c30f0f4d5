#ifndef galaxy_ImageCleaning_h
#define galaxy_ImageCleaning_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

#include <vector>

namespace galaxy
{
/// The background of an image in its own unit: the median of its border, a frame as wide as a
/// tenth of the shorter side, after values beyond 3 sigma of the median (sigma = 1.4826 times the
/// median absolute deviation) are clipped until none is left to clip. 0 where the border is blank.
double borderBackground(const Image& image);

/// Takes stars out, for images of the sky: pixels above `limit` and their neighbours within
/// 2 pixels become the median of the unmasked pixels about them, in the smallest of the windows
/// of 11, 21, 41, ... pixels that holds at least 12 of those. NaN stays NaN.
void replaceStars(int width, int height, double limit, std::vector<float>& values);

/// The image's values less its background, stars replaced, as the description asks.
std::vector<float> cleanedValues(const Image& image, const ImageDescription& description);
} // namespace galaxy

#endif
