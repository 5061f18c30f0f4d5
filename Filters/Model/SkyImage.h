#ifndef galaxy_SkyImage_h
#define galaxy_SkyImage_h

#include "Filters/Model/SkyGrid.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"
#include "Readers/Formats/PixelLattice.h"
#include "Readers/Formats/SkyFrame.h"

#include <vector>

namespace galaxy
{
/// A box in a galaxy's frame, kpc.
struct PlaneBox
{
  double left = 0, bottom = 0, right = 0, top = 0;
};

/// An image of the sky as seen in a galaxy's frame: the way from (X, Y) through the sky to a pixel
/// is tabulated.
class SkyImage
{
public:
  /// Only the part within `radius` kpc of the centre is looked at.
  SkyImage(CleanImage image, const SkyFrame& frame, double radius);

  /// Prepares the image as `description` asks (background, bad pixels, stars). Throws Error where
  /// it has no usable coordinates.
  SkyImage(
    const Image& image, const ImageDescription& description, const SkyFrame& frame, double radius);

  /// The value of the pixel at (X, Y) kpc; NaN outside the image and where it is blank.
  double value(double x, double y) const
  {
    const PixelPosition pixel = this->pixelAt(x, y);
    if (!this->image.grid.contains(pixel))
    {
      return PixelLattice::nowhere().x;
    }
    const auto column = static_cast<std::size_t>(pixelIndex(pixel.x));
    const auto row = static_cast<std::size_t>(pixelIndex(pixel.y));
    return this->image.values[row * this->image.grid.width + column];
  }

  /// The same, linear between the four nearest pixels' centres; of those that are not blank.
  double smoothValue(double x, double y) const;

  /// Pixel coordinates from the lattice; NaN outside the image's extent.
  PixelPosition pixelAt(double x, double y) const { return this->lattice.at(x, y); }
  /// The same through the world coordinates themselves. Not thread-safe.
  PixelPosition exactPixelAt(double x, double y) const;

  /// The prepared values, axis 1 fastest.
  const std::vector<float>& values() const { return this->image.values; }
  const SkyGrid& grid() const { return this->image.grid; }
  const SkyLevel& skyLevel() const { return this->image.sky; }
  const SkyFrame& skyFrame() const { return this->frame; }
  /// The box about the image in (X, Y) kpc, no larger than the radius it was made for.
  const PlaneBox& extent() const { return this->box; }
  /// Side of a pixel in the middle of the image, kpc.
  double pixelSide() const;
  /// Cells along a side of the lattice.
  int latticeSize() const { return this->lattice.size(); }

private:
  PlaneBox boxWithin(double radius) const;

  SkyFrame frame;
  CleanImage image;
  PlaneBox box;
  PixelLattice lattice;
};
} // namespace galaxy

#endif
