#ifndef galaxy_Progress_h
#define galaxy_Progress_h

#include "Readers/Formats/Error.h"

#include <functional>

namespace galaxy
{
/// Told the fraction done, 0 to 1, by the thread that asked for the work; false ends it. May be
/// empty.
using Progress = std::function<bool(double)>;

/// Work was ended by its Progress.
class Aborted : public Error
{
public:
  using Error::Error;
};

/// The progress of a part of the work that goes from `begin` to `end` of the whole. `whole` must
/// outlive it.
inline Progress partOf(const Progress& whole, double begin, double end)
{
  return !whole ? Progress() : [&whole, begin, end](double fraction) {
    return whole(begin + (end - begin) * fraction);
  };
}
} // namespace galaxy

#endif
