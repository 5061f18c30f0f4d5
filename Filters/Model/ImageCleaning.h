#ifndef galaxy_ImageCleaning_h
#define galaxy_ImageCleaning_h

#include "Filters/Model/SkyGrid.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

#include <vector>

namespace galaxy
{
/// The image's values less its background, with bad pixels and then foreground stars filled from
/// their surroundings, as the description asks.
std::vector<float> cleanedValues(const Image& image, const ImageDescription& description);

/// The same with its place on the sky. Throws Error where the image has no usable coordinates.
CleanImage cleanedImage(const Image& image, const ImageDescription& description);
} // namespace galaxy

#endif
