#ifndef galaxy_SkyKeys_h
#define galaxy_SkyKeys_h

#include "Readers/Formats/KeyTable.h"

#include <cmath>
#include <functional>

namespace galaxy
{
/// A right ascension; negative ones and those beyond a turn are folded into [0, 360).
template <class T, class Access>
Key<T> rightAscensionKey(Access access, const char* meaning)
{
  const Range range = Range::from(-360, 720);
  Key<T> key = numberKey<T>("ra", access, range, "degrees", meaning);
  key.set = [=](const KeyValue& value, T& out) {
    const double turn = std::fmod(value.number(range), 360.0);
    std::invoke(access, out) = turn < 0 ? turn + 360 : turn;
  };
  return key;
}

/// A position angle; whole turns are taken off, for no sine is to be had of a number such as 1e300.
template <class T, class Access>
Key<T> positionAngleKey(Access access, const char* meaning)
{
  Key<T> key = numberKey<T>("position_angle", access, Range::any(), "degrees", meaning);
  key.set = [=](const KeyValue& value, T& out) {
    std::invoke(access, out) = std::fmod(value.number(Range::any()), 360.0);
  };
  return key;
}

template <class T, class Access>
Key<T> declinationKey(Access access, const char* meaning)
{
  return numberKey<T>("dec", access, Range::from(-90, 90), "degrees", meaning);
}
}

#endif
