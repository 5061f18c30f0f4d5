#include "Filters/Export/PictureCoordinates.h"

#include "Filters/Splatting/Camera.h"
#include "Readers/Formats/SkyFrame.h"

namespace galaxy
{
namespace
{
constexpr double degree = 3.14159265358979323846 / 180;

/// Of the distance: what moves a picture of 30 kpc and 10^5 pixels by a hundredth of a pixel.
constexpr double eyeTolerance = 1e-9;
/// Radians: what moves a particle 10 kpc before the sky's plane by 1e-5 kpc.
constexpr double directionTolerance = 1e-6;

Camera cameraOf(const LightPicture& picture)
{
  const PictureCamera& c = *picture.camera;
  return Camera::lookAt(c.position, c.focalPoint, c.viewUp, c.parallel, c.parallelScale,
    c.viewAngle, picture.width, picture.height);
}

/// Intermediate coordinates grow to the East and to the North, `scale` pixels a radian.
void setMatrix(const Vec3& right, const Vec3& up, const Vec3& west, const Vec3& north, double scale,
  PictureCoordinates& coordinates)
{
  const double step = 1 / (scale * degree);
  coordinates.cd[0][0] = -step * dot(right, west);
  coordinates.cd[0][1] = -step * dot(up, west);
  coordinates.cd[1][0] = step * dot(right, north);
  coordinates.cd[1][1] = step * dot(up, north);
}

/// FITS counts pixels by their centres, from 1.
PixelPosition fitsPixel(double x, double y)
{
  return { x + 0.5, y + 0.5 };
}

std::optional<PictureCoordinates> fromAfar(const Camera& camera, const SkyPlace& sky)
{
  const Vec3& f = camera.forward;
  if (!(f.z < 0 && std::hypot(f.x, f.y) <= directionTolerance))
  {
    return std::nullopt;
  }
  PictureCoordinates coordinates;
  coordinates.reference = sky.centre;
  coordinates.pixel = fitsPixel(camera.centerX - camera.scale * dot(camera.right, camera.eye),
    camera.centerY - camera.scale * dot(camera.up, camera.eye));
  setMatrix(
    camera.right, camera.up, { 1, 0, 0 }, { 0, 1, 0 }, camera.scale * sky.distance, coordinates);
  return coordinates;
}

std::optional<PictureCoordinates> fromEarth(const Camera& camera, const SkyPlace& sky)
{
  if (!(length(camera.eye - Vec3{ 0, 0, sky.distance }) <= eyeTolerance * sky.distance))
  {
    return std::nullopt;
  }
  const SkyFrame frame(sky.centre, sky.distance / 1000);
  const auto inICRS = [&frame](const Vec3& v) {
    return v.x * frame.axes()[0] + v.y * frame.axes()[1] + v.z * frame.axes()[2];
  };
  const Vec3 axis = inICRS(camera.forward);
  PictureCoordinates coordinates;
  const double ra = std::atan2(axis.y, axis.x) / degree;
  coordinates.reference = { ra < 0 ? ra + 360 : ra,
    std::atan2(axis.z, std::hypot(axis.x, axis.y)) / degree };
  coordinates.pixel = fitsPixel(camera.centerX, camera.centerY);
  const SkyFrame there(coordinates.reference, 1);
  setMatrix(inICRS(camera.right), inICRS(camera.up), there.axes()[0], there.axes()[1], camera.scale,
    coordinates);
  return coordinates;
}
} // namespace

std::optional<PictureCoordinates> coordinatesOf(const LightPicture& picture)
{
  if (!picture.camera || !picture.sky || picture.camera->projection != "Camera")
  {
    return std::nullopt;
  }
  const Camera camera = cameraOf(picture);
  return camera.parallel ? fromAfar(camera, *picture.sky) : fromEarth(camera, *picture.sky);
}
} // namespace galaxy
