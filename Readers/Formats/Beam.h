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

/// From BMAJ, BMIN and BPA (Obit's CLEANBMJ, CLEANBMN and CLEANBPA; GIPSY's BMMAJ, BMMIN and BMPA
/// in arcsec), in degrees unless value or comment name another unit, else from the last beam of the
/// HISTORY that AIPS or CASA wrote, else the median beam of the file's BEAMS table; none where
/// there is none of these.
std::optional<Beam> beamOf(const Image& image);

/// Throws Error where the beam of the header is far wider than the image, whose pixels are `pixel`
/// arcsec wide: it is then in another unit than it says.
void requireBeamInImage(const Image& image, const Beam& beam, double pixel);
} // namespace galaxy

#endif
