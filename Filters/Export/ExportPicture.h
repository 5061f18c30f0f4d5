#ifndef galaxy_ExportPicture_h
#define galaxy_ExportPicture_h

#include "Filters/Export/LightPicture.h"
#include "Filters/Export/PictureExr.h"

#include <functional>
#include <string>

namespace galaxy
{
struct PictureExportOptions
{
  ExrPixel pixel = ExrPixel::Float; ///< of OpenEXR; FITS is always float32
  /// Gets the fraction done and returns whether to go on; may be empty.
  std::function<bool(double)> progress;
};

/// Writes a picture in linear light, whole or not at all: .fits, .fit and .fts as FITS, .exr as
/// OpenEXR, without regard to case. False where options.progress asked to stop; then nothing is
/// left behind. Throws Error naming the file where it cannot be written.
bool exportPicture(
  const LightPicture& picture, const std::string& file, const PictureExportOptions& options = {});
} // namespace galaxy

#endif
