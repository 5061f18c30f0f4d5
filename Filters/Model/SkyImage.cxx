#include "Filters/Model/SkyImage.h"

#include "Filters/Model/ImageCleaning.h"
#include "Readers/Formats/Rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
SkyImage::SkyImage(CleanImage clean, const SkyFrame& frame, double radius)
  : frame(frame)
  , image(std::move(clean))
  , box(this->boxWithin(radius))
  , lattice(this->box.left, this->box.bottom, this->box.right, this->box.top,
      [this](double x, double y) { return this->exactPixelAt(x, y); })
{
}

SkyImage::SkyImage(
  const Image& image, const ImageDescription& description, const SkyFrame& frame, double radius)
  : SkyImage(cleanedImage(image, description), frame, radius)
{
}

// Over the box around the image in (X, Y), from points all over it, and no larger than the galaxy.
PlaneBox SkyImage::boxWithin(double radius) const
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
  // Nor has the box the last bits of the image's coordinates.
  const double unit = roundingUnit(1e-6 * std::max(right - left, top - bottom));
  const auto rounded = [unit, radius](double side) {
    return std::clamp(roundedTo(unit, side), -radius, radius);
  };
  return { rounded(left - marginX), rounded(bottom - marginY), rounded(right + marginX),
    rounded(top + marginY) };
}

PixelPosition SkyImage::exactPixelAt(double x, double y) const
{
  PixelPosition pixel;
  return this->image.grid.skyToPixel(this->frame.planeToSky(x, y), pixel) ? pixel
                                                                          : PixelLattice::nowhere();
}

double SkyImage::smoothValue(double x, double y) const
{
  const PixelPosition at = this->pixelAt(x, y);
  if (!this->image.grid.contains(at))
  {
    return PixelLattice::nowhere().x;
  }
  const int width = this->image.grid.width, height = this->image.grid.height;
  const double left = std::floor(at.x), low = std::floor(at.y);
  double base = 0, sum = 0, weights = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const int dx = corner & 1, dy = corner >> 1;
    const int column = std::clamp(static_cast<int>(left) - 1 + dx, 0, width - 1);
    const int row = std::clamp(static_cast<int>(low) - 1 + dy, 0, height - 1);
    const double weight = (1 - std::abs(at.x - left - dx)) * (1 - std::abs(at.y - low - dy));
    const float value = this->image.values[static_cast<std::size_t>(row) * width + column];
    if (std::isfinite(value))
    {
      // Differences, so that between equal values there is no other.
      base = weights > 0 ? base : value;
      sum += weight * (value - base);
      weights += weight;
    }
  }
  // In the middle of a blank pixel nothing is left but rounding.
  return weights > borderWidth ? base + sum / weights : PixelLattice::nowhere().x;
}

double SkyImage::pixelSide() const
{
  const SkyGrid& grid = this->image.grid;
  const double middleX = 0.5 * (grid.width + 1), middleY = 0.5 * (grid.height + 1);
  const auto pointAt = [&](double dx, double dy) {
    SkyPosition sky;
    double x = 0, y = 0;
    return grid.pixelToSky({ middleX + dx, middleY + dy }, sky) && this->frame.skyToPlane(sky, x, y)
      ? Vec3{ x, y, 0 }
      : Vec3{ PixelLattice::nowhere().x, 0, 0 };
  };
  const Vec3 right = pointAt(0.5, 0) - pointAt(-0.5, 0);
  const Vec3 up = pointAt(0, 0.5) - pointAt(0, -0.5);
  return std::sqrt(std::abs(cross(right, up).z));
}
} // namespace galaxy
