#include "Filters/Model/ClusterSystem.h"
#include "Filters/Model/Spheroid.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
const TiltedDisk disk(flatDisk(10), m83Distance);

/// The Milky Way's system: flat within 2 kpc, r^-3.9 outside (Bica et al. 2006).
SpheroidDescription globulars(long long clusters)
{
  SpheroidDescription spheroid;
  spheroid.profile = SpheroidProfile::Cored;
  spheroid.clusters = clusters;
  return spheroid;
}

double distanceFrom(const StarCluster& cluster, const Vec3& p)
{
  return length(p - cluster.position);
}
} // namespace

TEST(SpheroidClusters, CentresFollowTheProfile)
{
  const SpheroidDescription spheroid = globulars(3000);
  const ClusterSystem system(spheroid, disk, {}, 0);
  const RadialProfile profile(spheroid);
  ASSERT_EQ(system.clusters().size(), 3000u);
  std::vector<double> radii;
  for (const StarCluster& cluster : system.clusters())
  {
    radii.push_back(length(cluster.position) / spheroid.scaleRadius);
    EXPECT_EQ(cluster.radius, 0.005);
  }
  EXPECT_LT(kolmogorov(radii, [&](double s) { return profile.massWithin(s); }), 1.95);
  EXPECT_LE(*std::max_element(radii.begin(), radii.end()), 10);
  // More clusters leave the first where they are.
  const ClusterSystem more(globulars(5000), disk, {}, 0);
  EXPECT_EQ(more.clusters()[2999].position.x, system.clusters()[2999].position.x);
}

TEST(SpheroidClusters, EachIsAPlummerSphere)
{
  SpheroidDescription spheroid = globulars(4);
  spheroid.clusterRadius = 0.03;
  const std::size_t n = 20000;
  const ClusterSystem system(spheroid, disk, {}, n);
  for (std::size_t c = 0; c < 4; ++c)
  {
    EXPECT_EQ(system.starts()[c], c * n / 4);
    std::vector<double> radii, cosines;
    for (std::size_t i = system.starts()[c]; i < system.starts()[c + 1]; ++i)
    {
      const Vec3 p = system(i) - system.clusters()[c].position;
      radii.push_back(length(p) / 0.03);
      cosines.push_back(p.z / length(p));
    }
    EXPECT_LT(kolmogorov(radii, [](double s) { return std::pow(s * s / (1 + s * s), 1.5); }), 1.95);
    EXPECT_LT(kolmogorov(cosines, [](double z) { return (1 + z) / 2; }), 1.95);
  }
}

TEST(SpheroidClusters, ListedOnesShareByLuminosity)
{
  SpheroidDescription spheroid;
  spheroid.listed = { { { 1, 2, 3 }, 1, 0 }, { { -4, 0, 0 }, 0, 0 }, { { 0, 5, 0 }, 3, 0.1 } };
  const std::size_t n = 1001;
  const ClusterSystem system(spheroid, disk, {}, n);
  EXPECT_EQ(system.starts(), (std::vector<std::size_t>{ 0, 250, 250, 1001 }));
  EXPECT_EQ(system.clusters()[0].radius, spheroid.clusterRadius);
  EXPECT_EQ(system.clusters()[2].radius, 0.1);
  EXPECT_LT(distanceFrom(system.clusters()[0], system(249)), 1);
  EXPECT_LT(distanceFrom(system.clusters()[2], system(250)), 20);

  ComponentDescription component;
  component.spheroid = spheroid;
  component.spheroid.luminosity = 12;
  Particles particles = allocateParticles(n, false);
  placeSpheroid(disk, component, {}, n, 1, ParticleWriter(particles, 0, 0));
  double near = 0, whole = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Vec3 p = { particles.position[3 * i], particles.position[3 * i + 1],
      particles.position[3 * i + 2] };
    whole += particles.intensity[i];
    near += length(p - Vec3{ 1, 2, 3 }) < 1 ? particles.intensity[i] : 0;
  }
  EXPECT_NEAR(whole, 12, 1e-4);
  EXPECT_NEAR(near, 3, 0.05);
}

TEST(SpheroidClusters, FewerParticlesThanClusters)
{
  const ClusterSystem system(globulars(50), disk, {}, 3);
  EXPECT_EQ(system.starts().back(), 3u);
  for (std::uint64_t i = 0; i < 3; ++i)
  {
    const bool found = std::any_of(system.clusters().begin(), system.clusters().end(),
      [&](const StarCluster& cluster) { return distanceFrom(cluster, system(i)) < 0.1; });
    EXPECT_TRUE(found);
  }
}
} // namespace galaxy
