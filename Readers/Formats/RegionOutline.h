#ifndef galaxy_RegionOutline_h
#define galaxy_RegionOutline_h

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/RegionList.h"

#include <optional>
#include <string>
#include <vector>

namespace galaxy
{
/// The frame that coordinates are given in: pixels, or one of the sky.
struct RegionFrame
{
  bool physical = true;
  std::optional<CelestialFrame> sky;
  bool colonsAreHours = false; ///< in a longitude: of right ascensions alone
};

/// One shape of a region file, its arguments as text, and which program's meaning they have.
struct RegionShape
{
  std::string name;
  std::vector<std::string> arguments;
  bool casa = false;
};

/// The shape's outline in the pixels of the image; throws RegionFault where it makes none.
PixelRegion outlineRegion(
  const RegionShape& shape, const RegionFrame& frame, const RegionCanvas& canvas);
} // namespace galaxy

#endif
