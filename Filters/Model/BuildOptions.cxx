#include "Filters/Model/BuildOptions.h"

#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
void requireUsable(const BuildOptions& options, const std::string& file)
{
  constexpr double most = 1e30; // whose square is a number still
  const auto require = [&](double value, const char* name) {
    if (!(value >= 0 && value <= most))
    {
      throw Error(file, name, "must be a finite number, 0 to 1e30");
    }
  };
  require(options.particleScale, "ParticleScale");
  require(options.viewPixel, "ViewPixel");
}

std::size_t scaledCount(const BuildOptions& options, double particles, const std::string& file,
  const std::string& component)
{
  constexpr double most = 1e15;
  const double count = options.particleScale * particles;
  if (!(count < most))
  {
    throw Error(
      file, component, "too many particles; use a smaller ParticleScale, or fewer `particles`");
  }
  return count > 0 ? std::max<std::size_t>(1, std::llround(count)) : 0;
}
} // namespace galaxy
