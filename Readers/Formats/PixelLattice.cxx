#include "Readers/Formats/PixelLattice.h"

#include <cmath>
#include <limits>

namespace galaxy
{
PixelPosition PixelLattice::nowhere()
{
  constexpr double blank = std::numeric_limits<double>::quiet_NaN();
  return { blank, blank };
}

PixelLattice::PixelLattice(double left, double bottom, double right, double top, const Way& exact)
  : left(left)
  , bottom(bottom)
{
  constexpr int fewestCells = 8;
  constexpr int mostCells = 512;
  if (!(right > left && top > bottom))
  {
    return;
  }
  this->cells = fewestCells;
  this->cellWidth = (right - left) / this->cells;
  this->cellHeight = (top - bottom) / this->cells;
  this->fill(exact);
  while (this->cells < mostCells && !this->isFine(exact))
  {
    this->cells *= 2;
    this->cellWidth /= 2;
    this->cellHeight /= 2;
    this->fill(exact);
  }
}

void PixelLattice::fill(const Way& exact)
{
  const std::size_t side = static_cast<std::size_t>(this->cells) + 1;
  this->points.resize(side * side);
  for (std::size_t v = 0; v < side; ++v)
  {
    for (std::size_t u = 0; u < side; ++u)
    {
      this->points[v * side + u] =
        exact(this->left + u * this->cellWidth, this->bottom + v * this->cellHeight);
    }
  }
}

bool PixelLattice::isFine(const Way& exact) const
{
  constexpr double tolerance = 0.01;
  for (int v = 0; v < this->cells; ++v)
  {
    for (int u = 0; u < this->cells; ++u)
    {
      const double x = this->left + (u + 0.5) * this->cellWidth;
      const double y = this->bottom + (v + 0.5) * this->cellHeight;
      const PixelPosition near = this->at(x, y);
      const PixelPosition far = exact(x, y);
      if (std::hypot(near.x - far.x, near.y - far.y) > tolerance)
      {
        return false;
      }
    }
  }
  return true;
}

PixelPosition PixelLattice::at(double x, double y) const
{
  const double u = (x - this->left) / this->cellWidth;
  const double v = (y - this->bottom) / this->cellHeight;
  if (!(u >= 0 && v >= 0 && u < this->cells && v < this->cells))
  {
    return nowhere();
  }
  const auto column = static_cast<std::size_t>(u);
  const auto row = static_cast<std::size_t>(v);
  const double p = u - column;
  const double q = v - row;
  const std::size_t stride = static_cast<std::size_t>(this->cells) + 1;
  const PixelPosition* lower = &this->points[row * stride + column];
  const PixelPosition* upper = lower + stride;
  const auto blend = [p, q](double p00, double p10, double p01, double p11) {
    return (1 - q) * ((1 - p) * p00 + p * p10) + q * ((1 - p) * p01 + p * p11);
  };
  return { blend(lower[0].x, lower[1].x, upper[0].x, upper[1].x),
    blend(lower[0].y, lower[1].y, upper[0].y, upper[1].y) };
}
} // namespace galaxy
