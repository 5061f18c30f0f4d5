#include "Filters/Model/Regrid.h"

#include "Filters/Model/ParallelFor.h"
#include "Readers/Formats/PixelLattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// Adds a value of the image between its pixels; blank pixels pass their weight to the others.
class Sampler
{
public:
  explicit Sampler(const CleanImage& image)
    : image(image)
  {
  }

  void add(const PixelPosition& pixel)
  {
    ++this->points;
    const SkyGrid& grid = this->image.grid;
    if (!grid.contains(pixel))
    {
      return;
    }
    const double x = std::clamp(pixel.x - 1, 0.0, grid.width - 1.0);
    const double y = std::clamp(pixel.y - 1, 0.0, grid.height - 1.0);
    const int column = std::min(static_cast<int>(x), std::max(grid.width - 2, 0));
    const int row = std::min(static_cast<int>(y), std::max(grid.height - 2, 0));
    const double p = x - column, q = y - row;
    this->take(column, row, (1 - p) * (1 - q));
    this->take(column + 1, row, p * (1 - q));
    this->take(column, row + 1, (1 - p) * q);
    this->take(column + 1, row + 1, p * q);
  }

  double mean() const
  {
    return this->weights > 0 && this->weights >= 0.5 * this->points
      ? this->sum / this->weights
      : std::numeric_limits<double>::quiet_NaN();
  }

private:
  void take(int column, int row, double weight)
  {
    if (!(weight > 0))
    {
      return;
    }
    const double value =
      this->image.values[static_cast<std::size_t>(row) * this->image.grid.width + column];
    if (std::isfinite(value))
    {
      this->sum += weight * value;
      this->weights += weight;
    }
  }

  const CleanImage& image;
  double sum = 0;
  double weights = 0;
  int points = 0;
};

PixelLattice wayBetween(const SkyGrid& from, const SkyGrid& to)
{
  return PixelLattice(
    0.5, 0.5, from.width + 0.5, from.height + 0.5, [&from, &to](double x, double y) {
      SkyPosition sky;
      PixelPosition pixel;
      return from.pixelToSky({ x, y }, sky) && to.skyToPixel(sky, pixel) ? pixel
                                                                         : PixelLattice::nowhere();
    });
}

/// The mean of the image over one pixel of the grid, which `way` takes to the image's pixels.
double pixelMean(const CleanImage& image, const PixelLattice& way, double x, double y)
{
  constexpr int mostPoints = 64; // a side
  // The last column and row end where the lattice does.
  const double side = 0.499;
  const PixelPosition west = way.at(x - side, y), east = way.at(x + side, y);
  const PixelPosition south = way.at(x, y - side), north = way.at(x, y + side);
  const double extent = std::max(
    std::hypot(east.x - west.x, east.y - west.y), std::hypot(north.x - south.x, north.y - south.y));
  if (!std::isfinite(extent))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const int count = std::clamp(static_cast<int>(std::ceil(3 * extent)), 1, mostPoints);
  Sampler sampler(image);
  for (int v = 0; v < count; ++v)
  {
    for (int u = 0; u < count; ++u)
    {
      sampler.add(way.at(x + (u + 0.5) / count - 0.5, y + (v + 0.5) / count - 0.5));
    }
  }
  return sampler.mean();
}
} // namespace

std::vector<float> regrid(const CleanImage& image, const SkyGrid& grid)
{
  const PixelLattice way = wayBetween(grid, image.grid);
  std::vector<float> values(static_cast<std::size_t>(grid.width) * grid.height);
  parallelForDynamic<int>(0, grid.height, 16, [&](int row) {
    for (int column = 0; column < grid.width; ++column)
    {
      values[static_cast<std::size_t>(row) * grid.width + column] =
        static_cast<float>(pixelMean(image, way, column + 1, row + 1));
    }
  });
  return values;
}
} // namespace galaxy
