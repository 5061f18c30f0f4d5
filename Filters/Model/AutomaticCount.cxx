#include "Filters/Model/AutomaticCount.h"

namespace galaxy
{
double automaticCount(double area, double beam, double noise)
{
  constexpr double gaussianArea = 1.1330900354567985; // pi / (4 ln 2)
  return area / (gaussianArea * beam * beam * noise * noise);
}

double effectiveArea(const LightMap& map, const DiskInverse& inverse)
{
  double sum = 0, squares = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    const double flux = map.isLitOn(inverse, pixel) ? map.flux(pixel) : 0;
    sum += flux;
    squares += flux * flux;
  }
  return squares > 0 ? sum * sum / squares * map.pixelSide() * map.pixelSide() : 0;
}
} // namespace galaxy
