// From a tile's sums in single precision to those in double.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_TileMoves_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_TileMoves_inl_h
#undef galaxy_TileMoves_inl_h
#else
#define galaxy_TileMoves_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"
#include "Filters/Splatting/TileSums.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Moves a span of TileSums, with so many planes of optical depth, from float to double.
template <int planes>
class TileMoves
{
public:
  /// Of the pixels of a box, and some beside them.
  static HWY_NOINLINE void move(TileSums& sums, const Box& box)
  {
    const int N = lanes(FourHalves());
    for (int y = box.y0; y < box.y0 + box.rows; ++y)
    {
      for (int x = box.x0 / N * N; x < box.x0 + box.columns; x += N)
      {
        if constexpr (planes == 0)
        {
          for (int c = 0; c < 3; ++c)
          {
            add(taken(sums.emitted.values[c][y] + x), sums.light.values[c][y] + x);
          }
        }
        for (int plane = 0; plane < planes; ++plane)
        {
          moveSpan(sums, plane, y, x);
        }
      }
    }
  }

private:
  using Four = hn::CappedTag<double, 4>;
  using FourHalves = hn::Rebind<float, Four>;
  using Vector = hn::Vec<FourHalves>;

  static HWY_INLINE void moveSpan(TileSums& sums, int plane, int y, int x)
  {
    const FourHalves half;
    const auto tau = add(taken(sums.depth.values[plane][y] + x), sums.tau.values[plane][y] + x);
    const Vector through = hn::Exp(half, hn::Neg(hn::DemoteTo(half, tau)));
    hn::StoreU(through, half, sums.through.values[plane][y] + x);
    // One plane of optical depth stands for all three channels.
    for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
    {
      const Vector span =
        hn::Add(taken(sums.emitted.values[c][y] + x), taken(sums.surplus.values[c][y] + x));
      add(hn::Mul(through, span), sums.light.values[c][y] + x);
    }
  }

  /// What is there, which becomes 0.
  static HWY_INLINE Vector taken(float* from)
  {
    const FourHalves half;
    const Vector all = hn::LoadU(half, from);
    hn::StoreU(hn::Zero(half), half, from);
    return all;
  }

  static HWY_INLINE hn::Vec<Four> add(Vector more, double* sum)
  {
    const Four wide;
    const auto all = hn::Add(hn::LoadU(wide, sum), hn::PromoteTo(wide, more));
    hn::StoreU(all, wide, sum);
    return all;
  }
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
