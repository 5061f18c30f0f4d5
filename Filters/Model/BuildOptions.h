#ifndef galaxy_BuildOptions_h
#define galaxy_BuildOptions_h

#include "Readers/Formats/Progress.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace galaxy
{
/// What the user of a model chooses beside its description.
struct BuildOptions
{
  double particleScale = 1; ///< factor on every component's `particles`
  std::uint64_t seed = 1;   ///< of the random numbers
  bool velocities = false;  ///< fill Particles::velocity
  /// Side of the pixels that the model will be seen with, kpc: components of particles = "Auto"
  /// are made no finer than that. 0: as fine as their images.
  double viewPixel = 0;
  Progress progress; ///< what it ends throws Aborted
};

/// Throws Error (file) naming ParticleScale or ViewPixel, as the filters call them, where the value
/// is not 0 to 1e30.
void requireUsable(const BuildOptions& options, const std::string& file);

/// `particles` times the scale; at least 1, lest a component's light be lost, but where no
/// particles are asked for at all. Throws Error (file, ParticleScale) where there would be too
/// many.
std::size_t scaledCount(const BuildOptions& options, double particles, const std::string& file,
  const std::string& component);
} // namespace galaxy

#endif
