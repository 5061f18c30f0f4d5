#ifndef galaxy_Regrid_h
#define galaxy_Regrid_h

#include "Filters/Model/SkyGrid.h"

namespace galaxy
{
/// The values of an image on another grid of the sky, as surface brightness: a pixel becomes the
/// mean, over points no more than a third of the image's pixels apart, of the image between its
/// pixels (bilinear; constant beyond the centres of the outermost). NaN where less than half of the
/// pixel lies on finite values; what is blank has no weight.
///
/// The integral over the sky is kept to 0.1 % for an image whose details are wider than two of its
/// pixels, and a constant to rounding. Same for any number of threads.
std::vector<float> regrid(const CleanImage& image, const SkyGrid& grid);
} // namespace galaxy

#endif
