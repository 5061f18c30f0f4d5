#ifndef galaxy_BadPixels_h
#define galaxy_BadPixels_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

namespace galaxy
{
/// The world coordinates of an image: those supplied by its description, or the header's. Throws
/// Error where there are none.
WorldCoordinates coordinatesOf(const Image& image, const ImageDescription& description);

/// Marks the pixels (Image::bad) that the description's mask image and region file name. The mask
/// has its own coordinates, or none and the image's size; a pixel is bad where the mask's pixel on
/// it is not zero, or NaN, and where its centre lies in a region, or that region's middle in it.
/// Excluded regions and what a mask does not cover are good. `file` is that of the description.
void markBadPixels(const ImageDescription& description, const std::string& file, Image& image);
} // namespace galaxy

#endif
