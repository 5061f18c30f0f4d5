#include "Filters/Splatting/Camera.h"

namespace galaxy
{
namespace
{
/// A unit vector perpendicular to the unit vector `forward`, for a view-up that says nothing.
Vec3 anyPerpendicular(const Vec3& forward)
{
  const Vec3 axis = std::abs(forward.y) < 0.9 ? Vec3{ 0, 1, 0 } : Vec3{ 0, 0, 1 };
  return normalized(cross(forward, axis));
}
} // namespace

Camera Camera::lookAt(const Vec3& position, const Vec3& focalPoint, const Vec3& viewUp,
  bool parallel, double parallelScale, double viewAngle, int width, int height)
{
  Camera camera;
  camera.eye = position;
  if (length(focalPoint - position) > 0)
  {
    camera.forward = normalized(focalPoint - position);
  }
  const Vec3 side = cross(camera.forward, viewUp);
  const double sine = length(side);
  camera.right =
    sine > 1e-12 * length(viewUp) ? (1 / sine) * side : anyPerpendicular(camera.forward);
  camera.up = cross(camera.right, camera.forward);
  camera.parallel = parallel;
  const double halfHeight = parallel ? parallelScale : std::tan(viewAngle * M_PI / 360);
  camera.scale = height / (2 * halfHeight);
  camera.centerX = 0.5 * width;
  camera.centerY = 0.5 * height;
  camera.width = width;
  camera.height = height;
  return camera;
}
} // namespace galaxy
