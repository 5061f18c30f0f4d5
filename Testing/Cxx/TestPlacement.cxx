#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Placement.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
struct Member
{
  const char* name;
  SkyPosition sky;
  double distance; ///< Mpc
};

const Member m83 = { "M83", m83Centre, 4.90 };
const Member members[] = {
  { "NGC 5264", { 205.4042, -29.9139 }, 4.79 },
  { "IC 4316", { 205.0754, -28.8944 }, 4.35 },
  { "UGCA 365", { 204.1283, -29.2364 }, 5.42 },
  { "ESO 444-G084", { 204.3342, -28.0461 }, 4.61 },
  { "HIDEEP J1337-33", { 204.2525, -33.3631 }, 4.55 },
  { "KK 195", { 200.2842, -31.5297 }, 5.62 },
  { "NGC 5068", { 199.7304, -21.0392 }, 5.15 },
};

SkyFrame frameOf(const Member& member)
{
  return SkyFrame(member.sky, member.distance);
}

/// Angle between two directions by the haversine formula.
double separationAngle(const SkyPosition& p, const SkyPosition& q)
{
  const double u = std::sin(0.5 * (p.dec - q.dec) * degree);
  const double v = std::sin(0.5 * (p.ra - q.ra) * degree);
  return 2 *
    std::asin(std::sqrt(u * u + std::cos(p.dec * degree) * std::cos(q.dec * degree) * v * v));
}

Particles one(const Vec3& p, const Vec3& velocity, const std::string& name)
{
  Particles particles = allocateParticles(1, true);
  const std::uint8_t color[3] = { 1, 2, 3 };
  ParticleWriter(particles, 0, 0).write(0, p, 2, color, velocity);
  particles.smoothingLength[0] = 0.25F;
  particles.components = { { name } };
  return particles;
}
} // namespace

TEST(Placement, OriginStaysItself)
{
  const Placement placement = placementOf(frameOf(m83), frameOf(m83));
  const Vec3 p = placement.apply({ 1, 2, 3 });
  EXPECT_NEAR(length(p - Vec3{ 1, 2, 3 }), 0, 1e-12);
}

TEST(Placement, MembersObeyTheLawOfCosines)
{
  for (const Member& member : members)
  {
    const Placement placement = placementOf(frameOf(member), frameOf(m83));
    const double angle = separationAngle(member.sky, m83.sky);
    const double D = 1000 * member.distance, D0 = 1000 * m83.distance;
    EXPECT_NEAR(
      length(placement.centre), std::sqrt(D * D + D0 * D0 - 2 * D * D0 * std::cos(angle)), 1e-6)
      << member.name;
    // Depth toward the observer, and the side of the sky.
    EXPECT_NEAR(placement.centre.z, D0 - D * std::cos(angle), 1e-6) << member.name;
    EXPECT_EQ(placement.centre.y > 0, member.sky.dec > m83.sky.dec) << member.name;
    EXPECT_EQ(placement.centre.x<0, member.sky.ra> m83.sky.ra) << member.name;
    // Each galaxy faces the observer: its Z leads from its centre to where we are.
    const Vec3 observer = { 0, 0, D0 };
    EXPECT_NEAR(length(placement.centre + D * placement.axes[2] - observer), 0, 1e-6);
    EXPECT_NEAR(std::acos(placement.axes[2].z), angle, 1e-9) << member.name;
    EXPECT_NEAR(length(cross(placement.axes[0], placement.axes[1]) - placement.axes[2]), 0, 1e-14);
  }
}

TEST(Placement, PairsKeepTheirDistancesInAnyFrame)
{
  // The display frame is a rotation: distances between members are those of space.
  for (const Member& p : members)
  {
    for (const Member& q : members)
    {
      const double D = 1000 * p.distance, E = 1000 * q.distance;
      const double square = D * D + E * E - 2 * D * E * std::cos(separationAngle(p.sky, q.sky));
      const Vec3 apart =
        placementOf(frameOf(p), frameOf(m83)).centre - placementOf(frameOf(q), frameOf(m83)).centre;
      EXPECT_NEAR(length(apart), std::sqrt(std::max(0.0, square)), 2e-4);
    }
  }
}

TEST(Placement, MeridianTwistOfNGC5068)
{
  // Its North, seen from M83's frame, leans by the convergence of the meridians.
  const Placement placement = placementOf(frameOf(members[6]), frameOf(m83));
  const double twist = std::atan2(placement.axes[1].x, placement.axes[1].y) / degree;
  EXPECT_NEAR(std::abs(twist), 2.0, 0.4);
  EXPECT_NEAR(std::acos(placement.axes[2].z) / degree, 9.7, 0.1);
}

TEST(Placement, MagnificationAndSeparationAreIndependent)
{
  const Placement plain = placementOf(frameOf(members[0]), frameOf(m83));
  const Placement spread = placementOf(frameOf(members[0]), frameOf(m83), 3, 0.5);
  EXPECT_NEAR(length(spread.centre - 0.5 * plain.centre), 0, 1e-12);
  Particles small = one({ 1, -2, 0.5 }, { 10, 20, 30 }, "stars");
  Particles large = one({ 1, -2, 0.5 }, { 10, 20, 30 }, "stars");
  placeParticles(plain, small);
  placeParticles(spread, large);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_FLOAT_EQ(large.velocity[k], small.velocity[k]);
  }
  const auto position = [](const Particles& p) {
    return Vec3{ p.position[0], p.position[1], p.position[2] };
  };
  EXPECT_NEAR(
    length(position(large) - spread.centre) / length(position(small) - plain.centre), 3, 1e-3);
  EXPECT_FLOAT_EQ(large.smoothingLength[0], 0.75);
  EXPECT_FLOAT_EQ(large.intensity[0], 18);
  EXPECT_FLOAT_EQ(small.intensity[0], 2);
  const Vec3 velocity = { small.velocity[0], small.velocity[1], small.velocity[2] };
  EXPECT_NEAR(length(velocity), std::sqrt(1400.0), 1e-4);
}

TEST(Placement, MergingKeepsEveryParticleAndItsComponent)
{
  std::vector<Particles> galaxies;
  galaxies.push_back(one({ 1, 2, 3 }, { 4, 5, 6 }, "stars"));
  galaxies.push_back(one({ 7, 8, 9 }, { 1, 1, 1 }, "gas"));
  galaxies[1].components.push_back({ "dust", true, { 0.8, 1, 1.3 } });
  galaxies[1].component[0] = 1;
  Particles merged = mergeParticles(galaxies, { "M83", "N5264" });
  ASSERT_EQ(merged.size(), 2u);
  ASSERT_EQ(merged.components.size(), 3u);
  EXPECT_EQ(merged.components[0].name, "M83/stars");
  EXPECT_EQ(merged.components[2].name, "N5264/dust");
  EXPECT_TRUE(merged.components[2].absorbs);
  EXPECT_EQ(merged.component[0], 0);
  EXPECT_EQ(merged.component[1], 2);
  EXPECT_EQ(merged.position[5], 9);
  EXPECT_EQ(merged.velocity[3], 1);
  EXPECT_EQ(merged.color[5], 3);
  // Without velocities in one, there are none.
  galaxies[0].velocity = Buffer<float>();
  EXPECT_TRUE(mergeParticles(galaxies, { "M83", "N5264" }).velocity.empty());
  galaxies[0].components.resize(300);
  EXPECT_THROW(mergeParticles(galaxies, { "M83", "N5264" }), Error);
}
} // namespace galaxy
