#ifndef galaxy_SmoothingLength_h
#define galaxy_SmoothingLength_h

#include "Filters/Model/Thickness.h"
#include "Readers/Formats/GalaxyDescription.h"

namespace galaxy
{
/// The smoothing length h of all particles of a component (kpc): component.smoothingLength where
/// positive, otherwise 1.5 times the mean distance d of its particles, by the light they carry.
///
/// Disc: a particle has the area A = (area of a draw)/(children of its seed) and the volume
/// d^3 = A max(T, sqrt A); T = 2 sqrt(pi) rms(z) is the thickness of the slab that has the mean
/// density of a Gaussian layer. d is the light-weighted mean over (at most 65536) seeds.
double diskSmoothingLength(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component);

/// Filaments: twice the step, so that neighbours along a filament merge.
double filamentSmoothingLength(const ComponentDescription& component);

/// Spheroid: A = 4 pi sigma_x sigma_y, the volume A max(2 sqrt(pi) sigma_z, sqrt(A/N)), of N
/// particles: the one that has the mean density of a Gaussian.
double spheroidSmoothingLength(const ComponentDescription& component, std::size_t count);
} // namespace galaxy

#endif
