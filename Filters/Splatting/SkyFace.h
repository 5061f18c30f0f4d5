#ifndef galaxy_SkyFace_h
#define galaxy_SkyFace_h

#include "Filters/Splatting/Camera.h"

#include <array>

namespace galaxy
{
/// One of twelve perspective pictures that together show all the sky. They look along the vertices
/// of an icosahedron, from which no direction is farther than 37.4 degrees (from the faces of a
/// cube, 54.7), and overlap, so that neighbours can be blended into each other.
class SkyFace
{
public:
  static constexpr int count = 12;

  /// Face 0 looks where `ahead` does. `scale` is the pixels a radian in its middle, where it is
  /// coarsest.
  SkyFace(const Camera& ahead, int face, double scale);

  const Camera& camera() const { return this->seen; }

  /// The largest angle from its axis that a face shows, radians.
  static double farthest();
  /// The smallest angle between `ahead` and what the face shows, radians.
  static double nearest(int face);

  /// Its share in what is seen in a direction of length 1, and where that lies on the face's
  /// picture, pixels; 0 where the face does not show it. The shares of all faces are 1 together.
  double share(const Vec3& direction, double& x, double& y) const;

private:
  Camera seen;
  std::array<Vec3, count / 2> axes; ///< of the faces on one side
};
} // namespace galaxy

#endif
