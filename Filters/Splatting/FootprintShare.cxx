#include "Filters/Splatting/FootprintShare.h"

#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/GaussianKernel.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// The share of a Gaussian's light in pixel (i, j).
double gaussianShare(double x, double y, double h, int i, int j)
{
  const double a = 3 / std::max(h, 1e-4);
  const auto along = [a](double from) {
    return gaussianCumulative(a * (from + 1)) - gaussianCumulative(a * from);
  };
  return along(i - x) * along(j - y);
}

/// The share of a spline disc's light in pixel (i, j), see SplineWeights.
double splineShare(double x, double y, double h, int i, int j)
{
  h = std::max(h, 1e-3);
  const int n = static_cast<int>(std::ceil(std::max(1.0, 4 / h)));
  const int x0 = std::max(0, static_cast<int>((x - h - i) * n) - 1);
  const int x1 = std::min(n, static_cast<int>((x + h - i) * n) + 2);
  const int y0 = std::max(0, static_cast<int>((y - h - j) * n) - 1);
  const int y1 = std::min(n, static_cast<int>((y + h - j) * n) + 2);
  const double gauss = 1 / std::sqrt(12.0);
  double sum = 0;
  for (int row = y0; row < y1; ++row)
  {
    for (int column = x0; column < x1; ++column)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        const double dx = i + (column + 0.5 + (corner & 1 ? gauss : -gauss)) / n - x;
        const double dy = j + (row + 0.5 + (corner & 2 ? gauss : -gauss)) / n - y;
        sum += projectedCubicSpline(std::hypot(dx, dy) / h);
      }
    }
  }
  return sum / (4.0 * n * n * h * h);
}
} // namespace

double footprintShare(Kernel kernel, double x, double y, double h, int i, int j)
{
  return kernel == Kernel::Gaussian ? gaussianShare(x, y, h, i, j) : splineShare(x, y, h, i, j);
}
} // namespace galaxy
