#include "Readers/Formats/Galaxy.h"

namespace galaxy
{
Galaxy readGalaxy(const std::string& file)
{
  Galaxy galaxy;
  galaxy.description = readGalaxyDescription(file);
  galaxy.rings = readRings(galaxy.description);
  for (const ImageDescription& image : galaxy.description.images)
  {
    galaxy.images.push_back(readFitsImage(besideFile(file, image.file), image.selection));
  }
  return galaxy;
}
} // namespace galaxy
