#ifndef galaxy_PictureFits_h
#define galaxy_PictureFits_h

#include "Filters/Export/LightPicture.h"

#include <functional>
#include <string>

namespace galaxy
{
/// Writes the extensions RADIANCE and TRANSMITTANCE, each three planes of float32 (red, green,
/// blue), with the camera, and for a picture from Earth celestial coordinates, in their headers.
/// Throws Error, and ExportAborted where `progress` asks to stop.
void writePictureFits(const LightPicture& picture, const std::string& file,
  const std::function<bool(double)>& progress);
} // namespace galaxy

#endif
