#ifndef galaxy_SpheroidShape_h
#define galaxy_SpheroidShape_h

#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <array>
#include <vector>

namespace galaxy
{
/// The semi-axes (kpc, in the galaxy's frame) of the ellipsoids that a spheroid consists of.
using SemiAxes = std::array<Vec3, 3>;

/// The ellipsoids of a spheroid: similar ones, or nested ones whose axis ratios and angles are
/// linear in the semi-major axis between the given rows, and hold beyond the first and the last.
///
/// Axes of their own are a ring's (see RingFrame) of that position angle and inclination, in a
/// galaxy that turns as the disc does: the first along the position angle in the sky, the third
/// along the normal.
class SpheroidShape
{
public:
  SpheroidShape(const SpheroidDescription& spheroid, const TiltedDisk& disk);

  /// The ellipsoid through the radius s on the first axis, s in units of scaleOf().
  SemiAxes semiAxes(double s) const;

  /// A place on it: `direction` is of unit length.
  Vec3 position(double s, const Vec3& direction) const
  {
    const SemiAxes axes = this->semiAxes(s);
    return direction.x * axes[0] + direction.y * axes[1] + direction.z * axes[2];
  }

private:
  EllipsoidShell ellipsoidAt(double semiMajor) const;

  double scale;
  double spin;
  std::vector<EllipsoidShell> ellipsoids;
  SemiAxes unit; ///< at s = 1 of similar ellipsoids
};
} // namespace galaxy

#endif
