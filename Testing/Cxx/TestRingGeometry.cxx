#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
TiltedDisk m83(RingInterpolation interpolation = RingInterpolation::LinearAngles)
{
  return TiltedDisk(m83Rings(), m83Distance, SpinSense::FromCode, interpolation);
}

double distance(const Vec3& p, const Vec3& q)
{
  return length(p - q);
}

/// The derivative of a vector function, to fourth order.
template <typename F>
Vec3 derivative(const F& f, double x, double step)
{
  return (1 / (12 * step)) *
    (8.0 * (f(x + step) - f(x - step)) - (f(x + 2 * step) - f(x - 2 * step)));
}

struct Tangents
{
  Vec3 r;
  Vec3 theta;
};

Tangents tangentsOf(const TiltedDisk& disk, double r, double theta)
{
  return { derivative([&](double x) { return disk.position(x, theta); }, r, 1e-3),
    derivative([&](double x) { return disk.position(r, x); }, theta, 1e-3) };
}

/// Half a table of two rings that warps strongly, with every sign in play.
TiltedDisk strongWarp(RingInterpolation interpolation)
{
  RingTable table;
  table.rings = { ring(100, 100, 10, 40, 350), ring(600, 150, 20, 80, 50) };
  return TiltedDisk(table, m83Distance, SpinSense::Clockwise, interpolation);
}
} // namespace

TEST(RingGeometry, FrameIsRightHandedAndFollowsTheSky)
{
  for (const double s : { 1.0, -1.0 })
  {
    RingTable table = flatDisk(10, 30, 50);
    const TiltedDisk disk(
      table, m83Distance, s > 0 ? SpinSense::CounterClockwise : SpinSense::Clockwise);
    const RingFrame frame = disk.frame(5);
    EXPECT_NEAR(distance(cross(frame.a, frame.b), frame.n), 0, 1e-15);
    EXPECT_NEAR(length(frame.a), 1, 1e-15);
    // The position angle runs from North (+Y) through East (-X).
    EXPECT_NEAR(frame.a.x, -std::sin(50 * degree), 1e-15);
    EXPECT_NEAR(frame.a.y, std::cos(50 * degree), 1e-15);
    // The spin's sky component is sin i toward PA + 90 degrees, whatever the sense.
    EXPECT_NEAR(frame.n.x, -std::sin(140 * degree) * std::sin(30 * degree), 1e-15);
    EXPECT_NEAR(frame.n.y, std::cos(140 * degree) * std::sin(30 * degree), 1e-15);
    EXPECT_NEAR(frame.n.z, s * std::cos(30 * degree), 1e-15);
    // The receding end of the major axis recedes: away from the observer is -Z.
    EXPECT_NEAR(disk.velocity(5, 0).z, -200 * std::sin(30 * degree), 1e-12);
  }
}

TEST(RingGeometry, SpinFollowsTheCode)
{
  RingTable table = flatDisk(10, 30, 50);
  table.code = RingCode::Tirific;
  EXPECT_EQ(TiltedDisk(table, 1).spin(), 1);
  table.code = RingCode::Plain;
  EXPECT_EQ(TiltedDisk(table, 1).spin(), 1);
  table.code = RingCode::Rotcur;
  EXPECT_EQ(TiltedDisk(table, 1).spin(), -1);
  EXPECT_EQ(TiltedDisk(table, 1, SpinSense::CounterClockwise).spin(), 1);
}

TEST(RingGeometry, FastestRotationIsThatFromARadiusOutward)
{
  RingTable table;
  table.rings = { ring(50, -60, 1, 0, 0), ring(100, 120, 1, 0, 0), ring(100, 90, 1, 0, 0),
    ring(200, -100, 1, 0, 0), ring(300, 40, 1, 0, 0) };
  const TiltedDisk disk(table, m83Distance);
  const double expected[][2] = { { 0, 120 }, { 50, 120 }, { 99.999, 120 }, { 100, 100 },
    { 199, 100 }, { 200, 100 }, { 250, 40 }, { 210, 86 }, { 300, 40 }, { 900, 40 } };
  for (const auto& [arcsec, v] : expected)
  {
    EXPECT_NEAR(disk.fastestRotation(arcsec * m83Kpc), v, 0.01) << arcsec;
  }
}

