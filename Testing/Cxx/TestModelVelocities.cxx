#include "Testing/Cxx/HardCaseFixtures.h"

// How the particles of whole models move.

namespace galaxy
{
namespace
{
constexpr std::array<SpinSense, 3> senses = { SpinSense::FromCode, SpinSense::Clockwise,
  SpinSense::CounterClockwise };

/// A disc of one plane that turns and expands.
RingTable expandingDisk(double inclination, RingCode code)
{
  RingTable table;
  table.code = code;
  for (const double radius : { 0.0, 500.0 })
  {
    table.rings.push_back(ring(radius, 150, 0, inclination, 70));
    table.rings.back().expansionVelocity = 40;
  }
  return table;
}

Galaxy spinning(const RingTable& rings, ComponentDescription component, SpinSense spin)
{
  Galaxy input = galaxyOf(rings, { std::move(component) });
  input.description.spin = spin;
  return input;
}
} // namespace

TEST(ModelVelocities, AlongTheLineOfSightAreTheObservedOnesWhateverTheSpin)
{
  for (const double inclination : { 40.0, 120.0, -30.0 })
  {
    for (const RingCode code : { RingCode::Tirific, RingCode::Rotcur })
    {
      for (const SpinSense spin : senses)
      {
        ComponentDescription flat = thickLayer(ThicknessModel::Rings);
        flat.thickness.children = 1;
        const Particles particles =
          buildGalaxy(spinning(expandingDisk(inclination, code), flat, spin), withVelocities());
        const double sinI = std::sin(inclination * degree), cosI = std::cos(inclination * degree);
        const double sinPA = std::sin(70 * degree), cosPA = std::cos(70 * degree);
        // TiRiFiC's azimuth runs toward PA + 90 degrees, GALMOD's toward PA - 90.
        const double sense = code == RingCode::Tirific ? 1 : -1;
        ASSERT_GT(particles.size(), 4000u);
        for (std::size_t i = 0; i < particles.size(); ++i)
        {
          const Vec3 p = seenFromEarth(particles, i).place;
          const double along = -p.x * sinPA + p.y * cosPA;
          const double across = sense * (-p.x * cosPA - p.y * sinPA) / cosI;
          const double r = std::hypot(along, across);
          // Single precision of the place turns the velocities next to the centre.
          ASSERT_NEAR(
            -velocityOf(particles, i).z, (150 * along + 40 * across) / r * sinI, 1e-3 + 1e-3 / r)
            << inclination << ' ' << int(code) << ' ' << int(spin);
        }
      }
    }
  }
}

TEST(ModelVelocities, ArePerpendicularToTheParticlesOwnRadius)
{
  ComponentDescription stars = thickLayer();
  stars.thickness.sigma = 0.3;
  stars.thickness.scaleHeight = 0.2;
  BuildReport report;
  const Galaxy input = galaxyOf(m83Rings(), { stars }, evenLight, 30);
  const Particles particles = buildGalaxy(input, withVelocities(), &report);
  const TiltedDisk disk(m83Rings(), m83Distance);
  const std::size_t placed = particles.size() - report.components[0].filled;
  ASSERT_GT(placed, 4000u);
  for (std::size_t i = 0; i < placed; ++i)
  {
    const Vec3 p = seenFromEarth(particles, i).place, v = velocityOf(particles, i);
    ASSERT_LT(std::abs(dot(p, v)), 1e-5 * length(p) * length(v) + 2e-4);
    // |p|^2 = r^2 + z^2, and the curve does not change by more than 20 km/s a kpc but at the
    // centre.
    ASSERT_NEAR(length(v), disk.rotationVelocity(length(p)), 20) << length(p);
  }
}

TEST(ModelVelocities, LeaveThePlacesAsTheyAre)
{
  ComponentDescription stars = thickLayer();
  stars.thickness.sigma = 0.3;
  const Galaxy input = galaxyOf(m83Rings(), { stars });
  EXPECT_TRUE(
    equalBits(buildGalaxy(input).position, buildGalaxy(input, withVelocities()).position));
}
} // namespace galaxy
