#ifndef galaxy_DepthOrder_h
#define galaxy_DepthOrder_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace galaxy
{
/// A key in the upper half and the slot it belongs to in the lower, from which the last comes
/// first.
using KeyedSlot = std::uint64_t;
inline KeyedSlot keyedSlot(std::uint32_t key, std::uint32_t slot)
{
  return std::uint64_t(key) << 32 | ~slot;
}
inline std::uint32_t slotOf(KeyedSlot item)
{
  return ~static_cast<std::uint32_t>(item);
}

/// Sorts upward. The slots must come from the last to the first.
void sortByKey(KeyedSlot* begin, KeyedSlot* end, std::vector<KeyedSlot>& scratch);
} // namespace galaxy

#endif
