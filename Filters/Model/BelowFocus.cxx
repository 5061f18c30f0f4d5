#include "Filters/Model/BelowFocus.h"

#include "Filters/Model/NormalQuantile.h"
#include "Filters/Model/VerticalLaw.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
double keptBelowFocus(const RingFrame& ring, double z, double h)
{
  constexpr double mostShare = 1 - 0x1p-32; // that normalQuantile takes
  // Of a layer this many times thinner nothing lies beyond, in double precision.
  constexpr double all = 8.3;
  const double bend = ring.bendA * ring.bendA + ring.bendB * ring.bendB;
  if (4 * all * all * h * h * bend <= 1)
  {
    return z;
  }
  const double below = shareWithin(LayerLaw::Gaussian, normalFocalHeight(ring) / h);
  const double share = std::min(shareWithin(LayerLaw::Gaussian, std::abs(z) / h), mostShare);
  return std::copysign(h * normalQuantile(below * share), z);
}
} // namespace galaxy
