#include "Filters/Model/SkyImage.h"

#include "Filters/Model/ImageCleaning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
WorldCoordinates coordinatesOf(const Image& image, const ImageDescription& description)
{
  return description.suppliesCoordinates
    ? WorldCoordinates(description.coordinates, image.width, image.height)
    : WorldCoordinates(image.file, image.cards, image.width, image.height);
}
} // namespace

SkyImage::SkyImage(
  const Image& image, const ImageDescription& description, const SkyFrame& frame, double radius)
  : frame(frame)
  , coordinates(coordinatesOf(image, description))
  , width(image.width)
  , height(image.height)
  , cleaned(cleanedValues(image, description))
{
  constexpr int mostCells = 512;
  if (!this->findExtent(radius))
  {
    this->cells = 0;
    return;
  }
  this->fillLattice();
  while (this->cells < mostCells && !this->latticeIsFine())
  {
    this->cells *= 2;
    this->cellWidth /= 2;
    this->cellHeight /= 2;
    this->fillLattice();
  }
}

double SkyImage::blank()
{
  return std::numeric_limits<double>::quiet_NaN();
}

// The box around the image in (X, Y), from points all over it, and no larger than the galaxy.
bool SkyImage::findExtent(double radius)
{
  constexpr int probes = 32;
  double right = -std::numeric_limits<double>::infinity();
  double top = right;
  this->left = this->bottom = -right;
  for (int v = 0; v <= probes; ++v)
  {
    for (int u = 0; u <= probes; ++u)
    {
      SkyPosition sky;
      double x, y;
      if (this->coordinates.pixelToSky(
            { 0.5 + u * double(this->width) / probes, 0.5 + v * double(this->height) / probes },
            sky) &&
        this->frame.skyToPlane(sky, x, y))
      {
        this->left = std::min(this->left, x);
        right = std::max(right, x);
        this->bottom = std::min(this->bottom, y);
        top = std::max(top, y);
      }
    }
  }
  // The outline may bulge between the probes: one part in `probes` to every side is more than that.
  const double marginX = (right - this->left) / probes;
  const double marginY = (top - this->bottom) / probes;
  this->left = std::max(this->left - marginX, -radius);
  right = std::min(right + marginX, radius);
  this->bottom = std::max(this->bottom - marginY, -radius);
  top = std::min(top + marginY, radius);
  this->cellWidth = (right - this->left) / this->cells;
  this->cellHeight = (top - this->bottom) / this->cells;
  return this->cellWidth > 0 && this->cellHeight > 0;
}

void SkyImage::fillLattice()
{
  const std::size_t points = static_cast<std::size_t>(this->cells) + 1;
  this->lattice.resize(points * points);
  for (std::size_t v = 0; v < points; ++v)
  {
    for (std::size_t u = 0; u < points; ++u)
    {
      this->lattice[v * points + u] =
        this->exactPixelAt(this->left + u * this->cellWidth, this->bottom + v * this->cellHeight);
    }
  }
}

bool SkyImage::latticeIsFine() const
{
  constexpr double tolerance = 0.01;
  for (int v = 0; v < this->cells; ++v)
  {
    for (int u = 0; u < this->cells; ++u)
    {
      const double x = this->left + (u + 0.5) * this->cellWidth;
      const double y = this->bottom + (v + 0.5) * this->cellHeight;
      const PixelPosition near = this->pixelAt(x, y);
      const PixelPosition exact = this->exactPixelAt(x, y);
      if (std::hypot(near.x - exact.x, near.y - exact.y) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

PixelPosition SkyImage::exactPixelAt(double x, double y) const
{
  PixelPosition pixel;
  return this->coordinates.skyToPixel(this->frame.planeToSky(x, y), pixel)
    ? pixel
    : PixelPosition{ blank(), blank() };
}

PixelPosition SkyImage::pixelAt(double x, double y) const
{
  const double u = (x - this->left) / this->cellWidth;
  const double v = (y - this->bottom) / this->cellHeight;
  if (!(u >= 0 && v >= 0 && u < this->cells && v < this->cells))
  {
    return { blank(), blank() };
  }
  const auto column = static_cast<std::size_t>(u);
  const auto row = static_cast<std::size_t>(v);
  const double p = u - column;
  const double q = v - row;
  const std::size_t stride = static_cast<std::size_t>(this->cells) + 1;
  const PixelPosition* lower = &this->lattice[row * stride + column];
  const PixelPosition* upper = lower + stride;
  const auto blend = [p, q](double p00, double p10, double p01, double p11) {
    return (1 - q) * ((1 - p) * p00 + p * p10) + q * ((1 - p) * p01 + p * p11);
  };
  return { blend(lower[0].x, lower[1].x, upper[0].x, upper[1].x),
    blend(lower[0].y, lower[1].y, upper[0].y, upper[1].y) };
}
} // namespace galaxy
