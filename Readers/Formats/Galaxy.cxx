#include "Readers/Formats/Galaxy.h"

#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Brightness.h"

namespace galaxy
{
Galaxy readGalaxy(const std::string& file)
{
  Galaxy galaxy;
  galaxy.description = readGalaxyDescription(file);
  galaxy.rings = readRings(galaxy.description);
  for (const ImageDescription& image : galaxy.description.images)
  {
    if (!image.combine.empty())
    {
      galaxy.images.emplace_back();
      continue;
    }
    galaxy.images.push_back(readFitsImage(besideFile(file, image.file), image.selection));
    markBadPixels(image, file, galaxy.images.back());
    convertBrightness(image, galaxy.images.back());
  }
  return galaxy;
}
} // namespace galaxy
