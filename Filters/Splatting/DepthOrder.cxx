#include "Filters/Splatting/DepthOrder.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace galaxy
{
namespace
{
constexpr int digitBits = 11;
constexpr std::size_t digits = std::size_t(1) << digitBits;

/// One stable counting pass by the digit of (key - lowest) at `shift`.
void countingPass(
  const std::vector<KeyedSlot>& from, std::vector<KeyedSlot>& to, std::uint32_t lowest, int shift)
{
  const auto digitOf = [lowest, shift](KeyedSlot item) {
    return ((static_cast<std::uint32_t>(item >> 32) - lowest) >> shift) & (digits - 1);
  };
  std::array<std::uint32_t, digits> next{};
  for (const KeyedSlot item : from)
  {
    ++next[digitOf(item)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& count : next)
  {
    const std::uint32_t first = sum;
    sum += count;
    count = first;
  }
  for (const KeyedSlot item : from)
  {
    to[next[digitOf(item)]++] = item;
  }
}
} // namespace

std::uint32_t farFirstKey(float depth)
{
  const float positiveZero = depth + 0.0f; // -0 and +0 are the same depth
  std::uint32_t bits;
  std::memcpy(&bits, &positiveZero, sizeof(bits));
  const std::uint32_t nearFirst = bits & 0x80000000u ? ~bits : bits | 0x80000000u;
  return ~nearFirst;
}

void sortByKey(std::vector<KeyedSlot>& items, std::vector<KeyedSlot>& scratch)
{
  if (items.size() < digits)
  {
    std::sort(items.begin(), items.end());
    return;
  }
  std::uint32_t lowest = UINT32_MAX;
  std::uint32_t highest = 0;
  for (const KeyedSlot item : items)
  {
    lowest = std::min(lowest, static_cast<std::uint32_t>(item >> 32));
    highest = std::max(highest, static_cast<std::uint32_t>(item >> 32));
  }
  scratch.resize(items.size());
  // Depths seen from outside share their leading bits: two passes are then enough.
  for (int shift = 0; shift < 32 && (highest - lowest) >> shift != 0; shift += digitBits)
  {
    countingPass(items, scratch, lowest, shift);
    items.swap(scratch);
  }
}
} // namespace galaxy
