#ifndef galaxy_PictureExr_h
#define galaxy_PictureExr_h

#include "Filters/Export/LightPicture.h"

#include <functional>
#include <string>

namespace galaxy
{
enum class ExrPixel
{
  Float, ///< 32 bits, as computed
  Half,  ///< 16 bits: 11 of precision, up to 65504
};

/// Writes an OpenEXR picture: the radiance as R, G, B and the transmittance as the layer
/// `transmittance`, with the camera as attributes. Throws Error, also where light is beyond what
/// Half can hold, and ExportAborted where `progress` asks to stop.
void writePictureExr(const LightPicture& picture, const std::string& file, ExrPixel pixel,
  const std::function<bool(double)>& progress);
} // namespace galaxy

#endif
