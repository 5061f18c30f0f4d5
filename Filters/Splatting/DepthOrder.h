#ifndef galaxy_DepthOrder_h
#define galaxy_DepthOrder_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace galaxy
{
/// An unsigned number that grows as the depth falls: sorted upward, the farthest comes first.
std::uint32_t farFirstKey(float depth);

/// A key in the upper half and the slot it belongs to in the lower.
using KeyedSlot = std::uint64_t;
inline KeyedSlot keyedSlot(std::uint32_t key, std::uint32_t slot)
{
  return std::uint64_t(key) << 32 | slot;
}
inline std::uint32_t slotOf(KeyedSlot item)
{
  return static_cast<std::uint32_t>(item);
}

/// Sorts upward by key; equal keys keep the order of their slots if the slots came in order.
void sortByKey(std::vector<KeyedSlot>& items, std::vector<KeyedSlot>& scratch);
} // namespace galaxy

#endif
