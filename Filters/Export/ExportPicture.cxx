#include "Filters/Export/ExportPicture.h"

#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/PictureFits.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace galaxy
{
namespace
{
std::string extensionOf(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

void write(
  const LightPicture& picture, const std::string& file, const PictureExportOptions& options)
{
  const std::string extension = extensionOf(file);
  if (extension == ".exr")
  {
    writePictureExr(picture, file, options.pixel, options.progress);
  }
  else if (extension == ".fits" || extension == ".fit" || extension == ".fts")
  {
    writePictureFits(picture, file, options.progress);
  }
  else
  {
    throw Error(file, "", "its extension must be .fits, .fit, .fts or .exr");
  }
}
} // namespace

bool exportPicture(
  const LightPicture& picture, const std::string& file, const PictureExportOptions& options)
{
  if (picture.pixels() == 0)
  {
    throw Error(file, "", "the picture must have a pixel");
  }
  try
  {
    write(picture, file, options);
    return true;
  }
  catch (const ExportAborted&)
  {
    return false;
  }
}
} // namespace galaxy
