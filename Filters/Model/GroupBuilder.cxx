#include "Filters/Model/GroupBuilder.h"

#include "Filters/Model/FiniteParticles.h"
#include "Filters/Model/ModelMemory.h"
#include "Filters/Model/Placement.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/Galaxy.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace galaxy
{
namespace
{
/// The factors as the .galaxygroup file calls them, whoever has multiplied them since.
void requireUsable(const GroupDescription& group)
{
  const auto require = [&](double value, const char* name) {
    if (!(std::isfinite(value) && value > 0))
    {
      throw Error(group.file, name, "must be a finite number greater than 0");
    }
  };
  require(group.magnification, "magnification");
  require(group.separation, "separation");
  for (const GroupMember& member : group.members)
  {
    require(member.magnification, "magnification");
  }
}

void placeMember(const Placement& placement, const GroupDescription& group,
  const GroupMember& member, Particles& particles)
{
  placeParticles(placement, particles);
  const std::size_t all = particles.size();
  requireFinite(particles, 0, all, group.file, member.galaxy);
  requireFiniteLengths(particles, 0, all, group.file, member.galaxy);
}
} // namespace

std::vector<GroupPlace> placesOf(const GroupDescription& group)
{
  requireUsable(group);
  std::vector<GroupPlace> places;
  std::optional<SkyFrame> origin;
  for (const GroupMember& member : group.members)
  {
    GalaxyDescription galaxy = readGalaxyDescription(besideFile(group.file, member.galaxy));
    const SkyFrame frame(galaxy.centre, galaxy.distance);
    origin = origin ? origin : frame;
    const auto isSame = [&](const GroupPlace& other) { return other.galaxy.name == galaxy.name; };
    if (std::any_of(places.begin(), places.end(), isSame))
    {
      throw Error(group.file, member.galaxy,
        "a second member is called " + galaxy.name + "; give each its own `name`");
    }
    places.push_back({ std::move(galaxy),
      placementOf(frame, *origin, group.magnification * member.magnification, group.separation) });
  }
  return places;
}

Particles buildGroup(const GroupDescription& group, const BuildOptions& options)
{
  return buildGroup(group, placesOf(group), options);
}

Particles buildGroup(
  const GroupDescription& group, const std::vector<GroupPlace>& places, const BuildOptions& options)
{
  std::vector<const GalaxyDescription*> galaxies;
  for (const GroupPlace& place : places)
  {
    galaxies.push_back(&place.galaxy);
  }
  requireMemoryFor(galaxies, options, 2); // the members, and all of them as one
  std::vector<Particles> parts;
  std::vector<std::string> names;
  const double count = static_cast<double>(places.size());
  for (const GroupPlace& place : places)
  {
    const double done = static_cast<double>(parts.size());
    BuildOptions memberOptions = options;
    memberOptions.seed = options.seed + parts.size();
    const Progress reading = partOf(options.progress, done / count, (done + 0.3) / count);
    memberOptions.progress = partOf(options.progress, (done + 0.3) / count, (done + 1) / count);
    parts.push_back(buildGalaxy(readGalaxy(place.galaxy, reading), memberOptions));
    names.push_back(place.galaxy.name);
    placeMember(place.placement, group, group.members[names.size() - 1], parts.back());
  }
  return mergeParticles(parts, names);
}
} // namespace galaxy
