// The light of splats added up in a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_TilePainter_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_TilePainter_inl_h
#undef galaxy_TilePainter_inl_h
#else
#define galaxy_TilePainter_inl_h
#endif

#include "Filters/Splatting/AddLight-inl.h"
#include "Filters/Splatting/BlockHits.h"
#include "Filters/Splatting/SmallBatch-inl.h"
#include "Filters/Splatting/TileComposite.h"
#include "Filters/Splatting/TileMoves-inl.h"
#include "Filters/Splatting/WideBatch-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Draws splats into the sums of a tile.
template <TileAbsorption absorption, bool hasOpaque>
class Painter
{
public:
  Painter(const TileTask& task, TileSums& sums)
    : task(task)
    , sums(sums)
  {
    // A full block of the brightest splats, grown, must not be more than float can hold.
    const float most =
      1e38F / (static_cast<float>(BlockHits::most) * std::max(task.brightest, 1e-30F));
    const float room = std::min(std::max(std::log(most), 0.0F), 10.0F);
    this->opaqueFrom = std::min(room, 2.0F);
    this->spanDepth = room - this->opaqueFrom;
  }

  /// Footprints one by one.
  template <class Footprint>
  std::size_t paint()
  {
    Footprint footprint;
    std::size_t k = 0;
    for (; k < this->task.count && !this->endsBefore(k, 1); ++k)
    {
      const Splat& splat = this->next(k);
      if (splat.kind() == SplatKind::Near)
      {
        this->drawNear(splat);
      }
      else if (footprint.prepare(splat))
      {
        this->draw(splat, footprint);
      }
      this->endFullSpan();
    }
    this->endSpan();
    return k;
  }

  /// Gaussians in batches, of which the wide ones one by one.
  std::size_t paintGaussians()
  {
    SmallBatch batches[2];
    Gaussian wide;
    std::size_t k = 0;
    this->fetch(0, batches[0]);
    for (int turn = 0; k < this->task.count && !this->endsBefore(k, SmallBatch::size);
         k += SmallBatch::size, turn ^= 1)
    {
      // What is fetched now has long been written when it is read as vectors.
      this->fetch(k + SmallBatch::size, batches[turn ^ 1]);
      SmallBatch& batch = batches[turn];
      batch.prepare();
      const auto count =
        static_cast<int>(std::min<std::size_t>(SmallBatch::size, this->task.count - k));
      for (int i = 0; i < count; ++i)
      {
        if (!batch.touches(i))
        {
          continue;
        }
        if (batch.isSmall(i))
        {
          this->draw(batch.splats[i], batch.footprint(i));
        }
        else if (this->isForBatch(batch.splats[i], batch.pixels(i)))
        {
          this->emitLater(batch.splats[i]);
        }
        else if (batch.splats[i].kind() == SplatKind::Near)
        {
          this->drawNear(batch.splats[i]);
        }
        else if (wide.prepare(batch.splats[i]))
        {
          this->draw(batch.splats[i], wide);
        }
      }
      this->endFullSpan();
    }
    this->endSpan();
    return std::min(k, this->task.count);
  }

private:
  static constexpr std::size_t looksAfter = 2048;
  static constexpr std::size_t ahead = 16;
  static constexpr int planeSize = tileSide * tileStride; ///< from one channel to the next
  static constexpr int planes = absorption == TileAbsorption::None ? 0
    : absorption == TileAbsorption::Grey                           ? 1
                                                                   : 3;

  /// Now and then, before splat k: true if the rest is negligible.
  bool endsBefore(std::size_t k, std::size_t step)
  {
    if (planes == 0 || k % looksAfter >= step || k == 0)
    {
      return false;
    }
    this->endSpan();
    return this->restIsNegligible(this->task.count - k);
  }

  HWY_INLINE void count(const Box& box)
  {
    this->hits.add(box.x0, box.y0, box.x0 + box.columns - 1, box.y0 + box.rows - 1);
  }

  /// Contributions that are all rounded alike drift by 2^-26 each: a span ends before any pixel has
  /// had too many.
  HWY_INLINE void endFullSpan()
  {
    if (this->hits.isFull())
    {
      this->endSpan();
    }
  }

  HWY_INLINE void fetch(std::size_t k, SmallBatch& batch) const
  {
    for (int i = 0; i < SmallBatch::size; ++i)
    {
      batch.splats[i] = this->next(std::min(k + i, this->task.count - 1));
    }
  }

