#ifndef galaxy_RingGeometry_h
#define galaxy_RingGeometry_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/Vec3.h"

#include <cstddef>
#include <vector>

namespace galaxy
{
/// One ring: its plane's axes, a toward the receding major axis, n along the spin, b = n x a, how
/// the normal turns with radius, n'(r) = bendA a + bendB b (1/kpc), and its motion (km/s).
struct RingFrame
{
  Vec3 a;
  Vec3 b;
  Vec3 n;
  double bendA = 0;
  double bendB = 0;
  double rotation = 0;
  double expansion = 0; ///< outward
};

/// The velocity of a ring's matter in the direction cos(theta) a + sin(theta) b.
inline Vec3 ringVelocity(const RingFrame& ring, double cosTheta, double sinTheta)
{
  const double alongA = ring.expansion * cosTheta - ring.rotation * sinTheta;
  const double alongB = ring.expansion * sinTheta + ring.rotation * cosTheta;
  return alongA * ring.a + alongB * ring.b;
}

/// Half the height at which neighbouring normals meet, 1/(2 |n'|), kpc; infinite where flat. Points
/// kept below it stay in the order of their rings.
double normalFocalHeight(const RingFrame& ring);

/// A disc of concentric tilted rings as a surface in the galaxy's frame (Readers/Formats/Vec3.h),
/// kpc and km/s.
///
/// A point is r (cos theta a + sin theta b) + z n; theta runs from the receding axis in the sense
/// of rotation. Every ring parameter is linear in radius between the rings, the position angle by
/// the shorter way. Inside the first ring the angles are constant and the velocities fall linearly
/// to 0 at the centre; beyond the last ring its values hold. Of rings of equal radius the later
/// holds at and beyond it. A single ring is a flat disc with a flat rotation curve.
/// A table's expansion velocities are outward for the spin that its own program means. What was
/// observed is their line-of-sight part, which does not know the spin: for the other spin the near
/// and the far side change places, and the same observation is an inflow in place of an outflow.
/// Concentric rings without thickness never intersect, for |P| = r on each.
class TiltedDisk
{
public:
  /// `distance` in Mpc turns the table's arcseconds into kpc.
  /// Throws Error where the table has no ring, a negative, decreasing or non-finite value, or the
  /// distance is not positive.
  TiltedDisk(const RingTable& table, double distance, SpinSense sense = SpinSense::FromCode,
    RingInterpolation interpolation = RingInterpolation::LinearAngles,
    BeyondLastRing beyond = BeyondLastRing::Drop);

  RingFrame frame(double r) const;
  /// The same for many radii one after the other, each close to the one before: `near` is where the
  /// last was found, 0 at first.
  RingFrame frame(double r, std::size_t& near) const;
  Vec3 position(double r, double theta, double z = 0) const;
  Vec3 velocity(double r, double theta) const;

  double rotationVelocity(double r) const;        ///< km/s
  double scaleHeight(double r) const;             ///< kpc, the table's Z0
  LayerLaw layerLaw() const { return this->law; } ///< that Z0 belongs to
  double systemicVelocity(double r) const;        ///< km/s
  /// Radial velocity of the matter at a place, km/s, receding positive.
  double lineOfSightVelocity(double r, double theta) const;

  /// Area of the surface per dr dtheta, kpc: r sqrt(1 + (r kappa)^2), kappa = n'(r) . e_r.
  double areaElement(double r, double theta) const;
  /// Area on the sky per dr dtheta, kpc: r |n_z + r kappa e_r,z|, for parallel projection.
  double skyJacobian(double r, double theta) const;

  double innerRadius() const { return this->firstRadius; } ///< the first ring's
  double lastRadius() const { return this->finalRadius; }  ///< the last ring's
  /// Where the disc ends: the last ring, or infinity with BeyondLastRing::HoldLast.
  double outerRadius() const;
  /// The radii between which every parameter is linear, increasing, from 0; beyond the last the
  /// disc is flat.
  std::vector<double> knots() const;
  /// Two radii, and the knots between them.
  std::vector<double> knotsBetween(double inner, double outer) const;
  /// The slowest |rotation| between two radii, km/s.
  double slowestRotation(double inner, double outer) const;
  /// The fastest |rotation| at r and anywhere beyond, km/s: it never rises with radius.
  double fastestRotation(double r) const;
  /// +1 counter-clockwise on the sky, -1 clockwise, for inclinations below 90 degrees.
  double spin() const { return this->s; }

private:
  /// A range of radii over which every parameter is linear in x = r - start.
  struct Linear
  {
    double value = 0;
    double slope = 0;
    double at(double x) const { return this->value + this->slope * x; }
  };
  struct Interval
  {
    double start = 0;
    Linear inclination;   ///< radians
    Linear positionAngle; ///< radians
    Linear rotation;
    Linear expansion;
    Linear scaleHeight;
    Linear systemic;
    double fastestLater = 0; ///< |rotation| at the interval's end and anywhere beyond
    bool flat = true;        ///< the frame is the same throughout
    RingFrame startFrame;
    bool greatCircle = false; ///< the normal is n cos(omega x) + tangent sin(omega x)
    Vec3 tangent;
    double omega = 0;
  };

  const Interval& intervalAt(double r) const;
  RingFrame frameIn(const Interval& interval, double r) const;
  RingFrame frameOfAngles(const Interval& interval, double x) const;
  RingFrame frameOfGreatCircle(const Interval& interval, double x) const;
  Interval between(const Ring& first, const Ring& second, double kpc, bool slerp) const;
  Interval constant(double start, const Ring& ring, double kpc) const;

  double s;
  double outflow; ///< from the table's expansion velocities to those of this spin: 1 or -1
  LayerLaw law;
  BeyondLastRing beyond;
  double firstRadius;
  double finalRadius;
  std::vector<Interval> intervals;
};
} // namespace galaxy

#endif
