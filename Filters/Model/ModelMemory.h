#ifndef galaxy_ModelMemory_h
#define galaxy_ModelMemory_h

#include "Filters/Model/BuildOptions.h"
#include "Filters/Model/Particles.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <cstddef>
#include <string>
#include <vector>

namespace galaxy
{
/// The least that the models of all galaxies together take: a particle for every seed asked for,
/// and the seeds themselves; a component of particles = "Auto" counts nothing. Throws Error naming
/// the first component that does not fit into availableMemory(), where `copies` of all particles
/// will be there at once.
void requireMemoryFor(const std::vector<const GalaxyDescription*>& galaxies,
  const BuildOptions& options, double copies = 1);

/// Makes room for so many more particles of a component. Throws Error (file, component) unless they
/// fit into availableMemory() with what finding their smoothing lengths takes.
void addParticles(std::size_t count, const BuildOptions& options, const std::string& file,
  const ComponentDescription& component, Particles& particles);
} // namespace galaxy

#endif
