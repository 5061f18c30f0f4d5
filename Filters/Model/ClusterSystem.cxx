#include "Filters/Model/ClusterSystem.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
SpheroidDescription plummerSphere()
{
  SpheroidDescription sphere;
  sphere.profile = SpheroidProfile::Plummer;
  return sphere;
}

std::vector<StarCluster> drawnClusters(
  const SpheroidDescription& spheroid, const TiltedDisk& disk, const RandomKey& key)
{
  const SpheroidPlaces places(spheroid, disk, key, RandomStream::SpheroidPlace);
  std::vector<StarCluster> clusters(spheroid.clusters);
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    clusters[c].position = places(c);
  }
  return clusters;
}
} // namespace

ClusterSystem::ClusterSystem(const SpheroidDescription& spheroid, const TiltedDisk& disk,
  const RandomKey& key, std::size_t count)
  : key(key)
  , fraction(key, RandomStream::ClusterStar)
  , plummer(plummerSphere())
  , members(spheroid.listed.empty() ? drawnClusters(spheroid, disk, key) : spheroid.listed)
{
  double whole = 0;
  for (StarCluster& cluster : this->members)
  {
    cluster.radius = cluster.radius > 0 ? cluster.radius : spheroid.clusterRadius;
    whole += cluster.luminosity;
  }
  double before = 0;
  for (const StarCluster& cluster : this->members)
  {
    this->firsts.push_back(static_cast<std::size_t>(std::llround(before / whole * count)));
    before += cluster.luminosity;
  }
  this->firsts.push_back(count);
}

Vec3 ClusterSystem::operator()(std::uint64_t i) const
{
  const auto next = std::upper_bound(this->firsts.begin(), this->firsts.end(), i);
  const StarCluster& cluster = this->members[next - this->firsts.begin() - 1];
  Random random(this->key, RandomStream::ClusterStar, i);
  return cluster.position +
    cluster.radius * this->plummer.radius(this->fraction(i)) * randomDirection(random);
}
} // namespace galaxy
