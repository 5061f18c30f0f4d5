#ifndef galaxy_LightPicture_h
#define galaxy_LightPicture_h

#include "Readers/Formats/Vec3.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <cstddef>
#include <optional>
#include <string>

namespace galaxy
{
/// Where a galaxy's frame stands on the sky.
struct SkyPlace
{
  std::string name;    ///< of the galaxy
  SkyPosition centre;  ///< of the frame's origin
  double distance = 0; ///< kpc
};

/// How a picture was taken, in ParaView's words; kpc and degrees.
struct PictureCamera
{
  std::string projection = "Camera"; ///< or Equirectangular or Dome
  Vec3 position{ 0, 0, 1 };
  Vec3 focalPoint;
  Vec3 viewUp{ 0, 1, 0 };
  bool parallel = false;
  double parallelScale = 1; ///< half the height, kpc (parallel)
  double viewAngle = 30;    ///< vertical field (perspective)
  double domeAngle = 180;   ///< across the picture (Dome)
};

/// A picture in linear light to be written, seen in place; rows from the bottom up.
struct LightPicture
{
  int width = 0;
  int height = 0;
  const float* radiance = nullptr;      ///< 3 a pixel, luminosity per kpc^2
  const float* transmittance = nullptr; ///< 3 a pixel
  std::optional<PictureCamera> camera;
  std::optional<SkyPlace> sky;

  std::size_t pixels() const { return std::size_t(this->width) * std::size_t(this->height); }
};
} // namespace galaxy

#endif
