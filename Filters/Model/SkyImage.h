#ifndef galaxy_SkyImage_h
#define galaxy_SkyImage_h

#include "Filters/Model/SkyFrame.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <vector>

namespace galaxy
{
/// An image of the sky as seen in a galaxy's frame.
///
/// The way from (X, Y) through the sky to a pixel is tabulated on a square lattice over the image,
/// which is halved until the bilinear interpolation between its points is right to 0.01 pixel in
/// the middle of every cell (or there are 512 x 512 cells).
class SkyImage
{
public:
  /// Prepares the image as `description` asks (background, stars); only the part within `radius`
  /// kpc of the centre is looked at. Throws Error where the image has no usable coordinates.
  SkyImage(
    const Image& image, const ImageDescription& description, const SkyFrame& frame, double radius);

  /// The value of the pixel at (X, Y) kpc; NaN outside the image and where it is blank.
  double value(double x, double y) const
  {
    const PixelPosition pixel = this->pixelAt(x, y);
    if (!(pixel.x >= 0.5 && pixel.x < this->width + 0.5 && pixel.y >= 0.5 &&
          pixel.y < this->height + 0.5))
    {
      return this->blank();
    }
    const auto column = static_cast<std::size_t>(pixel.x - 0.5);
    const auto row = static_cast<std::size_t>(pixel.y - 0.5);
    return this->cleaned[row * this->width + column];
  }

  /// Pixel coordinates from the lattice; NaN outside the image's extent.
  PixelPosition pixelAt(double x, double y) const;
  /// The same through the world coordinates themselves. Not thread-safe.
  PixelPosition exactPixelAt(double x, double y) const;

  /// The prepared values, axis 1 fastest.
  const std::vector<float>& values() const { return this->cleaned; }
  /// Cells along a side of the lattice.
  int latticeSize() const { return this->cells; }

private:
  static double blank();
  bool findExtent(double radius);
  void fillLattice();
  bool latticeIsFine() const;

  SkyFrame frame;
  WorldCoordinates coordinates;
  int width;
  int height;
  std::vector<float> cleaned;
  int cells = 8;
  double left = 0, bottom = 0;          ///< kpc
  double cellWidth = 0, cellHeight = 0; ///< kpc
  std::vector<PixelPosition> lattice;   ///< (cells + 1)^2, X fastest
};
} // namespace galaxy

#endif
