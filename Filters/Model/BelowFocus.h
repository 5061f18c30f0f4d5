#ifndef galaxy_BelowFocus_h
#define galaxy_BelowFocus_h

#include "Filters/Model/RingGeometry.h"

namespace galaxy
{
/// A height z of a normal layer of rms height h (kpc), lowered to that below which the same share
/// lies of the part of the layer below normalFocalHeight: layers of neighbouring rings then do not
/// cross, and nothing piles up at the focus.
double keptBelowFocus(const RingFrame& ring, double z, double h);
} // namespace galaxy

#endif
