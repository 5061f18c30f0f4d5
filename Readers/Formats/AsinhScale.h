#ifndef galaxy_AsinhScale_h
#define galaxy_AsinhScale_h

#include "Readers/Formats/FitsHeader.h"

#include <cmath>
#include <optional>

namespace galaxy
{
/// Pan-STARRS stacks store asinh magnitudes v (Lupton et al. 1999, AJ 118, 1406):
/// flux = BOFFSET + 2 BSOFTEN sinh(v / 1.0857362), behind BSCALE and BZERO.
struct AsinhScale
{
  double softening = 0;
  double offset = 0;

  /// None where the header has no such scale.
  static std::optional<AsinhScale> of(const FitsHeader& header)
  {
    const double softening = header.number("BSOFTEN").value_or(0);
    return softening > 0
      ? std::optional<AsinhScale>({ softening, header.number("BOFFSET").value_or(0) })
      : std::nullopt;
  }

  double flux(double value) const
  {
    const double pogson = 2.5 / std::log(10.0);
    return this->offset + 2 * this->softening * std::sinh(value / pogson);
  }
};
} // namespace galaxy

#endif
