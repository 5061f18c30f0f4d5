#ifndef galaxy_TileOrder_h
#define galaxy_TileOrder_h

#include "Filters/Splatting/TileComposite.h"

namespace galaxy
{
/// Puts what shares a step of Splat::depth in the order of its true depth, in double precision;
/// what has that in common too, in the order of Projection::isBeforeAtSameDepth(). The splats from
/// `begin` to `end` are sorted by their steps.
void orderTies(KeyedSlot* begin, KeyedSlot* end, const TileTask& task);
} // namespace galaxy

#endif
