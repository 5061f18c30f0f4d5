#ifndef galaxy_CelestialFrame_h
#define galaxy_CelestialFrame_h

#include "Readers/Formats/WorldCoordinates.h"

#include <memory>

namespace galaxy
{
/// A celestial reference frame and its way to ICRS and back: a matrix, and for FK4 the E-terms of
/// aberration that its catalogue positions contain. The models are those of astropy, whose
/// positions it reproduces to far better than a milliarcsecond.
class CelestialFrame
{
public:
  static CelestialFrame icrs();
  /// The IAU 1958 system, tied to FK5 at J2000.
  static CelestialFrame galactic();
  /// The mean ecliptic and equinox of a Julian epoch (IAU 2006).
  static CelestialFrame ecliptic(double equinox);
  /// `equinox` is Julian, for example 2000.
  static CelestialFrame fk5(double equinox);
  /// `equinox` is Besselian, for example 1950, and counts as the epoch of observation: sources
  /// without motion in an inertial frame drift in FK4 by 0.5 milliarcsec a year.
  static CelestialFrame fk4(double equinox);
  /// The same without the E-terms, RADESYS 'FK4-NO-E'.
  static CelestialFrame fk4WithoutETerms(double equinox);

  /// Degrees in, degrees out; the right ascension in [0, 360). May be called by many threads.
  SkyPosition toIcrs(const SkyPosition& position) const;
  SkyPosition fromIcrs(const SkyPosition& position) const;

private:
  struct Way;

  explicit CelestialFrame(const Way& way);

  std::shared_ptr<const Way> way;
};
} // namespace galaxy

#endif
