#include "Filters/Model/SkyImage.h"

#include "Filters/Model/ImageCleaning.h"

#include <algorithm>
#include <limits>

namespace galaxy
{
SkyImage::SkyImage(CleanImage clean, const SkyFrame& frame, double radius)
  : frame(frame)
  , image(std::move(clean))
  , lattice(this->latticeWithin(radius))
{
}

SkyImage::SkyImage(
  const Image& image, const ImageDescription& description, const SkyFrame& frame, double radius)
  : SkyImage(cleanedImage(image, description), frame, radius)
{
}

// Over the box around the image in (X, Y), from points all over it, and no larger than the galaxy.
PixelLattice SkyImage::latticeWithin(double radius) const
{
  constexpr int probes = 32;
  const SkyGrid& grid = this->image.grid;
  double right = -std::numeric_limits<double>::infinity();
  double top = right, left = -right, bottom = -right;
  for (int v = 0; v <= probes; ++v)
  {
    for (int u = 0; u <= probes; ++u)
    {
      SkyPosition sky;
      double x, y;
      if (grid.pixelToSky(
            { 0.5 + u * double(grid.width) / probes, 0.5 + v * double(grid.height) / probes },
            sky) &&
        this->frame.skyToPlane(sky, x, y))
      {
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
      }
    }
  }
  // The outline may bulge between the probes: one part in `probes` to every side is more than that.
  const double marginX = (right - left) / probes;
  const double marginY = (top - bottom) / probes;
  return PixelLattice(std::max(left - marginX, -radius), std::max(bottom - marginY, -radius),
    std::min(right + marginX, radius), std::min(top + marginY, radius),
    [this](double x, double y) { return this->exactPixelAt(x, y); });
}

PixelPosition SkyImage::exactPixelAt(double x, double y) const
{
  PixelPosition pixel;
  return this->image.grid.skyToPixel(this->frame.planeToSky(x, y), pixel) ? pixel
                                                                          : PixelLattice::nowhere();
}
} // namespace galaxy
