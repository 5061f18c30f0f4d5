#ifndef galaxy_FootprintShare_h
#define galaxy_FootprintShare_h

#include "Filters/Splatting/Render.h"

namespace galaxy
{
/// The share of a footprint of radius h centred at (x, y) that falls on pixel (i, j), in double
/// precision by definition; the vectors of TileComposite are tested against it. A Gaussian's is
/// exact, see gaussianCumulative(); a spline's is the mean over n x n cells of four Gauss points
/// each, see SplineWeights.
double footprintShare(Kernel kernel, double x, double y, double h, int i, int j);
} // namespace galaxy

#endif
