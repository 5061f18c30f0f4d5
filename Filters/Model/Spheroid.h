#ifndef galaxy_Spheroid_h
#define galaxy_Spheroid_h

#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/GalaxyDescription.h"

namespace galaxy
{
/// Writes `count` particles of equal light where the spheroid's density, or its star clusters, have
/// them. Particle i of a smooth spheroid is the same for any count. They move at random with
/// component.velocityDispersion on each axis.
void placeSpheroid(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, std::size_t count, double lightFactor, const ParticleWriter& writer);

/// The whole light of a spheroid, intensity times kpc^2: its luminosity where given, else what
/// makes the surface brightness seen along the third axis centralBrightness: at the centre, or
/// where RadialProfile::brightnessRadius() says.
double spheroidLight(const TiltedDisk& disk, const SpheroidDescription& spheroid);
} // namespace galaxy

#endif
