#ifndef galaxy_Background_h
#define galaxy_Background_h

#include "Readers/Formats/Image.h"

namespace galaxy
{
/// The sky's level in an image, in its own unit, from its border: the tenth of either side along
/// the edges, cut into 36 tiles of 10 x 10 over the image. Each tile gives the mode of its values,
/// 3 median - 2 mean, after those beyond 3 sigma of the median (sigma = 1.4826 times the median
/// absolute deviation) are clipped until none is left to clip; the sky is the lower quartile of the
/// tiles. So a galaxy may cover up to three quarters of the border, and faint stars, which skew a
/// tile's values, weigh half as much as in its median. 0 where the border is blank.
double borderBackground(const Image& image);
} // namespace galaxy

#endif