TEST(RingGeometry, FramesAreFoundFromOneAnother)
{
  const TiltedDisk disk = m83();
  std::size_t near = 0;
  for (const double r : { 30.0, 0.0, 60.0, 59.0, 4.0, 4.1, 21.0, 20.0, 1e9, 0.1 })
  {
    const RingFrame one = disk.frame(r), other = disk.frame(r, near);
    EXPECT_EQ(distance(one.n, other.n), 0) << r;
    EXPECT_EQ(one.rotation, other.rotation) << r;
  }
}

TEST(RingGeometry, PositionAngleTakesTheShorterWay)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 45, 350), ring(100, 100, 1, 45, 10) };
  const TiltedDisk disk(table, m83Distance);
  const RingFrame middle = disk.frame(50 * m83Kpc);
  EXPECT_NEAR(middle.a.x, 0, 1e-14);
  EXPECT_NEAR(middle.a.y, 1, 1e-14);
}

TEST(RingGeometry, FaceOnDiscDoesNotKnowItsPositionAngle)
{
  for (const double angle : { 0.0, 77.0, 200.0 })
  {
    const TiltedDisk disk(flatDisk(10, 0, angle), m83Distance);
    for (const double theta : { 0.3, 2.0, 5.0 })
    {
      const Vec3 p = disk.position(7, theta);
      EXPECT_NEAR(p.z, 0, 1e-15);
      EXPECT_NEAR(std::hypot(p.x, p.y), 7, 1e-14);
      EXPECT_NEAR(disk.skyJacobian(7, theta), 7, 1e-14);
      // The same point under another position angle is the same disc turned.
      const Vec3 q =
        TiltedDisk(flatDisk(10, 0, 0), m83Distance).position(7, theta + angle * degree);
      EXPECT_NEAR(distance(p, q), 0, 1e-13);
    }
  }
}

TEST(RingGeometry, InclinationBeyondNinetyMirrorsTheDepth)
{
  RingTable below = m83Rings();
  RingTable beyond = below;
  for (Ring& ring : beyond.rings)
  {
    ring.inclination = 180 - ring.inclination;
  }
  const TiltedDisk plus(beyond, m83Distance, SpinSense::CounterClockwise);
  const TiltedDisk minus(below, m83Distance, SpinSense::Clockwise);
  const TiltedDisk original(below, m83Distance, SpinSense::CounterClockwise);
  for (const double r : { 3.0, 14.0, 33.0, 52.0 })
  {
    for (const double theta : { 0.2, 1.9, 4.4 })
    {
      EXPECT_NEAR(distance(plus.position(r, theta, 0.3), minus.position(r, theta, 0.3)), 0, 1e-12);
      // The sky cannot tell: the mirrored disc covers it alike, at opposite depth.
      const Vec3 p = original.position(r, theta);
      const Vec3 q = minus.position(r, -theta);
      EXPECT_NEAR(p.x - q.x, 0, 1e-12);
      EXPECT_NEAR(p.y - q.y, 0, 1e-12);
      EXPECT_NEAR(p.z + q.z, 0, 1e-12);
    }
  }
}

