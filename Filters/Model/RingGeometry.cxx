#include "Filters/Model/RingGeometry.h"

#include "Filters/Model/SineCosine.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180;

/// The difference of two angles by the shorter way, in (-pi, pi].
double folded(double difference)
{
  const double rest = std::remainder(difference, 2 * pi);
  return rest <= -pi ? pi : rest;
}

/// Whether there is room to change from one radius to the next; without, there is a step. Over
/// less, kpc, the changes of angles and velocities are beyond what numbers hold, as over nothing.
bool isRange(double start, double end)
{
  return end - start > 1e-280;
}

void requireUsable(const RingTable& table, double distance)
{
  if (table.rings.empty())
  {
    throw Error(table.file, "", "must hold a ring");
  }
  if (!(distance > 0) || !std::isfinite(distance))
  {
    throw Error(table.file, "distance", "must be above 0 Mpc");
  }
  double previous = 0;
  for (std::size_t k = 0; k < table.rings.size(); ++k)
  {
    const Ring& ring = table.rings[k];
    const std::string where = "ring " + std::to_string(k + 1);
    if (!(ring.radius >= previous) || !std::isfinite(ring.radius))
    {
      throw Error(table.file, where, "radii must not be negative and must not decrease");
    }
    for (const double value : { ring.rotationVelocity, ring.scaleHeight, ring.inclination,
           ring.positionAngle, ring.expansionVelocity, ring.systemicVelocity })
    {
      if (!std::isfinite(value))
      {
        throw Error(table.file, where, "values must be finite numbers");
      }
    }
    previous = ring.radius;
  }
}
} // namespace

