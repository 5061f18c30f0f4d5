#ifndef galaxy_AvailableMemory_h
#define galaxy_AvailableMemory_h

#include <string>

namespace galaxy
{
/// Bytes that this process can still take without being killed for it: the least of what the
/// machine has free, what the memory groups (cgroup v1 and v2) that it is in have left, each and
/// those around them, and what its own limits on address space and data leave. Infinite where
/// nothing says. Below `root` lie /proc and /sys.
double availableMemory(const std::string& root = "");

/// Throws Error (file, where) unless so many bytes are available: to be asked before a large work
/// begins. "`what` takes 7.2 GB of memory, but only 3 GB are available; `cure`".
void requireMemory(double bytes, const std::string& file, const std::string& where,
  const std::string& what, const std::string& cure);
} // namespace galaxy

#endif
