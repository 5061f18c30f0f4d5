#ifndef galaxy_Beam_h
#define galaxy_Beam_h

#include "Readers/Formats/Image.h"

#include <optional>

namespace galaxy
{
/// The elliptical Gaussian that an image was restored with.
struct Beam
{
  double major = 0;         ///< full width at half maximum, arcsec
  double minor = 0;         ///< arcsec
  double positionAngle = 0; ///< North through East, degrees

  /// pi major minor / (4 ln 2), arcsec^2.
  double solidAngle() const;
};

/// From BMAJ, BMIN and BPA (degrees), else from the last HISTORY card of AIPS that has them, else
/// the median beam of the file's BEAMS table; none where there is none of these.
std::optional<Beam> beamOf(const Image& image);
} // namespace galaxy

#endif
