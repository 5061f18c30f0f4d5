#include "Filters/Splatting/DepthOrder.h"

#include <algorithm>
#include <array>

namespace galaxy
{
namespace
{
constexpr int mostDigitBits = 11;
/// A digit's counts, and then places.
using Digits = std::array<std::uint32_t, std::size_t(1) << mostDigitBits>;
/// Fewer are sorted by comparing them.
constexpr std::ptrdiff_t fewest = 192;

/// One stable counting pass by the digit of (key - lowest) at `shift`.
void countingPass(const KeyedSlot* from, const KeyedSlot* end, KeyedSlot* to, std::uint32_t lowest,
  int shift, std::uint32_t mask, Digits& counts)
{
  std::uint32_t sum = 0;
  for (std::size_t d = 0; d <= mask; ++d)
  {
    const std::uint32_t begin = sum;
    sum += counts[d];
    counts[d] = begin;
  }
  for (; from != end; ++from)
  {
    const std::uint32_t key = static_cast<std::uint32_t>(*from >> 32) - lowest;
    to[counts[key >> shift & mask]++] = *from;
  }
}
} // namespace

void sortByKey(KeyedSlot* begin, KeyedSlot* end, std::vector<KeyedSlot>& scratch)
{
  if (end - begin < fewest)
  {
    std::sort(begin, end);
    return;
  }
  const auto keyOf = [](KeyedSlot item) { return static_cast<std::uint32_t>(item >> 32); };
  std::uint32_t lowest = UINT32_MAX;
  std::uint32_t highest = 0;
  for (const KeyedSlot* item = begin; item != end; ++item)
  {
    lowest = std::min(lowest, keyOf(*item));
    highest = std::max(highest, keyOf(*item));
  }
  int bits = 0;
  while (bits < 32 && (highest - lowest) >> bits != 0)
  {
    ++bits;
  }
  const int passes = (bits + mostDigitBits - 1) / mostDigitBits;
  const int digitBits = passes > 0 ? (bits + passes - 1) / passes : 0;
  const std::uint32_t mask = (1U << digitBits) - 1;
  std::array<Digits, 4> counts;
  for (int pass = 0; pass < passes; ++pass)
  {
    std::fill_n(counts[pass].begin(), mask + 1, 0);
  }
  for (const KeyedSlot* item = begin; item != end; ++item)
  {
    const std::uint32_t key = keyOf(*item) - lowest;
    for (int pass = 0; pass < passes; ++pass)
    {
      ++counts[pass][key >> (digitBits * pass) & mask];
    }
  }
  scratch.resize(std::max<std::size_t>(scratch.size(), end - begin));
  KeyedSlot* from = begin;
  KeyedSlot* to = scratch.data();
  const std::ptrdiff_t size = end - begin;
  for (int pass = 0; pass < passes; ++pass)
  {
    countingPass(from, from + size, to, lowest, digitBits * pass, mask, counts[pass]);
    std::swap(from, to);
  }
  if (from != begin)
  {
    std::copy(from, from + size, begin);
  }
}
} // namespace galaxy