TEST(RingGeometry, JacobiansAgreeWithFiniteDifferences)
{
  for (const RingInterpolation interpolation :
    { RingInterpolation::LinearAngles, RingInterpolation::Slerp })
  {
    for (const TiltedDisk& disk : { m83(interpolation), strongWarp(interpolation) })
    {
      for (double r = 0.61; r < 13; r += 0.977)
      {
        for (double theta = 0.1; theta < 6.28; theta += 0.5)
        {
          const auto [dr, dtheta] = tangentsOf(disk, r, theta);
          const Vec3 normal = cross(dr, dtheta);
          EXPECT_NEAR(disk.areaElement(r, theta) / length(normal), 1, 1e-7);
          EXPECT_NEAR(disk.skyJacobian(r, theta), std::abs(normal.z), 1e-7 * r);
        }
      }
    }
  }
}

TEST(RingGeometry, NormalTurnsAsStated)
{
  for (const RingInterpolation interpolation :
    { RingInterpolation::LinearAngles, RingInterpolation::Slerp })
  {
    const TiltedDisk disk = strongWarp(interpolation);
    for (const double r : { 3.0, 6.0, 11.0 })
    {
      const RingFrame frame = disk.frame(r);
      const Vec3 turn = derivative([&](double x) { return disk.frame(x).n; }, r, 1e-3);
      EXPECT_NEAR(distance(turn, frame.bendA * frame.a + frame.bendB * frame.b), 0, 1e-10);
      EXPECT_NEAR(normalFocalHeight(frame), 0.5 / length(turn), 1e-8);
    }
  }
}

TEST(RingGeometry, RingsNeverIntersect)
{
  const TiltedDisk disk = strongWarp(RingInterpolation::LinearAngles);
  for (double r = 0.5; r < 20; r += 0.7)
  {
    EXPECT_NEAR(length(disk.position(r, 2.2 * r)), r, 1e-12 * r);
  }
}

TEST(RingGeometry, RotationRunsAlongTheRing)
{
  const TiltedDisk disk = m83();
  const double r = 11;
  const double theta = 1.3;
  const Vec3 along = tangentsOf(disk, r, theta).theta;
  EXPECT_NEAR(distance(disk.velocity(r, theta), disk.rotationVelocity(r) / r * along), 0, 1e-7);
}

TEST(RingGeometry, M83WarpHasItsKnownNumbers)
{
  const TiltedDisk disk = m83();
  const double outer = disk.lastRadius();
  double warped = 0, flat = 0, largest = 0, smallest = 10, smallestAt = 0, sharpest = 1e9;
  const int rings = 4000, azimuths = 360;
  for (int k = 0; k < rings; ++k)
  {
    const double r = (k + 0.5) * outer / rings;
    const RingFrame frame = disk.frame(r);
    sharpest = std::min(sharpest, 2 * normalFocalHeight(frame));
    for (int j = 0; j < azimuths; ++j)
    {
      const double theta = 2 * pi * (j + 0.5) / azimuths;
      const double factor = disk.areaElement(r, theta) / r;
      warped += factor * r;
      flat += r;
      largest = std::max(largest, factor);
      const double pile = disk.skyJacobian(r, theta) / (r * frame.n.z);
      if (pile < smallest)
      {
        smallest = pile;
        smallestAt = r / m83Kpc;
      }
    }
  }
  EXPECT_NEAR(warped / flat, 1.218, 0.001);
  EXPECT_NEAR(largest, 1.87, 0.01);
  // Both extremes lie at the outer end of the interval from 515 to 686 arcsec. There
  // J_sky/(r cos i) = 1 - r tan i [di sin^2(theta) - dPA sin i sin(theta) cos(theta)], whose
  // bracket is at most (di + sqrt(di^2 + dPA^2 sin^2 i))/2.
  const double di = 10.6 * degree / 171, dPA = 10 * degree / 171;
  const double sinI = std::sin(44.8 * degree), tanI = std::tan(44.8 * degree);
  const double bend = std::hypot(di, dPA * sinI);
  EXPECT_NEAR(smallest, 1 - 686 * tanI * (di + bend) / 2, 0.002);
  EXPECT_NEAR(smallestAt, 686, 1);
  EXPECT_NEAR(sharpest, m83Kpc / bend, 0.01);
  EXPECT_NEAR(sharpest, 18.3, 0.1);
  EXPECT_NEAR(disk.scaleHeight(20), 0.710, 0.001);
}

