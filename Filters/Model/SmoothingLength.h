#ifndef galaxy_SmoothingLength_h
#define galaxy_SmoothingLength_h

#include "Filters/Model/Particles.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Progress.h"

namespace galaxy
{
/// The smoothing lengths h of `count` particles (kpc; the radius at which a particle ends), from
/// their positions (3 numbers each) and, for Brightness alone, their intensities:
///
/// Density, Neighbours: factor times the mean distance d = (V/N)^(1/3) around each of them; d from
/// DensityGrid or neighbourDistances.
/// Constant: length.
/// Brightness: length I^p sum(I)/sum(I^(1+p)), so that the mean of h weighted by I is length; where
/// no particle has light, length. What is negative or not finite has no light.
///
/// All are kept from minimum to maximum, and positive whatever the input: a particle without light,
/// or one with no other apart from it, gets the minimum, at least 1e-9 kpc. Throws Error naming the
/// parameter that is out of range, Aborted where `progress` ends it, which Density and Neighbours
/// ask.
void smoothingLengths(const float* position, const float* intensity, std::size_t count,
  const SmoothingDescription& smoothing, float* h, const Progress& progress = {});

/// The same for the particles first to last - 1, all of one component.
void setSmoothingLengths(Particles& particles, std::size_t first, std::size_t last,
  const SmoothingDescription& smoothing, const Progress& progress = {});

/// For a component whose particles from first to placed - 1 have theirs, when more have come after
/// them: those of the others. Neighbours are then counted as Density does; Brightness, which looks
/// at the light of all, is set anew.
void smoothAmongOthers(Particles& particles, std::size_t first, std::size_t placed,
  const SmoothingDescription& smoothing);
} // namespace galaxy

#endif
