#ifndef galaxy_DustFilaments_h
#define galaxy_DustFilaments_h

#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Thickness.h"

namespace galaxy
{
/// Dust by its model: a random walk that leaves a filament at every seed, or fractal clouds
/// (FractalDust).
///
/// Filaments: from every seed a random walk of up to `steps` particles, the first above or
/// below the seed itself, in the coordinates (R, theta, z) of the rings, so that they follow the
/// warp.
///
/// In the plane a filament moves with the rotation velocity plus a peculiar velocity u, an
/// Ornstein-Uhlenbeck process of dispersion sigma_v and rate gamma = 1/damping_time. RingVelocity
/// freezes the rotation velocity vector of the seed (straight filaments), DiskRotation takes
/// that of the current place (filaments along the rotation). Every step lasts
/// dt = step_length / sqrt(v_rot^2 + 2 sigma_v^2), v_rot at the seed.
/// Across the plane it is a damped oscillator in thermal equilibrium, of frequency
/// nu = sigma_w / h_d, by the BAOAB scheme (Leimkuhler & Matthews 2013), whose heights have the rms
/// h_d whatever the step, as long as nu dt < 2.
/// A filament ends where it would leave the radii its seeds were drawn from. Of the normal law of
/// the heights what lies below normalFocalHeight is used: a height keeps its share of that. The
/// particles of a filament share the seed's light equally; their velocity is
/// that of the disc and the peculiar one in the plane (u) and across it (w).

/// Throws Error (file, component) naming the key that is out of range, and where a step could have
/// nu dt > 1, or no length in time.
void requireStableFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const std::string& file);

/// How many particles every seed gets. A filament is only walked where an edge is within reach of
/// the largest normal deviates.
ParticleStarts countFilaments(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key);

/// Writes the particles, their light being `lightFactor` times the seeds'. `starts` must come from
/// countFilaments with the same arguments.
void placeFilaments(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer);
} // namespace galaxy

#endif
