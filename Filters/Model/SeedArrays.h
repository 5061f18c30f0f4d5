#ifndef galaxy_SeedArrays_h
#define galaxy_SeedArrays_h

#include "Filters/Model/Seeds.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace galaxy
{
/// Grows or shrinks the arrays.
inline void resizeSeeds(Seeds& seeds, std::size_t count)
{
  seeds.radius.resize(count);
  seeds.azimuth.resize(count);
  seeds.intensity.resize(count);
  seeds.light.resize(count);
  seeds.color.resize(3 * count);
  seeds.index.resize(count);
}

/// Everything of seed i but its light.
inline void setSeed(Seeds& seeds, std::size_t i, double r, double theta, double intensity,
  const std::uint8_t* color, std::size_t index)
{
  seeds.radius[i] = static_cast<float>(r);
  seeds.azimuth[i] = static_cast<float>(theta);
  seeds.intensity[i] = static_cast<float>(intensity);
  std::copy(color, color + 3, &seeds.color[3 * i]);
  seeds.index[i] = static_cast<std::uint32_t>(index);
}
} // namespace galaxy

#endif
