#ifndef galaxy_Spheroid_h
#define galaxy_Spheroid_h

#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/GalaxyDescription.h"

namespace galaxy
{
/// Writes `count` particles of equal light with normally distributed coordinates about the origin,
/// along the innermost ring's a, b, n or, not tilted, along X, Y, Z. They do not move.
/// The total light is centralBrightness 2 pi sigma_x sigma_y times `lightFactor`: seen along the
/// third axis, the surface brightness in the middle is centralBrightness.
void placeSpheroid(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, std::size_t count, double lightFactor, const ParticleWriter& writer);
} // namespace galaxy

#endif
