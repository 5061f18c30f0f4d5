#include "Filters/Model/SightLines.h"

#include <algorithm>

namespace galaxy
{
void moveToSightLines(double distance, Particles& particles, std::size_t first, std::size_t last)
{
#pragma omp parallel for schedule(static)
  for (std::size_t i = first; i < last; ++i)
  {
    float* p = &particles.position[3 * i];
    const double f = nearness(distance, p[2]);
    p[0] = static_cast<float>(f * p[0]);
    p[1] = static_cast<float>(f * p[1]);
    particles.smoothingLength[i] = static_cast<float>(f * particles.smoothingLength[i]);
    particles.intensity[i] = static_cast<float>(f * f * particles.intensity[i]);
  }
}

bool hasDiskWithImages(const GalaxyDescription& galaxy)
{
  return std::any_of(
    galaxy.components.begin(), galaxy.components.end(), [](const ComponentDescription& component) {
      return component.type == ComponentType::Disk && usesImages(component);
    });
}
} // namespace galaxy
