#ifndef galaxy_ImageCleaning_h
#define galaxy_ImageCleaning_h

#include "Filters/Model/SkyGrid.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

#include <vector>

namespace galaxy
{
/// The image's values less a background, with bad pixels and then foreground stars filled from
/// their surroundings, as the description asks.
std::vector<float> cleanedValues(
  const Image& image, const ImageDescription& description, double background);

/// Its pixels' place on the sky. Throws Error where the image has no usable coordinates.
SkyGrid gridOf(const Image& image, const ImageDescription& description);

/// Both, the background being what the description says or, where it leaves that to us, the sky's.
CleanImage cleanedImage(const Image& image, const ImageDescription& description);
} // namespace galaxy

#endif
