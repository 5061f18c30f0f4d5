#ifndef galaxy_SpheroidTables_h
#define galaxy_SpheroidTables_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/SkyFrame.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Star clusters from the text of a file with a heading: columns x, y, z (kpc, in the galaxy's
/// frame), or ra, dec (ICRS degrees, or hours and degrees with colons) and optionally distance
/// (Mpc; without it in the plane Z = 0), and optionally luminosity (of any unit) and radius (kpc).
/// Lengths may have units of their own, x[pc]. Other columns are not looked at. Throws Error naming
/// file and line.
std::vector<StarCluster> parseClusterList(
  const std::string& text, const std::string& file, const SkyPosition& centre, double distance);

/// The same where no sky is known: columns x, y, z alone.
std::vector<StarCluster> parseClusterList(const std::string& text, const std::string& file);

/// Nested ellipsoids from the text of a file with a heading: columns semi_major (kpc, increasing),
/// axis_ratio_b, axis_ratio_c, position_angle (degrees) and optionally inclination (degrees). From
/// row to row the angles are unwrapped the shorter way: the position angle within 90 degrees, or
/// within 180 where ellipsoids are inclined, for then turning one half round tilts it the other
/// way. Throws Error naming file and line.
std::vector<EllipsoidShell> parseEllipsoidShells(const std::string& text, const std::string& file);
} // namespace galaxy

#endif
