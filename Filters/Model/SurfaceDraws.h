#ifndef galaxy_SurfaceDraws_h
#define galaxy_SurfaceDraws_h

#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"

#include <vector>

namespace galaxy
{
/// Points uniform in the area of a disc's warped surface, dA = r sqrt(1 + (r kappa)^2) dr dtheta.
///
/// The surface is cut into narrow rings of known area; draw j of N falls into the ring that the
/// running area passes at (j + 1/2)/N, so that each gets its number to within one, and there is
/// placed by rejection.
class SurfaceDraws
{
public:
  struct Point
  {
    double r;     ///< kpc
    double theta; ///< radians
  };

  SurfaceDraws(const TiltedDisk& disk, double inner, double outer);

  /// Draw `index` of `count`.
  Point draw(const RandomKey& key, std::size_t index, std::size_t count) const;
  /// kpc^2
  double area() const { return this->ends.back(); }
  /// What the surface covers on the sky, its sheets one by one, kpc^2.
  double skyArea() const { return this->onSky; }

private:
  struct Ring
  {
    double inner2; ///< r^2 from here
    double outer2; ///< to here
    double most;   ///< sqrt(1 + (r kappa)^2) is nowhere more
  };

  const TiltedDisk& disk;
  std::vector<Ring> rings;
  std::vector<double> ends; ///< running area
  double onSky = 0;
};
} // namespace galaxy

#endif