TEST(RingGeometry, SlerpStaysCloseToLinearAnglesForM83)
{
  const TiltedDisk linear = m83();
  const TiltedDisk slerp = m83(RingInterpolation::Slerp);
  double largest = 0;
  for (double r = 0; r < linear.lastRadius(); r += 0.05)
  {
    const Vec3 n = linear.frame(r).n;
    largest = std::max(largest, std::asin(length(cross(n, slerp.frame(r).n))) / degree);
  }
  EXPECT_LT(largest, 0.375);
  EXPECT_GT(largest, 0.3);
}

TEST(RingGeometry, SlerpPassesThroughFaceOn)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 2, 10), ring(100, 100, 1, 2, 190) };
  const TiltedDisk disk(table, m83Distance, SpinSense::FromCode, RingInterpolation::Slerp);
  const RingFrame middle = disk.frame(50 * m83Kpc);
  EXPECT_NEAR(middle.n.z, 1, 1e-15);
  EXPECT_NEAR(length(middle.a), 1, 1e-12);
  EXPECT_NEAR(distance(cross(middle.a, middle.b), middle.n), 0, 1e-12);
}

TEST(RingGeometry, EqualRadiiAreAStep)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 20, 0), ring(100, 100, 1, 20, 0), ring(100, 150, 1, 40, 0),
    ring(200, 150, 1, 40, 0) };
  const TiltedDisk disk(table, m83Distance);
  const double step = 100 * m83Kpc;
  EXPECT_NEAR(disk.frame(step * (1 - 1e-12)).n.z, std::cos(20 * degree), 1e-12);
  EXPECT_NEAR(disk.frame(step).n.z, std::cos(40 * degree), 1e-12);
  EXPECT_NEAR(disk.rotationVelocity(step), 150, 1e-12);
}

TEST(RingGeometry, InsideTheFirstRingVelocityFallsToZero)
{
  RingTable table = m83Rings();
  table.rings.erase(table.rings.begin());
  const TiltedDisk disk(table, m83Distance);
  EXPECT_NEAR(disk.rotationVelocity(0), 0, 1e-12);
  EXPECT_NEAR(disk.rotationVelocity(86 * m83Kpc), 98, 1e-9);
  EXPECT_NEAR(disk.frame(0).n.z, std::cos(23.7 * degree), 1e-12);
  EXPECT_NEAR(disk.slowestRotation(86 * m83Kpc, 10), 98, 1e-9);
  EXPECT_NEAR(disk.slowestRotation(172 * m83Kpc, 40), 189, 1e-9);
}

TEST(RingGeometry, OneRingIsAFlatDisc)
{
  const TiltedDisk disk(flatDisk(10, 60, 30), m83Distance);
  for (const double r : { 0.0, 1.0, 10.0, 30.0 })
  {
    EXPECT_NEAR(disk.frame(r).n.z, 0.5, 1e-15);
    EXPECT_NEAR(disk.rotationVelocity(r), 200, 1e-12);
    EXPECT_NEAR(disk.areaElement(r, 1), r, 1e-14);
    EXPECT_TRUE(std::isinf(normalFocalHeight(disk.frame(r))));
  }
  EXPECT_NEAR(disk.outerRadius(), 10, 1e-12);
  EXPECT_TRUE(std::isinf(TiltedDisk(flatDisk(10), m83Distance, SpinSense::FromCode,
    RingInterpolation::LinearAngles, BeyondLastRing::HoldLast)
                           .outerRadius()));
}

