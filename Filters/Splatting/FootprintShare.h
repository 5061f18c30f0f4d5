#ifndef galaxy_FootprintShare_h
#define galaxy_FootprintShare_h

#include "Filters/Splatting/Render.h"

namespace galaxy
{
/// No footprint is drawn with a smaller radius, pixels.
inline double leastRadius(Kernel kernel)
{
  return kernel == Kernel::Gaussian ? 1e-4 : 1e-3;
}

/// The share of a footprint of radius h centred at (x, y) that falls on a pixel, in double
/// precision by definition; the vectors of TileComposite are tested against it. A Gaussian's is
/// exact, see gaussianCumulative(); a spline's is the mean over n x n cells of four Gauss points
/// each, see SplineWeights.
class FootprintShares
{
public:
  FootprintShares(Kernel kernel, double x, double y, double h);

  /// Of pixel (i, j).
  double of(int i, int j);

private:
  /// The share of column i, or of row i, and the last that was asked for.
  struct Axis
  {
    double centre;
    int pixel = 0;
    double share = -1;
  };
  double along(Axis& axis, int pixel) const;
  double splineAt(int i, int j) const;

  Kernel kernel;
  double h;
  Axis x, y;
};

/// Of one pixel.
double footprintShare(Kernel kernel, double x, double y, double h, int i, int j);
} // namespace galaxy

#endif
