#ifndef galaxy_PixelLattice_h
#define galaxy_PixelLattice_h

#include "Readers/Formats/WorldCoordinates.h"

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace galaxy
{
/// A way from a plane to the pixels of an image, or back, tabulated on a lattice over a box: world
/// coordinates are slow to follow, and one object of them serves one thread only.
///
/// The lattice is halved until the bilinear interpolation between its points is right to
/// `tolerance` in the middle of every cell (or there are 512 x 512 cells). Its points are rounded
/// to the share `rounding` of that or less, so that the last bits of world coordinates, which
/// differ between libraries and machines, are not seen in what is made of them.
class PixelLattice
{
public:
  /// Gives NaN where the plane has no pixel.
  using Way = std::function<PixelPosition(double x, double y)>;

  /// A lattice over nothing.
  PixelLattice() = default;
  PixelLattice(double left, double bottom, double right, double top, const Way& exact,
    double tolerance = 0.001, double rounding = 0.001);

  /// NaN outside the box.
  PixelPosition at(double x, double y) const
  {
    const Cell cell = this->cellAt(x, y);
    return cell.low ? PixelPosition{ cell.blend(&PixelPosition::x), cell.blend(&PixelPosition::y) }
                    : nowhere();
  }
  /// Cells along a side; 0 for a lattice over nothing.
  int size() const { return this->cells; }

  /// What at() gives where there is no pixel.
  static PixelPosition nowhere()
  {
    constexpr double blank = std::numeric_limits<double>::quiet_NaN();
    return { blank, blank };
  }

private:
  /// A cell's two rows of corners, and a place in it from 0 to 1.
  struct Cell
  {
    const PixelPosition* low = nullptr; ///< null outside the box
    const PixelPosition* high = nullptr;
    double p = 0, q = 0;

    double blend(double PixelPosition::*axis) const
    {
      return (1 - this->q) * ((1 - this->p) * this->low[0].*axis + this->p * this->low[1].*axis) +
        this->q * ((1 - this->p) * this->high[0].*axis + this->p * this->high[1].*axis);
    }
  };

  Cell cellAt(double x, double y) const
  {
    const double u = (x - this->left) * this->perWidth;
    const double v = (y - this->bottom) * this->perHeight;
    if (!(u >= 0 && v >= 0 && u < this->cells && v < this->cells))
    {
      return {};
    }
    const auto column = static_cast<int>(u), row = static_cast<int>(v);
    const std::size_t stride = static_cast<std::size_t>(this->cells) + 1;
    const PixelPosition* low = &this->points[row * stride + column];
    return { low, low + stride, u - column, v - row };
  }

  void fill(const Way& exact, double unit);
  bool isFine(const Way& exact, double tolerance) const;

  int cells = 0;
  double left = 0, bottom = 0;
  double cellWidth = 0, cellHeight = 0;
  double perWidth = 0, perHeight = 0; ///< their inverses
  std::vector<PixelPosition> points;  ///< (cells + 1)^2, x fastest
};
} // namespace galaxy

#endif
