#ifndef galaxy_SkyFrame_h
#define galaxy_SkyFrame_h

#include "Readers/Formats/Vec3.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <array>

namespace galaxy
{
/// The frame of a galaxy on the sky: origin at its centre, X to the West, Y to the North, Z toward
/// the observer (right-handed). Sky positions and the plane Z = 0 belong together by the gnomonic
/// projection about the galaxy's centre.
class SkyFrame
{
public:
  /// `centre` in ICRS degrees, `distance` in Mpc.
  SkyFrame(const SkyPosition& centre, double distance);

  /// Sky position to (X, Y) in kpc; false 90 degrees and more from the centre.
  bool skyToPlane(const SkyPosition& sky, double& x, double& y) const;
  /// (X, Y) in kpc to the sky.
  SkyPosition planeToSky(double x, double y) const;

  /// X, Y, Z as unit vectors in ICRS cartesian axes.
  const std::array<Vec3, 3>& axes() const { return this->directions; }
  /// The centre from the observer, kpc in ICRS cartesian axes.
  Vec3 centre() const { return -this->distance * this->directions[2]; }

private:
  double distance; ///< kpc
  std::array<Vec3, 3> directions;
};
} // namespace galaxy

#endif
