#ifndef galaxy_PixelLattice_h
#define galaxy_PixelLattice_h

#include "Readers/Formats/WorldCoordinates.h"

#include <functional>
#include <vector>

namespace galaxy
{
/// A way from a plane to the pixels of an image, tabulated on a lattice over a box of the plane:
/// world coordinates are slow to follow, and one object of them serves one thread only.
///
/// The lattice is halved until the bilinear interpolation between its points is right to 0.01
/// pixel in the middle of every cell (or there are 512 x 512 cells).
class PixelLattice
{
public:
  /// Gives NaN where the plane has no pixel.
  using Way = std::function<PixelPosition(double x, double y)>;

  /// A lattice over nothing.
  PixelLattice() = default;
  PixelLattice(double left, double bottom, double right, double top, const Way& exact);

  /// NaN outside the box.
  PixelPosition at(double x, double y) const;
  /// Cells along a side; 0 for a lattice over nothing.
  int size() const { return this->cells; }

  /// What at() gives where there is no pixel.
  static PixelPosition nowhere();

private:
  void fill(const Way& exact);
  bool isFine(const Way& exact) const;

  int cells = 0;
  double left = 0, bottom = 0;
  double cellWidth = 0, cellHeight = 0;
  std::vector<PixelPosition> points; ///< (cells + 1)^2, x fastest
};
} // namespace galaxy

#endif
