#ifndef galaxy_AbsorptionKeys_h
#define galaxy_AbsorptionKeys_h

#include "Readers/Formats/GalaxyKeys.h"

namespace galaxy
{
/// The keys of a [[component]] that say how dust reddens, how much of it an image shows, and which
/// dust an image of light is already reddened by.
Keys<ComponentDescription> absorptionKeys();

/// What holds between them in one component, and between its sections; sets `absorption` from the
/// law of extinction. Throws Error naming the keys.
void finishAbsorption(
  const std::string& file, const toml::table& table, ComponentDescription& component);

/// What holds between them and the other components and images of the file.
void checkAbsorption(const toml::table& root, const GalaxyDescription& galaxy);
} // namespace galaxy

#endif
