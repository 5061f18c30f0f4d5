#include "Filters/Splatting/TileOrder.h"

#include <algorithm>
#include <vector>

namespace galaxy
{
namespace
{
std::uint32_t stepOf(KeyedSlot item)
{
  return static_cast<std::uint32_t>(item >> 32);
}

/// Light adds up in any order.
bool absorbs(KeyedSlot item, const TileTask& task)
{
  return task.splats[slotOf(item)].kind() != SplatKind::Emits;
}

/// One of several that share a step.
struct Tied
{
  double depth;
  std::uint32_t particle;
  KeyedSlot item;
};

void order(KeyedSlot* begin, KeyedSlot* end, const TileTask& task)
{
  const Projection& projection = *task.projection;
  std::vector<Tied> ties;
  ties.reserve(end - begin);
  for (const KeyedSlot* item = begin; item != end; ++item)
  {
    const std::uint32_t particle = task.particles[slotOf(*item)];
    ties.push_back({ projection.depth(particle), particle, *item });
  }
  std::sort(ties.begin(), ties.end(), [&projection](const Tied& a, const Tied& b) {
    return a.depth != b.depth ? a.depth < b.depth
                              : projection.isBeforeAtSameDepth(a.particle, b.particle);
  });
  std::transform(ties.begin(), ties.end(), begin, [](const Tied& tied) { return tied.item; });
}
} // namespace

void orderTies(KeyedSlot* begin, KeyedSlot* end, const TileTask& task)
{
  for (KeyedSlot* first = begin; first != end;)
  {
    KeyedSlot* last = first + 1;
    while (last != end && stepOf(*last) == stepOf(*first))
    {
      ++last;
    }
    if (last - first > 1 &&
      std::any_of(first, last, [&task](KeyedSlot item) { return absorbs(item, task); }))
    {
      order(first, last, task);
    }
    first = last;
  }
}
} // namespace galaxy
