#ifndef galaxy_ClusterSystem_h
#define galaxy_ClusterSystem_h

#include "Filters/Model/SpheroidPlaces.h"

#include <cstddef>
#include <vector>

namespace galaxy
{
/// A spheroid made of star clusters, each a round Plummer (1911) sphere: those of its list, or as
/// many as it says, of equal light, where its density has them.
class ClusterSystem
{
public:
  /// `count` particles share the light equally: cluster by cluster, each has its share of them to
  /// the nearest whole number of the running sum.
  ClusterSystem(const SpheroidDescription& spheroid, const TiltedDisk& disk, const RandomKey& key,
    std::size_t count);

  static bool describedBy(const SpheroidDescription& spheroid)
  {
    return spheroid.clusters > 0 || !spheroid.listed.empty();
  }

  const std::vector<StarCluster>& clusters() const { return this->members; }
  /// The first particle of each cluster, and at the end their number.
  const std::vector<std::size_t>& starts() const { return this->firsts; }

  /// Where particle i is.
  Vec3 operator()(std::uint64_t i) const;

private:
  RandomKey key;
  EvenFractions fraction;
  RadialProfile plummer;
  std::vector<StarCluster> members;
  std::vector<std::size_t> firsts;
};
} // namespace galaxy

#endif
