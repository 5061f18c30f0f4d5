#ifndef galaxy_GroupBuilder_h
#define galaxy_GroupBuilder_h

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/Placement.h"

#include <vector>

namespace galaxy
{
/// A member of a group in the frame of the first one.
struct GroupPlace
{
  GalaxyDescription galaxy; ///< as read; its distance is the true one, whatever the separation
  Placement placement;
};

/// Where all of them are. Throws Error naming the file at fault, and the key where a magnification
/// or the separation is not greater than 0.
std::vector<GroupPlace> placesOf(const GroupDescription& group);

/// Builds every member of a group and places it by right ascension, declination and distance, in
/// its own tangent frame, into the sky frame of the first member (origin at its centre, kpc),
/// magnified about its own centre. Components are named "GALAXY/COMPONENT". `places` are the
/// group's: what they have read is not read again.
///
/// Every member draws its own random numbers: options.seed plus its place in the list.
/// Throws Error as placesOf does.
Particles buildGroup(const GroupDescription& group, const std::vector<GroupPlace>& places,
  const BuildOptions& options = {});
Particles buildGroup(const GroupDescription& group, const BuildOptions& options = {});
} // namespace galaxy

#endif
