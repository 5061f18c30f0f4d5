#ifndef galaxy_PixelCount_h
#define galaxy_PixelCount_h

#include "Readers/Formats/Galaxy.h"

#include <cstddef>

namespace galaxy
{
/// Pixels without light.
struct PixelCount
{
  std::size_t blank = 0;    ///< NaN, also where the file's or the user's value for blank stands
  std::size_t negative = 0; ///< below 0
};

/// Of a component's images, each taken once, as they were read: no background is subtracted and no
/// hole filled yet. Of one that is combined, the images that make it.
PixelCount countPixels(const Galaxy& galaxy, const ComponentDescription& component);
} // namespace galaxy

#endif