TEST(RingGeometry, EdgeOnDiscIsALineOnTheSky)
{
  for (const SpinSense sense : { SpinSense::Clockwise, SpinSense::CounterClockwise })
  {
    const TiltedDisk disk(flatDisk(10, 90, 0), m83Distance, sense);
    for (const double theta : { 0.0, 0.9, 2.5, 4.0 })
    {
      // Receding end North; matter moves from there to the far side.
      const Vec3 p = disk.position(7, theta);
      EXPECT_NEAR(distance(p, { 0, 7 * std::cos(theta), -7 * std::sin(theta) }), 0, 1e-14);
      EXPECT_NEAR(disk.lineOfSightVelocity(7, theta), 200 * std::cos(theta), 1e-12);
      EXPECT_NEAR(disk.skyJacobian(7, theta), 0, 1e-14);
    }
  }
}

TEST(RingGeometry, UnusableTablesAreRefused)
{
  RingTable table;
  EXPECT_THROW(TiltedDisk(table, 1), Error);
  table.rings = { ring(10, 1, 1, 1, 1), ring(5, 1, 1, 1, 1) };
  EXPECT_THROW(TiltedDisk(table, 1), Error);
  table.rings = { ring(10, std::nan(""), 1, 1, 1) };
  EXPECT_THROW(TiltedDisk(table, 1), Error);
  EXPECT_THROW(TiltedDisk(flatDisk(10), 0), Error);
}

TEST(RingGeometry, RingsThatAllButTouchGiveNumbers)
{
  const auto expectFinite = [](const std::vector<Ring>& rings) {
    RingTable table;
    table.rings = rings;
    for (const auto interpolation : { RingInterpolation::LinearAngles, RingInterpolation::Slerp })
    {
      const TiltedDisk disk(table, 4.9, SpinSense::FromCode, interpolation);
      std::vector<double> radii = { 0, 1e-320, 1e-300, 1e-12, 0.5, 20 };
      for (const double knot : disk.knots())
      {
        radii.insert(radii.end(), { knot, std::nextafter(knot, 0), std::nextafter(knot, 99) });
      }
      for (const double r : radii)
      {
        const RingFrame f = disk.frame(r);
        for (const Vec3& axis : { f.a, f.b, f.n })
        {
          EXPECT_NEAR(length(axis), 1, 1e-9) << r;
        }
        EXPECT_NEAR(dot(f.a, f.b), 0, 1e-9) << r;
        for (const double number : { f.bendA, f.bendB, f.rotation, f.expansion, disk.scaleHeight(r),
               disk.systemicVelocity(r), disk.areaElement(r, 1), disk.skyJacobian(r, 1),
               disk.fastestRotation(r), length(disk.velocity(r, 2)),
               length(disk.position(r, 2, 0.1)) })
        {
          EXPECT_TRUE(std::isfinite(number)) << r;
        }
        EXPECT_FALSE(std::isnan(normalFocalHeight(f)));
      }
    }
  };
  const Ring one = ring(0, 100, 90, 40, 30), other = ring(0, 200, 2, -1, 1e-300);
  for (const double inner : { 0.0, 1e-310, 1e-9, 1.0, 40.0, 647999.0 })
  {
    for (const double apart : { 0.0, 5e-324, 1e-300, 1e-200, 1e-100, 1e-16, 1e-10, 1e-6 })
    {
      std::vector<Ring> rings = { one, other, one, other };
      for (std::size_t k = 0; k < rings.size(); ++k)
      {
        rings[k].radius = inner + (k % 2 == 0 ? 0 : apart) + (k < 2 ? 0 : 1);
      }
      expectFinite(rings);
    }
  }
  // From one side to the other, by way of face-on and edge-on.
  for (const double apart : { 1e-300, 1e-10, 1.0 })
  {
    expectFinite({ ring(0, 0, 0, 0, 0), ring(apart, 1, 0, 180, 180) });
    expectFinite({ ring(0, 0, 0, 90, 0), ring(apart, 1, 0, -90, 360) });
    expectFinite({ ring(apart, 1, 0, 40, 30), ring(2 * apart, 1, 0, 140, 210) });
  }
}

} // namespace galaxy
