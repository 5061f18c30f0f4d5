#ifndef galaxy_PropertyChecks_h
#define galaxy_PropertyChecks_h

#include <cstdint>
#include <stdexcept>
#include <string>

namespace galaxy
{
/// What a filter says, by its property's name, of a value that it cannot work with.
inline void requireProperty(bool isUsable, const char* property, const char* range)
{
  if (!isUsable)
  {
    throw std::runtime_error(std::string(property) + ": must be " + range);
  }
}

/// A factor: with more, lengths would be too large for the particles' float32.
inline void requirePositive(double value, const char* property)
{
  requireProperty(
    value > 0 && value <= 1e30, property, "a finite number greater than 0, at most 1e30");
}

/// The property RandomSeed as a seed.
inline std::uint64_t seedOf(int randomSeed)
{
  requireProperty(randomSeed >= 0, "RandomSeed", "at least 0");
  return static_cast<std::uint64_t>(randomSeed);
}
} // namespace galaxy

#endif
