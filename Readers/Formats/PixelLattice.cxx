#include "Readers/Formats/PixelLattice.h"

#include "Readers/Formats/Rounding.h"

#include <cmath>

namespace galaxy
{
PixelLattice::PixelLattice(double left, double bottom, double right, double top, const Way& exact,
  double tolerance, double rounding)
  : left(left)
  , bottom(bottom)
{
  constexpr int fewestCells = 8;
  constexpr int mostCells = 512;
  if (!(right > left && top > bottom))
  {
    return;
  }
  const double unit = roundingUnit(rounding * tolerance);
  this->cells = fewestCells;
  this->cellWidth = (right - left) / this->cells;
  this->cellHeight = (top - bottom) / this->cells;
  this->fill(exact, unit);
  while (this->cells < mostCells && !this->isFine(exact, tolerance))
  {
    this->cells *= 2;
    this->cellWidth /= 2;
    this->cellHeight /= 2;
    this->fill(exact, unit);
  }
}

void PixelLattice::fill(const Way& exact, double unit)
{
  this->perWidth = 1 / this->cellWidth;
  this->perHeight = 1 / this->cellHeight;
  const std::size_t side = static_cast<std::size_t>(this->cells) + 1;
  this->points.resize(side * side);
  for (std::size_t v = 0; v < side; ++v)
  {
    for (std::size_t u = 0; u < side; ++u)
    {
      const PixelPosition point =
        exact(this->left + u * this->cellWidth, this->bottom + v * this->cellHeight);
      this->points[v * side + u] = { roundedTo(unit, point.x), roundedTo(unit, point.y) };
    }
  }
}

bool PixelLattice::isFine(const Way& exact, double tolerance) const
{
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
} // namespace galaxy