TiltedDisk::TiltedDisk(const RingTable& table, double distance, SpinSense sense,
  RingInterpolation interpolation, BeyondLastRing beyond)
  : s(spinOf(table.code, sense))
  , outflow(this->s * spinOf(table.code, SpinSense::FromCode))
  , law(table.layerLaw)
  , beyond(beyond)
{
  requireUsable(table, distance);
  const double kpc = kpcPerArcsec(distance);
  const std::vector<Ring>& rings = table.rings;
  this->firstRadius = kpc * rings.front().radius;
  this->finalRadius = kpc * rings.back().radius;
  if (this->firstRadius > 0 || rings.size() == 1)
  {
    Interval inside = this->constant(0, rings.front(), kpc);
    if (rings.size() > 1 && isRange(0, this->firstRadius))
    {
      inside.rotation = { 0, inside.rotation.value / this->firstRadius };
      inside.expansion = { 0, inside.expansion.value / this->firstRadius };
    }
    this->intervals.push_back(inside);
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
  {
    if (isRange(kpc * rings[k].radius, kpc * rings[k + 1].radius))
    {
      this->intervals.push_back(
        this->between(rings[k], rings[k + 1], kpc, interpolation == RingInterpolation::Slerp));
    }
  }
  this->intervals.push_back(this->constant(this->finalRadius, rings.back(), kpc));
  this->intervals.back().fastestLater = std::abs(rings.back().rotationVelocity);
  for (std::size_t k = this->intervals.size() - 1; k > 0; --k)
  {
    // |rotation| has no peak between the ends of an interval.
    Interval& before = this->intervals[k - 1];
    const Interval& after = this->intervals[k];
    before.fastestLater = std::max({ std::abs(before.rotation.at(after.start - before.start)),
      std::abs(after.rotation.value), after.fastestLater });
  }
}

TiltedDisk::Interval TiltedDisk::constant(double start, const Ring& ring, double kpc) const
{
  Interval interval;
  interval.start = start;
  interval.inclination.value = ring.inclination * degree;
  interval.positionAngle.value = ring.positionAngle * degree;
  interval.rotation.value = ring.rotationVelocity;
  interval.expansion.value = this->outflow * ring.expansionVelocity;
  interval.scaleHeight.value = kpc * std::max(0.0, ring.scaleHeight);
  interval.systemic.value = ring.systemicVelocity;
  interval.startFrame = this->frameOfAngles(interval, 0);
  return interval;
}

TiltedDisk::Interval TiltedDisk::between(
  const Ring& first, const Ring& second, double kpc, bool slerp) const
{
  Interval interval = this->constant(kpc * first.radius, first, kpc);
  const Interval end = this->constant(kpc * second.radius, second, kpc);
  const double width = end.start - interval.start;
  const auto slope = [&](Linear Interval::*parameter) {
    return ((end.*parameter).value - (interval.*parameter).value) / width;
  };
  interval.inclination.slope = slope(&Interval::inclination);
  interval.positionAngle.slope =
    folded(end.positionAngle.value - interval.positionAngle.value) / width;
  interval.rotation.slope = slope(&Interval::rotation);
  interval.expansion.slope = slope(&Interval::expansion);
  interval.scaleHeight.slope = slope(&Interval::scaleHeight);
  interval.systemic.slope = slope(&Interval::systemic);
  interval.flat = interval.inclination.slope == 0 && interval.positionAngle.slope == 0;

  const Vec3 n0 = interval.startFrame.n;
  const Vec3 across = end.startFrame.n - dot(n0, end.startFrame.n) * n0;
  const double sine = length(across);
  // Antipodal and equal normals have no great circle of their own: they stay linear in angle.
  if (slerp && sine > 1e-12)
  {
    interval.greatCircle = true;
    interval.tangent = (1 / sine) * across;
    interval.omega = std::atan2(sine, dot(n0, end.startFrame.n)) / width;
  }
  if (!interval.flat)
  {
    interval.startFrame = interval.greatCircle ? this->frameOfGreatCircle(interval, 0)
                                               : this->frameOfAngles(interval, 0);
  }
  return interval;
}

const TiltedDisk::Interval& TiltedDisk::intervalAt(double r) const
{
  const auto after = std::upper_bound(this->intervals.begin() + 1, this->intervals.end(), r,
    [](double radius, const Interval& interval) { return radius < interval.start; });
  return *(after - 1);
}

// ringPlane's formulas; n = (-sin i cos PA, -sin i sin PA, s cos i) gives
// n' = s i' b - PA' sin i a.
RingFrame TiltedDisk::frameOfAngles(const Interval& interval, double x) const
{
  const auto [sinI, cosI] = sineCosine(interval.inclination.at(x));
  const auto [sinPA, cosPA] = sineCosine(interval.positionAngle.at(x));
  const double sCosI = this->s * cosI;
  return { { -sinPA, cosPA, 0 }, { -sCosI * cosPA, -sCosI * sinPA, -sinI },
    { -sinI * cosPA, -sinI * sinPA, sCosI }, -interval.positionAngle.slope * sinI,
    this->s * interval.inclination.slope };
}

RingFrame TiltedDisk::frameOfGreatCircle(const Interval& interval, double x) const
{
  const RingFrame linear = this->frameOfAngles(interval, x);
  const Vec3 n0 = this->frameOfAngles(interval, 0).n;
  const double sine = std::sin(interval.omega * x);
  const double cosine = std::cos(interval.omega * x);
  const Vec3 n = cosine * n0 + sine * interval.tangent;
  const Vec3 bend = interval.omega * (cosine * interval.tangent - sine * n0);
  // The line of nodes, on the side of the linear angles' receding axis; face-on it is theirs.
  Vec3 a = { -n.y, n.x, 0 };
  if (length(a) < 1e-12)
  {
    a = linear.a - dot(linear.a, n) * n;
  }
  a = (dot(a, linear.a) < 0 ? -1 : 1) / length(a) * a;
  const Vec3 b = cross(n, a);
  return { a, b, n, dot(bend, a), dot(bend, b) };
}

RingFrame TiltedDisk::frame(double r) const
{
  return this->frameIn(this->intervalAt(r), r);
}

RingFrame TiltedDisk::frame(double r, std::size_t& near) const
{
  while (near > 0 && r < this->intervals[near].start)
  {
    --near;
  }
  while (near + 1 < this->intervals.size() && r >= this->intervals[near + 1].start)
  {
    ++near;
  }
  return this->frameIn(this->intervals[near], r);
}

RingFrame TiltedDisk::frameIn(const Interval& interval, double r) const
{
  const double x = r - interval.start;
  RingFrame frame = interval.flat ? interval.startFrame
    : interval.greatCircle        ? this->frameOfGreatCircle(interval, x)
                                  : this->frameOfAngles(interval, x);
  frame.rotation = interval.rotation.at(x);
  frame.expansion = interval.expansion.at(x);
  return frame;
}

Vec3 TiltedDisk::position(double r, double theta, double z) const
{
  const RingFrame ring = this->frame(r);
  return r * std::cos(theta) * ring.a + r * std::sin(theta) * ring.b + z * ring.n;
}

Vec3 TiltedDisk::velocity(double r, double theta) const
{
  return ringVelocity(this->frame(r), std::cos(theta), std::sin(theta));
}

double TiltedDisk::rotationVelocity(double r) const
{
  const Interval& interval = this->intervalAt(r);
  return interval.rotation.at(r - interval.start);
}

double TiltedDisk::scaleHeight(double r) const
{
  const Interval& interval = this->intervalAt(r);
  return interval.scaleHeight.at(r - interval.start);
}

double TiltedDisk::systemicVelocity(double r) const
{
  const Interval& interval = this->intervalAt(r);
  return interval.systemic.at(r - interval.start);
}

double TiltedDisk::lineOfSightVelocity(double r, double theta) const
{
  return this->systemicVelocity(r) - this->velocity(r, theta).z;
}

double TiltedDisk::areaElement(double r, double theta) const
{
  const RingFrame ring = this->frame(r);
  const double kappa = ring.bendA * std::cos(theta) + ring.bendB * std::sin(theta);
  return r * std::sqrt(1 + r * kappa * r * kappa);
}

double TiltedDisk::skyJacobian(double r, double theta) const
{
  const RingFrame ring = this->frame(r);
  const double kappa = ring.bendA * std::cos(theta) + ring.bendB * std::sin(theta);
  const double depth = std::cos(theta) * ring.a.z + std::sin(theta) * ring.b.z;
  return r * std::abs(ring.n.z + r * kappa * depth);
}

double normalFocalHeight(const RingFrame& ring)
{
  return 0.5 / std::hypot(ring.bendA, ring.bendB);
}

double TiltedDisk::outerRadius() const
{
  return this->beyond == BeyondLastRing::Drop ? this->finalRadius
                                              : std::numeric_limits<double>::infinity();
}

std::vector<double> TiltedDisk::knots() const
{
  std::vector<double> knots;
  for (const Interval& interval : this->intervals)
  {
    knots.push_back(interval.start);
  }
  return knots;
}

std::vector<double> TiltedDisk::knotsBetween(double inner, double outer) const
{
  std::vector<double> between = { inner };
  for (const double knot : this->knots())
  {
    if (knot > inner && knot < outer)
    {
      between.push_back(knot);
    }
  }
  between.push_back(outer);
  return between;
}

double TiltedDisk::fastestRotation(double r) const
{
  const Interval& interval = this->intervalAt(r);
  return std::max(std::abs(interval.rotation.at(r - interval.start)), interval.fastestLater);
}

double TiltedDisk::slowestRotation(double inner, double outer) const
{
  // Piecewise linear: the extremes lie at the ends and on either side of the knots between.
  double low = std::min(this->rotationVelocity(inner), this->rotationVelocity(outer));
  double high = std::max(this->rotationVelocity(inner), this->rotationVelocity(outer));
  for (std::size_t k = 0; k + 1 < this->intervals.size(); ++k)
  {
    const Interval& before = this->intervals[k];
    const double knot = this->intervals[k + 1].start;
    if (knot > inner && knot <= outer)
    {
      const double left = before.rotation.at(knot - before.start);
      const double right = this->intervals[k + 1].rotation.value;
      low = std::min({ low, left, right });
      high = std::max({ high, left, right });
    }
  }
  return low <= 0 && high >= 0 ? 0 : std::min(std::abs(low), std::abs(high));
}
} // namespace galaxy
