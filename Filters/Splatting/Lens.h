#ifndef galaxy_Lens_h
#define galaxy_Lens_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Render.h"

namespace galaxy
{
/// How a camera sees round particles.
///
/// In perspective a pixel shows the light along its ray. On the image plane (focal length 1), a
/// kernel of radius h at the distance d and the depth z, cos = z/d, then covers an ellipse of
/// h/(z cos) along the radius and h/z across, and its peak is the column through its middle,
/// whatever the angle. Drawn is a circle of that peak and area. With w = s^2/z^2, s^2 the kernel's
/// variance along an axis, and to the order of w
/// - all rays together see the particle as larger by w (6 - 2 cos^2), since those on its outer side
///   meet the plane at ever smaller angles, and so is the circle;
/// - the circle's middle is farther out by the share 3/2 w (1 + cos): then particles spread evenly
///   around the eye are equally bright in all directions, with 13/2 w^2 to 1 % up to 90 degrees of
///   field and the nearest of them.
///
/// What is nearer than two smoothing lengths, or reaches the plane through the eye, has no such
/// circle, and is a NearParticle, drawn ray by ray.
class Lens
{
public:
  Lens(const Camera& camera, Kernel kernel);

  const Camera& camera() const { return this->eye; }
  Kernel kernel() const { return this->profile; }

  /// The place from the eye to the right, up and into the scene, kpc.
  Vec3 seen(const Vec3& position) const;

  /// On the image plane, of focal length 1 (parallel: in kpc), what is before the eye.
  struct Circle
  {
    double x, y;
    double radius; ///< per kpc of smoothing length
  };
  Circle circle(const Vec3& seen, double h) const;

  /// The smoothing length of what is drawn as a circle of such a radius, kpc.
  double smoothingLength(double x, double y, double radius, double distance) const;

  /// Whether it has a circle: in a parallel projection all have.
  bool isBefore(const Vec3& seen, double h) const
  {
    return this->eye.parallel ||
      (seen.z > 0 && seen.z >= h && dot(seen, seen) >= within * within * h * h);
  }
  /// Whether it is a NearParticle: has no circle, and reaches into the field of view.
  bool isNear(const Vec3& seen, double h) const;

  /// How much of a NearParticle is drawn as the circle that it is about to have: all where it has
  /// it, so that nothing jumps there.
  static double circleShare(const Vec3& seen, double h);

  static constexpr double within = 2; ///< smoothing lengths
  /// The square of the distance beyond which none is near, smoothing lengths squared.
  double nearReach2() const { return this->reach2; }
  /// The cosine of the angle between the axis and the picture's farthest corner.
  double cosineOfField() const { return this->field; }
  /// Smoothing lengths squared.
  double variance() const { return this->s2; }

private:
  Camera eye;
  Kernel profile;
  double s2;
  double reach2 = 0;
  double field;
};
} // namespace galaxy

#endif
