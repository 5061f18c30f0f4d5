#include "Filters/Splatting/TileComposite.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Filters/Splatting/TileComposite.cxx"
#include <hwy/foreach_target.h>

#include "Filters/Splatting/TilePainter-inl.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
template <TileAbsorption absorption, bool hasOpaque>
std::size_t paintWith(const TileTask& task, TileSums& sums)
{
  Painter<absorption, hasOpaque> painter(task, sums);
  return task.kernel == Kernel::Gaussian ? painter.paintGaussians()
                                         : painter.template paint<Spline>();
}

std::size_t paintTile(const TileTask& task, TileSums& sums)
{
  switch (task.isOneSource ? TileAbsorption::None : task.absorption)
  {
    case TileAbsorption::None:
      return task.hasOpaque ? paintWith<TileAbsorption::None, true>(task, sums)
                            : paintWith<TileAbsorption::None, false>(task, sums);
    case TileAbsorption::Grey:
      return task.hasOpaque ? paintWith<TileAbsorption::Grey, true>(task, sums)
                            : paintWith<TileAbsorption::Grey, false>(task, sums);
    default:
      return task.hasOpaque ? paintWith<TileAbsorption::Color, true>(task, sums)
                            : paintWith<TileAbsorption::Color, false>(task, sums);
  }
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace galaxy
{
HWY_EXPORT(paintTile);

std::size_t compositeTile(const TileTask& task, TileSums& sums)
{
  return task.count > 0 ? HWY_DYNAMIC_DISPATCH(paintTile)(task, sums) : 0;
}
} // namespace galaxy
#endif
