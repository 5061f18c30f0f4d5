#include "Readers/Formats/Galaxy.h"

#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Brightness.h"

#include <utility>

namespace galaxy
{
Galaxy readGalaxy(const std::string& file, const Progress& progress)
{
  return readGalaxy(readGalaxyDescription(file), progress);
}

Galaxy readGalaxy(GalaxyDescription description, const Progress& progress)
{
  Galaxy galaxy;
  galaxy.description = std::move(description);
  const std::string& file = galaxy.description.file;
  galaxy.rings = readRings(galaxy.description);
  const double count = static_cast<double>(galaxy.description.images.size());
  for (const ImageDescription& image : galaxy.description.images)
  {
    if (!image.combine.empty())
    {
      galaxy.images.emplace_back();
      continue;
    }
    const double done = static_cast<double>(galaxy.images.size());
    galaxy.images.push_back(readFitsImage(besideFile(file, image.file), image.selection,
      partOf(progress, done / count, (done + 1) / count)));
    markBadPixels(image, file, galaxy.images.back());
    convertBrightness(image, galaxy.images.back());
  }
  return galaxy;
}
} // namespace galaxy
