#ifndef galaxy_Camera_h
#define galaxy_Camera_h

#include "Readers/Formats/Vec3.h"

namespace galaxy
{
/// A camera and the image it makes, reduced to what projecting a particle needs. Pixel (0, 0) is
/// the lower left one and covers [0, 1] x [0, 1] of the image plane.
struct Camera
{
  Vec3 eye;                 ///< kpc
  Vec3 right{ 1, 0, 0 };    ///< image +x; orthonormal but in an oblique parallel projection
  Vec3 up{ 0, 1, 0 };       ///< image +y
  Vec3 forward{ 0, 0, -1 }; ///< into the scene
  bool parallel = false;
  double scale = 1;   ///< pixels per kpc (parallel) or pixels per unit tangent (perspective)
  double centerX = 0; ///< pixel coordinates of the optical axis; outside the image for a tile
  double centerY = 0;
  int width = 0; ///< pixels
  int height = 0;

  /// From ParaView's camera properties; `parallelScale` is half the image's height in kpc,
  /// `viewAngle` the vertical field in degrees.
  static Camera lookAt(const Vec3& position, const Vec3& focalPoint, const Vec3& viewUp,
    bool parallel, double parallelScale, double viewAngle, int width, int height);
};
} // namespace galaxy

#endif
