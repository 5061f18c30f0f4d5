#ifndef galaxy_Placement_h
#define galaxy_Placement_h

#include "Filters/Model/Particles.h"
#include "Readers/Formats/SkyFrame.h"
#include "Readers/Formats/Vec3.h"

#include <array>
#include <string>
#include <vector>

namespace galaxy
{
/// Where a galaxy stands in the frame of a group, and how large: a point P of its own frame goes
/// to centre + magnification (P.x axes[0] + P.y axes[1] + P.z axes[2]), kpc.
struct Placement
{
  Vec3 centre;
  std::array<Vec3, 3> axes = { Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } };
  double magnification = 1;

  /// A direction or velocity.
  Vec3 rotate(const Vec3& v) const
  {
    return v.x * this->axes[0] + v.y * this->axes[1] + v.z * this->axes[2];
  }
  Vec3 apply(const Vec3& p) const { return this->centre + this->magnification * this->rotate(p); }
};

/// Places a galaxy, in the tangent frame of its own sky position, into the frame of the group's
/// origin. `magnification` (S_size) acts about the galaxy's own centre, `separation` (S_sep) on its
/// distance from the origin.
Placement placementOf(
  const SkyFrame& galaxy, const SkyFrame& origin, double magnification = 1, double separation = 1);

/// Moves the particles in place. Smoothing lengths grow with the magnification; luminosities and
/// cross-sections with its square, which keeps surface brightness and opacity; velocities turn.
void placeParticles(const Placement& placement, Particles& particles);

/// One set of particles of many; the components of galaxy k are renamed "NAMES[k]/NAME".
/// Velocities are kept where every set has them. Throws Error (last name) beyond 256 components.
Particles mergeParticles(
  const std::vector<Particles>& galaxies, const std::vector<std::string>& names);
} // namespace galaxy

#endif
