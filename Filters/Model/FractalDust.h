#ifndef galaxy_FractalDust_h
#define galaxy_FractalDust_h

#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Thickness.h"

namespace galaxy
{
/// Clouds of dust (DustModel::Fractal): every seed gets `children` particles, the first above or
/// below the seed itself, the others displaced in the plane by normal deviates of rms `spread` as
/// well; heights are normal with the rms `scale_height`, see keptBelowFocus. A particle that
/// would leave the radii its seeds were drawn from stays above its seed.
///
/// A particle's light goes as its seed's and the density of FractalClouds: clouds take it from seed
/// to seed, and none is lost. With NormalizeAt::Child the images divide it anew afterwards, pixel
/// by pixel: clouds wider than a pixel then show from elsewhere, but not from Earth.
ParticleStarts countFractalDust(const Seeds& seeds, const ComponentDescription& component);

/// Writes them, their light being `lightFactor` times the seeds' in sum.
void placeFractalDust(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer);
} // namespace galaxy

#endif
