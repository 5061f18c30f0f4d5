#ifndef galaxy_Picture_h
#define galaxy_Picture_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Render.h"
#include "Readers/Formats/AvailableMemory.h"

#include <algorithm>
#include <limits>
#include <string>

namespace galaxy
{
/// Throws Error where so many `copies` of a picture would not fit into memory, of which `held`
/// bytes are there already.
inline void requireMemoryOfPicture(int width, int height, double copies = 1, double held = 0)
{
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  requireMemory(copies * 2 * 3 * sizeof(float) * width * height - held, "picture", "ImageSize",
    "one of " + size + " pixels", "choose a smaller one");
}

/// A black picture that hides nothing.
inline void wipe(RenderedImage& image)
{
  std::fill(image.radiance.begin(), image.radiance.end(), 0.0F);
  std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0F);
}

/// Throws Error where it would not fit into memory.
inline RenderedImage emptyPicture(const Camera& camera)
{
  requireMemoryOfPicture(camera.width, camera.height);
  RenderedImage image;
  image.width = camera.width;
  image.height = camera.height;
  const std::size_t values = 3 * std::size_t(image.width) * image.height;
  image.radiance.resize(values);
  image.transmittance.resize(values);
  wipe(image);
  return image;
}

/// As a picture has it; counts what is more than single precision holds.
inline float toSingle(double light, std::size_t& tooBright)
{
  constexpr double largest = std::numeric_limits<float>::max();
  tooBright += light > largest;
  return static_cast<float>(std::min(light, largest));
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
