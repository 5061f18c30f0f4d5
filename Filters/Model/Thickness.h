#ifndef galaxy_Thickness_h
#define galaxy_Thickness_h

#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <cstdint>

namespace galaxy
{
/// Where every seed's particles stand in the component: seed i has those from starts[i] up to
/// starts[i + 1].
using ParticleStarts = Buffer<std::uint64_t>;

/// How many children each seed gets: the mean number of its model, rounded up or down at random so
/// that the mean is kept; at least 1, at most maximum_children. Throws Error (file, component)
/// naming the key of the thickness that is out of range.
ParticleStarts countChildren(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, const std::string& file);

/// Gives a flat disc of seeds its thickness. The children of a seed share its light times
/// `lightFactor` equally (or have all of it each: ChildLight).
///
/// A child is displaced in the plane of its seed's ring by normal deviates. Its own ring is that of
/// the radius it then has: the plane is turned with the normal, by the shortest way, into that
/// ring's, so that children stay on a warped disc and near their seed. From there it is displaced
/// along the normal of its ring by the vertical law. That is the z of tilted rings, not the normal
/// of the warped surface, (n - r kappa e_r)/sqrt(1 + (r kappa)^2) by the letters of areaElement.
/// The law's height is that at the seed, and only what lies below normalFocalHeight there is used,
/// so that layers of neighbouring rings do not cross. A child moves as its own ring does at its
/// place, but for normal deviates of velocity_dispersion along every axis. It is a function of
/// (key, its seed's draw, its number among the seed's children) and of the disc, its place whether
/// velocities are written or not.
void placeChildren(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer);
} // namespace galaxy

#endif