  /// The k-th splat from the nearest.
  HWY_INLINE const Splat& next(std::size_t k) const
  {
    const KeyedSlot* order = this->task.order;
    if (!order)
    {
      return this->task.splats[k];
    }
    const std::size_t later = std::min(k + ahead, this->task.count - 1);
    __builtin_prefetch(&this->task.splats[slotOf(order[later])]);
    return this->task.splats[slotOf(order[k])];
  }

  template <class Footprint>
  HWY_INLINE void draw(const Splat& splat, const Footprint& footprint)
  {
    this->count(footprint.box);
    if (splat.kind() == SplatKind::Emits || (planes == 0 && splat.kind() == SplatKind::Absorbs))
    {
      this->emit(splat, splat.light, footprint);
    }
    else if constexpr (planes == 0)
    {
      const SlabLight light = this->task.projection->lightOf(splat);
      this->emit(splat, this->task.isOneSource ? light.t : light.e, footprint);
    }
    else
    {
      const SlabLight light = this->task.projection->lightOf(splat);
      const float thickest = mostOf(light.t) * footprint.mostOfAPixel();
      const bool emits = mostOf(light.e) > 0;
      if (thickest > this->opaqueFrom)
      {
        this->absorbAll(splat, light, footprint);
        return;
      }
      this->depthSoFar += thickest;
      if (this->depthSoFar > this->spanDepth)
      {
        this->endSpan();
        this->depthSoFar = thickest;
      }
      const bool isThin = thickest < 0.125F;
      if (emits)
      {
        isThin ? this->absorb<true, true>(splat, light, footprint)
               : this->absorb<true, false>(splat, light, footprint);
      }
      else
      {
        isThin ? this->absorb<false, true>(splat, light, footprint)
               : this->absorb<false, false>(splat, light, footprint);
      }
    }
  }

  HWY_NOINLINE void drawNear(const Splat& splat)
  {
    const Projection& projection = *this->task.projection;
    NearFootprint footprint;
    const Camera& camera = projection.seenBy();
    footprint.prepare(projection.near(splat, this->task.kernel), camera,
      camera.scale * NearParticle::sigmas(this->task.kernel), this->task.left, this->task.bottom);
    footprint.most = nearMostOfAPixel(this->task.kernel, camera);
    this->draw(splat, footprint);
  }

  /// Whether a splat of so many pixels is better emitted with others.
  HWY_INLINE bool isForBatch(const Splat& splat, int pixels) const
  {
    const bool onlyEmits =
      splat.kind() == SplatKind::Emits || (planes == 0 && splat.kind() == SplatKind::Absorbs);
    return !hasOpaque && onlyEmits && pixels >= WideBatch::fewestPixels &&
      splat.h >= WideGaussian::narrowest;
  }

  HWY_INLINE void emitLater(const Splat& splat)
  {
    this->late.add(splat);
    if (this->late.isFull())
    {
      this->emitLate();
      this->count({ 0, 0, tileSide, tileSide });
    }
  }

  HWY_NOINLINE void emitLate()
  {
    this->late.addTo(this->sums.emitted);
    this->late.clear();
  }

  /// The weights with the pixels left out whose opaque geometry is nearer.
  template <class D>
  HWY_INLINE hn::Vec<D> seen(D d, hn::Vec<D> w, const Splat& splat, int y, int x) const
  {
    if constexpr (hasOpaque)
    {
      const auto opaque = hn::LoadU(d, &this->sums.opaque[y][x]);
      const auto depth = hn::Set(d, static_cast<float>(splat.depth));
      return hn::IfThenZeroElse(hn::Lt(opaque, depth), w);
    }
    return w;
  }

  /// E <- E + e.
  template <class Footprint>
  HWY_INLINE void emit(const Splat& splat, const float* light, const Footprint& footprint)
  {
    using Vector = hn::Vec<typename Footprint::D>;
    addLight<hasOpaque>(this->sums.emitted, light, footprint,
      [&](Vector w, int y, int x) { return this->seen(typename Footprint::D(), w, splat, y, x); });
  }

