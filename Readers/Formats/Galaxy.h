#ifndef galaxy_Galaxy_h
#define galaxy_Galaxy_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"
#include "Readers/Formats/Progress.h"
#include "Readers/Formats/RingTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// A galaxy as read: its description and all that it names.
struct Galaxy
{
  GalaxyDescription description;
  RingTable rings;
  /// In the order of the description's; one that is combined of others stays empty, for the
  /// builder.
  std::vector<Image> images;
};

/// Reads a .galaxy file with its rings and images. Throws Error naming the file at fault, Aborted
/// where `progress` ends it.
Galaxy readGalaxy(const std::string& file, const Progress& progress = {});
/// The same where its description has been read already.
Galaxy readGalaxy(GalaxyDescription description, const Progress& progress = {});
} // namespace galaxy

#endif
