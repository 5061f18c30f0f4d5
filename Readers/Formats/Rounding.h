#ifndef galaxy_Rounding_h
#define galaxy_Rounding_h

#include <cmath>

namespace galaxy
{
/// The largest power of 2 that is no larger than a positive number: what is rounded to it is exact.
/// 0 where there is none.
inline double roundingUnit(double most)
{
  return most > 0 && std::isfinite(most) ? std::ldexp(1, std::ilogb(most)) : 0;
}

/// To the nearest multiple of a unit, if there is one.
inline double roundedTo(double unit, double value)
{
  return unit > 0 ? unit * std::round(value / unit) : value;
}
} // namespace galaxy

#endif
