#include "Filters/Model/AutomaticCount.h"

namespace galaxy
{
double automaticCount(const LightMap& map, double beam, double noise)
{
  double sum = 0, squares = 0;
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    const double flux = map.flux(pixel);
    sum += flux;
    squares += flux * flux;
  }
  constexpr double gaussianArea = 1.1330900354567985; // pi / (4 ln 2)
  const double pixels = squares > 0 ? sum * sum / squares : 0;
  const double beams = pixels * map.pixelSide() * map.pixelSide() / (gaussianArea * beam * beam);
  return beams / (noise * noise);
}
} // namespace galaxy
