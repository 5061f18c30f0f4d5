#include "Filters/Splatting/NearParticle.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
double NearParticle::column(double u, double v) const
{
  const double end = std::exp(-9.0);
  const double profile = std::max(0.0, std::exp(-this->offset2(u, v)) - end);
  const double before = 0.5 + gaussianCumulative(this->along(u, v));
  return nearPeak * profile * before / (this->sigma * this->sigma);
}
} // namespace galaxy