  /// X <- X + (E + X)(e^t - 1), tau <- tau + t; what the splat emits itself, e phi(t), is dimmed by
  /// its own t with all else: E <- E + e phi(t) e^t = E + e (e^t - 1)/t.
  template <bool emits, bool isThin, class Footprint>
  HWY_NOINLINE void absorb(const Splat& splat, const SlabLight& light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    const Box box = footprint.box;
    const int first = box.y0 * tileStride + box.x0;
    const float* before = &this->emittedBefore(box).values[0][0][0] + first;
    float* emitted = &this->sums.emitted.values[0][0][0] + first;
    float* surplus = &this->sums.surplus.values[0][0][0] + first;
    float* depths = &this->sums.depth.values[0][0][0] + first;
    for (int y = 0; y < box.rows; ++y)
    {
      const auto row = footprint.rowAt(y);
      for (int x = 0; x < box.columns; x += lanes(d))
      {
        const Vector w = this->seen(d, footprint.weights(row, y, x), splat, box.y0 + y, box.x0 + x);
        for (int plane = 0; plane < planes; ++plane)
        {
          const int at = plane * planeSize + y * tileStride + x;
          const Vector t = hn::Mul(w, hn::Set(d, light.t[plane]));
          const Vector grown = growth<isThin>(d, t);
          const Vector gain = hn::Mul(grown, t);
          hn::StoreU(hn::Add(hn::LoadU(d, depths + at), t), d, depths + at);
          // One plane of optical depth stands for all three channels.
          for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
          {
            const int place = c * planeSize + y * tileStride + x;
            const Vector E = hn::LoadU(d, before + place), X = hn::LoadU(d, surplus + place);
            hn::StoreU(hn::MulAdd(hn::Add(E, X), gain, X), d, surplus + place);
            if constexpr (emits)
            {
              const Vector own = hn::Mul(w, hn::Set(d, light.e[c]));
              hn::StoreU(hn::MulAdd(own, grown, hn::LoadU(d, emitted + place)), d, emitted + place);
            }
          }
        }
      }
    }
  }

  /// Of any optical depth: a span ends before it with what it emits itself, e phi(t), and one
  /// begins with its t, which nothing of that span has to outgrow.
  template <class Footprint>
  HWY_NOINLINE void absorbAll(
    const Splat& splat, const SlabLight& light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    const Box box = footprint.box;
    const auto forEach = [&](auto put) {
      for (int y = box.y0; y < box.y0 + box.rows; ++y)
      {
        const auto row = footprint.rowAt(y - box.y0);
        for (int x = box.x0; x < box.x0 + box.columns; x += lanes(d))
        {
          const Vector w = footprint.weights(row, y - box.y0, x - box.x0);
          for (int plane = 0; plane < planes; ++plane)
          {
            const Vector seen = this->seen(d, w, splat, y, x);
            put(plane, y, x, seen, hn::Mul(seen, hn::Set(d, light.t[plane])));
          }
        }
      }
    };
    forEach([&](int plane, int y, int x, Vector w, Vector t) {
      const Vector left = hn::Mul(w, escapeOf(d, t));
      for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
      {
        float* emitted = &this->sums.emitted.values[c][y][x];
        hn::StoreU(hn::MulAdd(left, hn::Set(d, light.e[c]), hn::LoadU(d, emitted)), d, emitted);
      }
    });
    this->endSpan(box);
    forEach([&](int plane, int y, int x, Vector, Vector t) {
      float* depth = &this->sums.depth.values[plane][y][x];
      hn::StoreU(hn::Add(hn::LoadU(d, depth), t), d, depth);
    });
  }

  /// In a box, E and what is still to be added to it.
  HWY_INLINE const TilePlanes<float>& emittedBefore(const Box& box)
  {
    if (this->late.empty())
    {
      return this->sums.emitted;
    }
    this->late.addTo(box, this->sums.emitted, this->sums.before);
    return this->sums.before;
  }

  void endSpan()
  {
    this->endSpan({ 0, 0, tileSide, tileSide });
    this->depthSoFar = 0;
    this->hits.clear();
  }

  HWY_INLINE void endSpan(const Box& box)
  {
    if (!this->late.empty())
    {
      this->emitLate();
    }
    TileMoves<planes>::move(this->sums, box);
  }

  bool restIsNegligible(std::size_t rest) const
  {
    float most = 0;
    for (int c = 0; c < planes; ++c)
    {
      for (int y = this->task.pixels.y0; y < this->task.pixels.y1; ++y)
      {
        const float* row = this->sums.through.values[c][y];
        most =
          std::max(most, *std::max_element(row + this->task.pixels.x0, row + this->task.pixels.x1));
      }
    }
    return most <= this->task.opaque &&
      most * this->task.brightest * static_cast<float>(rest) <= this->task.negligible;
  }

  const TileTask& task;
  TileSums& sums;
  WideBatch late;       ///< not yet in the sums
  BlockHits hits;       ///< in this span
  float depthSoFar = 0; ///< no pixel has more optical depth in this span
  float spanDepth;      ///< the most that it may be before an absorber is added
  float opaqueFrom;     ///< the optical depth of an absorber that is no part of any span
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
