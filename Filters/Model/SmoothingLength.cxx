#include "Filters/Model/SmoothingLength.h"

#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double lengthsPerDistance = 1.5;

double meanDistance(double area, double thickness)
{
  return std::cbrt(area * std::max(thickness, std::sqrt(area)));
}
} // namespace

double diskSmoothingLength(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component)
{
  if (component.smoothingLength > 0)
  {
    return component.smoothingLength;
  }
  const ThicknessProfile profile(component.thickness, disk);
  const double perScaleHeight = 2 * std::sqrt(pi) * rmsHeight(profile.law());
  const std::size_t stride = seeds.size() / 65536 + 1;
  double light = 0;
  double sum = 0;
  for (std::size_t i = 0; i < seeds.size(); i += stride)
  {
    const double area = seeds.areaPerDraw() / (starts[i + 1] - starts[i]);
    const double thickness = perScaleHeight * profile.scaleHeight(seeds.radius[i]);
    sum += seeds.light[i] * meanDistance(area, thickness);
    light += seeds.light[i];
  }
  return light > 0 ? lengthsPerDistance * sum / light : 0;
}

double filamentSmoothingLength(const ComponentDescription& component)
{
  return component.smoothingLength > 0 ? component.smoothingLength : 2 * component.dust.stepLength;
}

double spheroidSmoothingLength(const ComponentDescription& component, std::size_t count)
{
  if (component.smoothingLength > 0 || count == 0)
  {
    return component.smoothingLength;
  }
  const std::array<double, 3>& sigma = component.spheroid.sigma;
  const double area = 4 * pi * sigma[0] * sigma[1] / count;
  return lengthsPerDistance * meanDistance(area, 2 * std::sqrt(pi) * sigma[2]);
}
} // namespace galaxy
