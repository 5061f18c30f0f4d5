#include "Filters/Model/FiniteParticles.h"

#include "Readers/Formats/Error.h"

#include <cmath>

namespace galaxy
{
namespace
{
bool areFinite(const Buffer<float>& values, std::size_t first, std::size_t last)
{
  bool finite = true;
#pragma omp parallel for schedule(static) reduction(&& : finite)
  for (std::size_t i = first; i < last; ++i)
  {
    finite = finite && std::isfinite(values[i]);
  }
  return finite;
}

void require(bool finite, const char* what, const std::string& file, const std::string& component)
{
  if (!finite)
  {
    throw Error(file, component,
      std::string("the ") + what +
        " of a particle is no finite number; give smaller lengths, factors or velocities");
  }
}
} // namespace

void requireFinite(const Particles& particles, std::size_t first, std::size_t last,
  const std::string& file, const std::string& component)
{
  require(areFinite(particles.position, 3 * first, 3 * last), "place", file, component);
  require(areFinite(particles.intensity, first, last), "light", file, component);
  require(particles.velocity.empty() || areFinite(particles.velocity, 3 * first, 3 * last),
    "velocity", file, component);
}

void requireFiniteLengths(const Particles& particles, std::size_t first, std::size_t last,
  const std::string& file, const std::string& component)
{
  require(areFinite(particles.smoothingLength, first, last), "smoothing length", file, component);
}
} // namespace galaxy
