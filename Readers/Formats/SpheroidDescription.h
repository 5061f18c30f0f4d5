#ifndef galaxy_SpheroidDescription_h
#define galaxy_SpheroidDescription_h

#include "Readers/Formats/Vec3.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace galaxy
{
enum class SpheroidProfile
{
  Gaussian,
  Sersic,      ///< deprojected after Prugniel and Simien
  Hernquist,   ///< 1/(s (1 + s)^3), s = r/scale_radius here and below
  Exponential, ///< exp(-s)
  Plummer,     ///< (1 + s^2)^(-5/2)
  NFW,         ///< 1/(s (1 + s)^2)
  Cored,       ///< (1 + s^2)^(-slope/2)
};
enum class SpheroidPreset
{
  None,
  Bulge,
  StellarHalo,
  DarkHalo,
  Elliptical,
  DwarfSpheroidal,
  DwarfElliptical,
  DwarfIrregular,
};

/// A globular cluster of a cluster_list.
struct StarCluster
{
  Vec3 position;         ///< kpc, in the galaxy's frame
  double luminosity = 1; ///< relative to the other clusters
  double radius = 0;     ///< Plummer's, kpc; 0: cluster_radius
};

/// A row of `shells`: the ellipsoid of one semi-major axis.
struct EllipsoidShell
{
  double semiMajor = 0; ///< kpc
  std::array<double, 2> axisRatios = { 1, 1 };
  double positionAngle = 0; ///< of its major axis, degrees from North through East
  double inclination = 0;   ///< of its plane of the two longer axes, degrees
};

/// [component.spheroid]: kpc.
struct SpheroidDescription
{
  SpheroidPreset preset = SpheroidPreset::None;
  SpheroidProfile profile = SpheroidProfile::Gaussian;
  std::array<double, 3> sigma = { 0.3, 0.3, 0.2 }; ///< Gaussian: along the three axes
  double effectiveRadius = 0.5;                    ///< R_e (Sersic)
  double sersicIndex = 2;                          ///< n (Sersic)
  double scaleRadius = 2;                          ///< of all but Gaussian and Sersic
  double slope = 3.9;                              ///< gamma (Cored)
  /// Where NFW and Cored end without a truncation, in scale radii
  double concentration = 10;
  double truncation = std::numeric_limits<double>::infinity(); ///< largest semi-major axis
  std::array<double, 2> axisRatios = { 1, 1 };                 ///< b/a, c/a (not Gaussian)
  bool tilted = true;           ///< along the innermost ring's axes rather than the sky's
  bool oriented = false;        ///< in place of that: along the two angles below
  double positionAngle = 0;     ///< of the first axis, degrees
  double inclination = 0;       ///< of the plane of the first and second axis, degrees
  double centralBrightness = 1; ///< projected along its third axis, in units of intensity 1
  /// Intensity times kpc^2; NaN: from centralBrightness
  double luminosity = std::numeric_limits<double>::quiet_NaN();
  std::string lightFrom;       ///< disk component whose pixels give the light; empty: none
  double lightFraction = 0.05; ///< of that component's light
  long long clusters = 0;      ///< star clusters to draw from the profile
  std::string clusterList;     ///< file of star clusters, relative; empty: none
  double clusterRadius = 0.005;
  std::string shells;                     ///< file of nested ellipsoids, relative; empty: none
  std::vector<StarCluster> listed;        ///< what clusterList holds
  std::vector<EllipsoidShell> ellipsoids; ///< what shells holds, outward
};

/// The length along the first axis that a spheroid's profile is scaled by, kpc: sigma, R_e or the
/// scale radius.
double scaleOf(const SpheroidDescription& spheroid);
/// Where such a profile ends that nobody truncates, kpc: so far out that little of its light lies
/// beyond, and so near that the rest is still seen beside it. Infinite for NFW and Cored, which
/// have their concentration.
double usualTruncation(const SpheroidDescription& spheroid);
/// The least truncation of such a profile, kpc: within less, its mass could not be told from 0.
double leastTruncation(const SpheroidDescription& spheroid);
} // namespace galaxy

#endif
