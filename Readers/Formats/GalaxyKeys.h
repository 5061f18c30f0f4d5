#ifndef galaxy_GalaxyKeys_h
#define galaxy_GalaxyKeys_h

#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/KeyTable.h"

namespace galaxy
{
// Every key of a .galaxy file, by section. A section's own checks across keys are made by the
// function that reads it.
const Keys<GalaxyDescription>& fileKeys();
const Keys<GalaxyDescription>& galaxyKeys();
const Keys<ImageDescription>& imageKeys();
const Keys<ComponentDescription>& componentKeys();
const Keys<LayerDescription>& layerKeys();
const Keys<ThicknessDescription>& thicknessKeys();
const Keys<DustDescription>& dustKeys();
const Keys<SpheroidDescription>& spheroidKeys();
const Keys<SmoothingDescription>& smoothingKeys();

// Every key of a .galaxygroup file.
const Keys<GroupDescription>& groupFileKeys();
const Keys<GroupDescription>& groupKeys();
const Keys<GroupMember>& memberKeys();

/// Reads every [image.NAME] and checks what holds between their keys.
void readImages(const KeyValue& value, GalaxyDescription& out);

/// Reads [[component]] with its layers and sections.
ComponentDescription readComponent(const std::string& file, const toml::table& table);

/// Reads [component.thickness] and checks what holds between its keys.
void readThickness(const KeyValue& value, ThicknessDescription& out);
/// Tells the components where nothing in the file says how fast the galaxy rotates.
void noteRotation(const toml::table& root, GalaxyDescription& galaxy);

/// Reads [component.spheroid]: its preset first, then what the other keys say.
void readSpheroid(const KeyValue& value, SpheroidDescription& out);
/// What a preset says about each key.
SpheroidDescription spheroidPreset(SpheroidPreset preset);

/// Parses TOML; throws Error with the parser's message and line.
toml::table parseToml(const std::string& text, const std::string& file);
} // namespace galaxy

#endif
