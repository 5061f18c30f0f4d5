#ifndef galaxy_RingPlane_h
#define galaxy_RingPlane_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/Vec3.h"

namespace galaxy
{
/// The plane of a ring in the galaxy's frame, right-handed: a toward the receding half of the
/// major axis, b at 90 degrees from it in the sense of rotation, n along the spin.
struct RingPlane
{
  Vec3 a;
  Vec3 b;
  Vec3 n;
};

/// The plane of inclination i and position angle (radians) for spin s: +1 counter-clockwise on the
/// sky, -1 clockwise. Whatever s, the spin's sky component points to PA + 90 degrees, so that b is
/// the receding axis turned toward the far or the near side.
inline RingPlane ringPlane(double i, double positionAngle, double s)
{
  const double sinPA = std::sin(positionAngle), cosPA = std::cos(positionAngle);
  const double sinI = std::sin(i), cosI = std::cos(i);
  return { { -sinPA, cosPA, 0 }, { -s * cosI * cosPA, -s * cosI * sinPA, -sinI },
    { -sinI * cosPA, -sinI * sinPA, s * cosI } };
}

/// The spin that a table of `code` stands for: TiRiFiC draws its discs counter-clockwise, GIPSY's
/// velocity signs imply clockwise, and so are 3DBarolo's and DiskFit's taken; a plain table is
/// taken as TiRiFiC's.
inline double spinOf(RingCode code, SpinSense sense)
{
  if (sense == SpinSense::FromCode)
  {
    return code == RingCode::Rotcur ? -1 : 1;
  }
  return sense == SpinSense::Clockwise ? -1 : 1;
}

constexpr double arcsecPerRadian = 206264.80624709636;

/// kpc that one arcsec spans at a distance in Mpc.
constexpr double kpcPerArcsec(double distance)
{
  return distance * 1000 / arcsecPerRadian;
}
} // namespace galaxy

#endif
