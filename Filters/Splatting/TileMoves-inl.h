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
  /// Of the rows of a box, and of whole vectors of its columns.
  static HWY_NOINLINE void move(TileSums& sums, const Box& box)
  {
    const int N = lanes();
    const int begin = box.x0 / N * N;
    const int end = (box.x0 + box.columns + N - 1) / N * N;
    for (int y = box.y0; y < box.y0 + box.rows; ++y)
    {
      for (int plane = 0; plane < planes; ++plane)
      {
        moveSpan(sums, plane, y, begin, end);
      }
      for (int c = 0; c < 3 && planes == 0; ++c)
      {
        add(sums.emitted.values[c][y], sums.all.light.values[c][y], begin, end, nullptr);
        clear(sums.emitted.values[c][y], begin, end);
      }
    }
  }

private:
  static HWY_INLINE void moveSpan(TileSums& sums, int plane, int y, int begin, int end)
  {
    HWY_ALIGN float all[tileStride]; // the optical depth, and then the light
    float* depth = sums.depth.values[plane][y];
    float* through = sums.through.values[plane][y];
    add(depth, sums.all.tau.values[plane][y], begin, end, all);
    clear(depth, begin, end);
    for (int x = begin; x < end; x += lanes())
    {
      hn::Store(hn::Exp(tag, hn::Neg(hn::Load(tag, all + x))), tag, through + x);
    }
    // One plane of optical depth stands for all three channels.
    for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
    {
      float* emitted = sums.emitted.values[c][y];
      float* surplus = sums.surplus.values[c][y];
      for (int x = begin; x < end; x += lanes())
      {
        const V span = hn::Add(hn::Load(tag, emitted + x), hn::Load(tag, surplus + x));
        hn::Store(hn::Mul(hn::Load(tag, through + x), span), tag, all + x);
      }
      add(all, sums.all.light.values[c][y], begin, end, nullptr);
      clear(emitted, begin, end);
      clear(surplus, begin, end);
    }
  }

  /// Adds to the sum, of which `rounded` is a copy if it is wanted.
  static HWY_INLINE void add(const float* more, float* sum, int begin, int end, float* rounded)
  {
    for (int x = begin; x < end; x += lanes())
    {
      const V all = hn::Add(hn::Load(tag, sum + x), hn::Load(tag, more + x));
      hn::Store(all, tag, sum + x);
      if (rounded)
      {
        hn::Store(all, tag, rounded + x);
      }
    }
  }
  static HWY_INLINE void add(const float* more, double* sum, int begin, int end, float* rounded)
  {
    const hn::CappedTag<double, 4> wide;
    const hn::Rebind<float, decltype(wide)> half;
    for (int x = begin; x < end; x += lanes(wide))
    {
      const auto all =
        hn::Add(hn::Load(wide, sum + x), hn::PromoteTo(wide, hn::Load(half, more + x)));
      hn::Store(all, wide, sum + x);
      if (rounded)
      {
        hn::Store(hn::DemoteTo(half, all), half, rounded + x);
      }
    }
  }

  static HWY_INLINE void clear(float* values, int begin, int end)
  {
    for (int x = begin; x < end; x += lanes())
    {
      hn::Store(hn::Zero(tag), tag, values + x);
    }
  }
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
