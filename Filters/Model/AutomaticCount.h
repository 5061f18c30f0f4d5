#ifndef galaxy_AutomaticCount_h
#define galaxy_AutomaticCount_h

#include "Filters/Model/LightMap.h"

namespace galaxy
{
/// How many seeds make the light in a beam, where the light is, noisy by no more than `noise`: the
/// light is as in (sum F)^2/sum F^2 pixels of equal flux; each beam of `beam` kpc (full width at
/// half maximum) of that area gets noise^-2 seeds.
double automaticCount(const LightMap& map, double beam, double noise);
} // namespace galaxy

#endif
