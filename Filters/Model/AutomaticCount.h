#ifndef galaxy_AutomaticCount_h
#define galaxy_AutomaticCount_h

#include "Filters/Model/LightMap.h"

namespace galaxy
{
/// How many seeds make the light in a beam noisy by no more than `noise`, from any side: each beam
/// of `beam` kpc (full width at half maximum) on `area` kpc^2 of the sky gets noise^-2 seeds, whose
/// number scatters by no more than its root. From Earth, where seeds are spread evenly and pixels
/// normalised, the noise is smaller: there it is an upper bound.
double automaticCount(double area, double beam, double noise);

/// The area that the light which shows the disc would have if all its pixels were equal, kpc^2:
/// (sum F)^2/sum F^2 pixels. Seeds drawn in proportion to the light are as dense as on that.
double effectiveArea(const LightMap& map, const DiskInverse& inverse);
} // namespace galaxy

#endif
