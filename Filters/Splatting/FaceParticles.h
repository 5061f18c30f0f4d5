#ifndef galaxy_FaceParticles_h
#define galaxy_FaceParticles_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/ParticleArrays.h"

namespace galaxy
{
/// Particles as a perspective camera must be given them for a picture that is a part of the sky.
///
/// The engine draws a particle as a disc on the image plane, with its light per area of that plane.
/// The sky shows light per area across the line of sight, whatever the camera looks at, and a round
/// particle is round and symmetric about its direction. With theta the angle from the camera's axis
/// and s^2 the variance of the profile along an axis over the distance squared, the disc has
/// - cos(theta) of the solid angle, by being shorter toward the axis;
/// - cos(theta) of the light, times 1 + q (9 - 15 cos^2)/2 for its width, q being s^2 of the disc
/// as
///   drawn, where a ball of light has 1 + s^2, the mean of 1/r^2 over it;
/// - its middle 4 q sin cos nearer to the axis, since there a pixel is a larger part of the sky.
/// The smoothing length, the light and the place are changed so that all three come out right, to
/// the order of s^2; the disc stays shorter toward the axis and longer across. The distance stays,
/// and what the engine draws ray by ray (NearParticle), which is right already.
class FaceParticles
{
public:
  FaceParticles(const ParticleView& particles, Kernel kernel);

  /// For this camera; until the next call.
  const ParticleView& seenBy(const Camera& camera);

private:
  struct Change;
  Change changeOf(const Vec3& fromEye, double radius, const Camera& camera) const;

  ParticleView original;
  ParticleArrays arrays;
  ParticleView changed;
  double variance; ///< of the kernel along an axis, smoothing lengths squared
};
} // namespace galaxy

#endif
