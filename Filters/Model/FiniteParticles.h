#ifndef galaxy_FiniteParticles_h
#define galaxy_FiniteParticles_h

#include "Filters/Model/Particles.h"

namespace galaxy
{
/// Throws Error (file, component) where the place, light or velocity of one of the particles
/// [first, last) is no finite number: numbers of the description that are fine by themselves can be
/// too large together.
void requireFinite(const Particles& particles, std::size_t first, std::size_t last,
  const std::string& file, const std::string& component);
/// The same of the smoothing lengths, which are found last.
void requireFiniteLengths(const Particles& particles, std::size_t first, std::size_t last,
  const std::string& file, const std::string& component);
} // namespace galaxy

#endif
