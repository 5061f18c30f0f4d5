// The light of one splat added to the pixels of a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_AddLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_AddLight_inl_h
#undef galaxy_AddLight_inl_h
#else
#define galaxy_AddLight_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Rows of so many vectors; 0: of any number, and of weights of any kind.
template <int vectors, class Footprint, class Seen>
HWY_INLINE void addRows(
  TilePlanes<float>& sums, const float* light, const Footprint& footprint, Seen seen)
{
  using D = typename Footprint::D;
  using Vector = hn::Vec<D>;
  constexpr int plane = tileSide * tileStride;
  const D d;
  const int N = lanes(d);
  const Box box = footprint.box;
  const int count = vectors > 0 ? vectors : (box.columns + N - 1) / N;
  Vector columns[std::max(vectors, 1)];
  for (int k = 0; k < vectors; ++k)
  {
    columns[k] = footprint.columnsAt(k * N);
  }
  const Vector e[3] = { hn::Set(d, light[0]), hn::Set(d, light[1]), hn::Set(d, light[2]) };
  float* HWY_RESTRICT sum = &sums.values[0][box.y0][box.x0];
  for (int y = 0; y < box.rows; ++y, sum += tileStride)
  {
    const auto row = footprint.rowAt(y);
    for (int k = 0; k < count; ++k)
    {
      const Vector w = vectors > 0
        ? hn::Mul(row, columns[k])
        : seen(footprint.weights(row, y, k * N), box.y0 + y, box.x0 + k * N);
      for (int c = 0; c < 3; ++c)
      {
        float* HWY_RESTRICT at = sum + c * plane + k * N;
        hn::StoreU(hn::MulAdd(w, e[c], hn::LoadU(d, at)), d, at);
      }
    }
  }
}

/// `seen(weights, y, x)` leaves out what opaque geometry hides, if there is any.
template <bool hasOpaque, class Footprint, class Seen>
HWY_INLINE void addLight(
  TilePlanes<float>& sums, const float* light, const Footprint& footprint, Seen seen)
{
  // As many vectors a row as the footprint has: no loop then ends where none was expected to.
  const int vectors = (footprint.box.columns + lanes(tag) - 1) / lanes(tag);
  switch (hasOpaque || Footprint::isGeneral ? 0 : vectors)
  {
    case 1:
      return addRows<1>(sums, light, footprint, seen);
    case 2:
      return addRows<2>(sums, light, footprint, seen);
    case 3:
      return addRows<3>(sums, light, footprint, seen);
    case 4:
      return addRows<4>(sums, light, footprint, seen);
    default:
      return addRows<0>(sums, light, footprint, seen);
  }
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
