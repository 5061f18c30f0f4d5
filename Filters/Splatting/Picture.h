#ifndef galaxy_Picture_h
#define galaxy_Picture_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Render.h"

#include <algorithm>

namespace galaxy
{
/// A black picture that hides nothing.
inline void wipe(RenderedImage& image)
{
  std::fill(image.radiance.begin(), image.radiance.end(), 0.0F);
  std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0F);
}

inline RenderedImage emptyPicture(const Camera& camera)
{
  RenderedImage image;
  image.width = camera.width;
  image.height = camera.height;
  const std::size_t values = 3 * std::size_t(image.width) * image.height;
  image.radiance.resize(values);
  image.transmittance.resize(values);
  wipe(image);
  return image;
}

/// Says what became of the particles; a picture that was given up is empty.
inline void finishPicture(
  const ParticleCounts& counts, const OrderNeeds& tiles, bool aborted, RenderedImage& image)
{
  image.aborted = aborted;
  if (aborted)
  {
    wipe(image);
  }
  static_cast<ParticleCounts&>(image.statistics) = counts;
  image.statistics.tiles = tiles;
}
} // namespace galaxy

#endif
