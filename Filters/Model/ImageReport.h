#ifndef galaxy_ImageReport_h
#define galaxy_ImageReport_h

#include "Filters/Model/Background.h"

#include <array>
#include <optional>
#include <string>

namespace galaxy
{
/// What became of an image, in its own unit.
struct ImageReport
{
  std::string name;
  SkyLevel sky; ///< the background that was taken off, and how the empty sky's pixels scatter
  /// Values over the background that became intensity 0 and 1; of a combined image's sources none
  std::optional<std::array<double, 2>> clip;
  std::string note; ///< what reading did or left out; empty where nothing
};
} // namespace galaxy

#endif
