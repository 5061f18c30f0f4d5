#ifndef galaxy_SkyGrid_h
#define galaxy_SkyGrid_h

#include "Filters/Model/Background.h"
#include "Readers/Formats/PixelIndex.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <memory>
#include <vector>

namespace galaxy
{
/// A rectangle of pixels on the sky, which may reach beyond the image whose coordinates it has.
/// Not thread-safe, as those are not.
struct SkyGrid
{
  std::shared_ptr<const WorldCoordinates> coordinates;
  int width = 0;
  int height = 0;
  PixelPosition shift = { 0, 0 }; ///< of the grid's pixel coordinates against `coordinates`

  bool pixelToSky(const PixelPosition& pixel, SkyPosition& sky) const
  {
    return this->coordinates->pixelToSky({ pixel.x - this->shift.x, pixel.y - this->shift.y }, sky);
  }

  bool skyToPixel(const SkyPosition& sky, PixelPosition& pixel) const
  {
    const bool found = this->coordinates->skyToPixel(sky, pixel);
    pixel = { pixel.x + this->shift.x, pixel.y + this->shift.y };
    return found;
  }

  bool contains(const PixelPosition& pixel) const
  {
    const double column = pixelIndex(pixel.x), row = pixelIndex(pixel.y);
    return column >= 0 && column < this->width && row >= 0 && row < this->height;
  }
};

/// An image ready for use: background and stars removed, bad pixels filled.
struct CleanImage
{
  SkyGrid grid;
  std::vector<float> values; ///< x fastest; NaN where blank
  SkyLevel sky;              ///< what was taken off, and how the empty sky's pixels scatter
};
} // namespace galaxy

#endif
