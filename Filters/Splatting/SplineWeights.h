#ifndef galaxy_SplineWeights_h
#define galaxy_SplineWeights_h

#include "Filters/Splatting/TileSums.h"

namespace galaxy
{
/// The projected cubic spline on the pixels of a box: in each pixel the mean over n x n cells of
/// four Gauss points each, so many that a cell is at most h/4 wide. The sum over all pixels is 1 to
/// 3e-5.
class SplineWeights
{
public:
  /// The spline of radius h is centred at (x, y) from the box's corner; all in pixels.
  void fill(float x, float y, float h, int columns, int rows);

  alignas(64) float weights[tileSide][tileStride]; ///< 0 beyond the box's columns

private:
  /// Of the 2 n Gauss points a pixel along one axis, those that may touch the splat.
  struct Points
  {
    int first, last;
    float cell; ///< 1/n pixels
    float at(int k) const;
  };
  static Points points(float center, float h, int pixels, int n);
};
} // namespace galaxy

#endif
