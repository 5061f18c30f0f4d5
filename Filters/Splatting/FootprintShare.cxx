#include "Filters/Splatting/FootprintShare.h"

#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/GaussianKernel.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Cells of a pixel along an axis that a footprint reaches.
struct Cells
{
  int first, last;

  Cells(double centre, double h, int pixel, int n)
  {
    const auto inPixel = [n](double cell) {
      return static_cast<int>(std::clamp(cell, 0.0, double(n)));
    };
    this->first = inPixel((centre - h - pixel) * n - 1);
    this->last = inPixel((centre + h - pixel) * n + 2);
  }
};
} // namespace

FootprintShares::FootprintShares(Kernel kernel_, double x_, double y_, double h_)
  : kernel(kernel_)
  , h(std::max(h_, leastRadius(kernel_)))
  , x{ x_ }
  , y{ y_ }
{
}

double FootprintShares::of(int i, int j)
{
  return this->kernel == Kernel::Gaussian ? this->along(this->x, i) * this->along(this->y, j)
                                          : this->splineAt(i, j);
}

double FootprintShares::along(Axis& axis, int pixel) const
{
  if (axis.share < 0 || axis.pixel != pixel)
  {
    const double a = 3 / this->h, from = pixel - axis.centre;
    axis.pixel = pixel;
    axis.share = gaussianCumulative(a * (from + 1)) - gaussianCumulative(a * from);
  }
  return axis.share;
}

double FootprintShares::splineAt(int i, int j) const
{
  const int n = static_cast<int>(std::ceil(std::max(1.0, 4 / this->h)));
  const Cells columns(this->x.centre, this->h, i, n), rows(this->y.centre, this->h, j, n);
  const double gauss = 1 / std::sqrt(12.0);
  double sum = 0;
  for (int row = rows.first; row < rows.last; ++row)
  {
    for (int column = columns.first; column < columns.last; ++column)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        const double dx = i + (column + 0.5 + (corner & 1 ? gauss : -gauss)) / n - this->x.centre;
        const double dy = j + (row + 0.5 + (corner & 2 ? gauss : -gauss)) / n - this->y.centre;
        sum += projectedCubicSpline(std::hypot(dx, dy) / this->h);
      }
    }
  }
  return sum / (4.0 * n * n * this->h * this->h);
}

double footprintShare(Kernel kernel, double x, double y, double h, int i, int j)
{
  return FootprintShares(kernel, x, y, h).of(i, j);
}
} // namespace galaxy
