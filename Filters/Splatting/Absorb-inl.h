// One splat's absorption in the pixels of a tile, see TileSums.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_Absorb_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_Absorb_inl_h
#undef galaxy_Absorb_inl_h
#else
#define galaxy_Absorb_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Calls put(plane, place, w, t) with the weights of a vector of pixels and their optical depths,
/// where a plane of the sums has them; `seen` as in addLight().
template <int planes, class Footprint, class Seen, class Put>
HWY_INLINE void forEachDepth(const SlabLight& light, const Footprint& footprint, Seen seen, Put put)
{
  const typename Footprint::D d;
  const Box box = footprint.box;
  for (int y = 0; y < box.rows; ++y)
  {
    const auto row = footprint.rowAt(y);
    for (int x = 0; x < box.columns; x += lanes(d))
    {
      const auto w = seen(footprint.weights(row, y, x), box.y0 + y, box.x0 + x);
      const int place = (box.y0 + y) * tileStride + box.x0 + x;
      for (int plane = 0; plane < planes; ++plane)
      {
        put(plane, place, w, hn::Mul(w, hn::Set(d, light.t[plane])));
      }
    }
  }
}

/// The channels of a plane: one plane of optical depth stands for all three.
template <int planes, class Put>
HWY_INLINE void forEachChannel(int plane, Put put)
{
  for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
  {
    put(c);
  }
}

/// X <- X + (E + X)(e^t - 1), tau <- tau + t; what the splat emits itself, e phi(t), is dimmed by
/// its own t with all else: E <- E + e phi(t) e^t = E + e (e^t - 1)/t. `before` has E and what is
/// still to be added to it.
template <int planes, bool emits, bool isThin, class Footprint, class Seen>
HWY_INLINE void absorbLight(TileSums& sums, const TilePlanes<float>& before, const SlabLight& light,
  const Footprint& footprint, Seen seen)
{
  using Vector = hn::Vec<typename Footprint::D>;
  const typename Footprint::D d;
  forEachDepth<planes>(light, footprint, seen, [&](int plane, int place, Vector w, Vector t) {
    const Vector grown = growth<isThin>(d, t);
    const Vector gain = hn::Mul(grown, t);
    float* depth = sums.depth.at(plane, place);
    hn::StoreU(hn::Add(hn::LoadU(d, depth), t), d, depth);
    forEachChannel<planes>(plane, [&](int c) {
      float* surplus = sums.surplus.at(c, place);
      const Vector E = hn::LoadU(d, before.at(c, place)), X = hn::LoadU(d, surplus);
      hn::StoreU(hn::MulAdd(hn::Add(E, X), gain, X), d, surplus);
      if constexpr (emits)
      {
        float* emitted = sums.emitted.at(c, place);
        const Vector own = hn::Mul(w, hn::Set(d, light.e[c]));
        hn::StoreU(hn::MulAdd(own, grown, hn::LoadU(d, emitted)), d, emitted);
      }
    });
  });
}

/// E <- E + e phi(t).
template <int planes, class Footprint, class Seen>
HWY_INLINE void addEscaping(
  TileSums& sums, const SlabLight& light, const Footprint& footprint, Seen seen)
{
  using Vector = hn::Vec<typename Footprint::D>;
  const typename Footprint::D d;
  forEachDepth<planes>(light, footprint, seen, [&](int plane, int place, Vector w, Vector t) {
    const Vector left = hn::Mul(w, escapeOf(d, t));
    forEachChannel<planes>(plane, [&](int c) {
      float* emitted = sums.emitted.at(c, place);
      hn::StoreU(hn::MulAdd(left, hn::Set(d, light.e[c]), hn::LoadU(d, emitted)), d, emitted);
    });
  });
}

/// tau <- tau + t.
template <int planes, class Footprint, class Seen>
HWY_INLINE void addDepth(
  TileSums& sums, const SlabLight& light, const Footprint& footprint, Seen seen)
{
  using Vector = hn::Vec<typename Footprint::D>;
  const typename Footprint::D d;
  forEachDepth<planes>(light, footprint, seen, [&](int plane, int place, Vector, Vector t) {
    float* depth = sums.depth.at(plane, place);
    hn::StoreU(hn::Add(hn::LoadU(d, depth), t), d, depth);
  });
}
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
