#ifndef galaxy_Stopwatch_h
#define galaxy_Stopwatch_h

#include <chrono>

namespace galaxy
{
class Stopwatch
{
public:
  /// Seconds since the last call.
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->last).count();
    this->last = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
};
} // namespace galaxy

#endif
