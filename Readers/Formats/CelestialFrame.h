#ifndef galaxy_CelestialFrame_h
#define galaxy_CelestialFrame_h

#include "Readers/Formats/WorldCoordinates.h"

#include <array>

namespace galaxy
{
/// A celestial reference frame and its way to ICRS and back: a rotation, and for FK4 the E-terms
/// of aberration that its catalogue positions contain. FK5 at J2000 counts as ICRS (they differ by
/// 0.02 arcsec).
class CelestialFrame
{
public:
  static CelestialFrame icrs();
  static CelestialFrame galactic();
  /// The mean ecliptic and equinox of J2000.
  static CelestialFrame ecliptic();
  /// `equinox` is Julian, for example 2000.
  static CelestialFrame fk5(double equinox);
  /// `equinox` is Besselian, for example 1950.
  static CelestialFrame fk4(double equinox);

  /// Degrees in, degrees out; the right ascension in [0, 360).
  SkyPosition toIcrs(const SkyPosition& position) const;
  SkyPosition fromIcrs(const SkyPosition& position) const;

private:
  using Matrix = std::array<std::array<double, 3>, 3>;

  CelestialFrame(const Matrix& rotation, bool hasETerms, const Matrix& fromB1950);

  Matrix rotation;        // to ICRS
  bool hasETerms = false; // FK4
  Matrix fromB1950;       // FK4: of B1950's axes into those of the frame's equinox
};
} // namespace galaxy

#endif
