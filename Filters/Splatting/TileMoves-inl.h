// From a tile's sums in single precision to those in double.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_TileMoves_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_TileMoves_inl_h
#undef galaxy_TileMoves_inl_h
#else
#define galaxy_TileMoves_inl_h
#endif

#include "Filters/Splatting/LaneMath-inl.h"
#include "Filters/Splatting/TileSums.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Moves what TileSums holds in float to double, with so many planes of transmittance.
template <int planes>
class TileMoves
{
public:
  /// The undimmed light of all pixels.
  static HWY_NOINLINE void light(TileSums& sums)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int y = 0; y < tileSide; ++y)
      {
        for (int x = 0; x < tileSide; x += lanes(Four()))
        {
          const auto all = move(&sums.recentLight.values[c][y][x], &sums.light.values[c][y][x]);
          if constexpr (planes > 0)
          {
            hn::StoreU(
              hn::DemoteTo(FourHalves(), all), FourHalves(), &sums.movedLight.values[c][y][x]);
          }
        }
      }
    }
  }

  /// The optical depth and the light kept of a square of pixels; makes the transmittance anew.
  static HWY_NOINLINE void tau(TileSums& sums, int x0, int y0, int side)
  {
    const FourHalves half;
    const int N = lanes(half);
    for (int y = y0; y < y0 + side; ++y)
    {
      for (int x = x0; x < x0 + side; x += N)
      {
        for (int plane = 0; plane < planes; ++plane)
        {
          const auto tau = hn::DemoteTo(
            half, move(&sums.recentTau.values[plane][y][x], &sums.tau.values[plane][y][x]));
          const auto through = hn::Exp(half, hn::Neg(tau));
          float* at = &sums.through.values[plane][y][x];
          const auto hidden = hn::Sub(hn::LoadU(half, at), through);
          hn::StoreU(through, half, at);
          for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
          {
            const auto all = hn::Add(hn::LoadU(half, &sums.recentLight.values[c][y][x]),
              hn::LoadU(half, &sums.movedLight.values[c][y][x]));
            float* kept = &sums.recentKept.values[c][y][x];
            hn::StoreU(hn::MulAdd(hidden, all, hn::LoadU(half, kept)), half, kept);
            move(kept, &sums.kept.values[c][y][x]);
          }
        }
      }
    }
  }

private:
  using Four = hn::CappedTag<double, 4>;
  using FourHalves = hn::Rebind<float, Four>;

  /// Adds what float holds to double and clears it; the sum.
  static HWY_INLINE hn::Vec<Four> move(float* recent, double* sum)
  {
    const Four wide;
    const FourHalves half;
    const auto all = hn::Add(hn::LoadU(wide, sum), hn::PromoteTo(wide, hn::LoadU(half, recent)));
    hn::StoreU(all, wide, sum);
    hn::StoreU(hn::Zero(half), half, recent);
    return all;
  }
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
