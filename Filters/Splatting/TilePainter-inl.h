// The light of splats added up in a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_TilePainter_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_TilePainter_inl_h
#undef galaxy_TilePainter_inl_h
#else
#define galaxy_TilePainter_inl_h
#endif

#include "Filters/Splatting/Absorb-inl.h"
#include "Filters/Splatting/AddLight-inl.h"
#include "Filters/Splatting/BlockHits.h"
#include "Filters/Splatting/ExactFootprint-inl.h"
#include "Filters/Splatting/NearFootprint-inl.h"
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
      this->setDepth(k);
      this->drawAlone(this->next(k), footprint);
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
        this->setDepth(k + i);
        if (batch.isSmall(i))
        {
          this->draw(batch.splats[i], batch.footprint(i));
        }
        else if (this->isForBatch(batch.splats[i], batch.pixels(i)))
        {
          this->emitLater(batch.splats[i]);
        }
        else
        {
          this->drawAlone(batch.splats[i], wide);
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

  /// Of the k-th splat: opaque geometry is compared with what lies there, not with steps.
  HWY_INLINE void setDepth(std::size_t k)
  {
    if constexpr (hasOpaque)
    {
      const std::size_t slot = this->task.order ? slotOf(this->task.order[k]) : k;
      this->depth = static_cast<float>(this->task.projection->depth(this->task.particles[slot]));
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
      this->emit(splat.light, footprint);
    }
    else if constexpr (planes == 0)
    {
      const SlabLight light = this->task.projection->lightOf(splat);
      if (this->task.isOneSource &&
        this->isThick(splat, mostOf(light.t) * footprint.mostOfAPixel()))
      {
        this->drawExactly(splat, light);
        return;
      }
      this->emit(this->task.isOneSource ? light.t : light.e, footprint);
    }
    else
    {
      const SlabLight light = this->task.projection->lightOf(splat);
      const float thickest = mostOf(light.t) * footprint.mostOfAPixel();
      if (thickest == 0)
      {
        this->emit(light.e, footprint);
        return;
      }
      if (this->isThick(splat, thickest))
      {
        this->drawExactly(splat, light);
        return;
      }
      if (thickest > this->opaqueFrom)
      {
        this->absorbAll(light, footprint);
        return;
      }
      this->depthSoFar += thickest;
      if (this->depthSoFar > this->spanDepth)
      {
        this->endSpan();
        this->depthSoFar = thickest;
      }
      const bool isThin = thickest < 0.125F;
      if (mostOf(light.e) > 0)
      {
        isThin ? this->absorb<true, true>(light, footprint)
               : this->absorb<true, false>(light, footprint);
      }
      else
      {
        isThin ? this->absorb<false, true>(light, footprint)
               : this->absorb<false, false>(light, footprint);
      }
    }
  }

  HWY_INLINE bool isThick(const Splat& splat, float thickest) const
  {
    return thickest > Projection::thick &&
      (splat.kind() == SplatKind::Slab || splat.kind() == SplatKind::Near);
  }

  HWY_NOINLINE void drawExactly(const Splat& splat, const SlabLight& light)
  {
    if (!this->exact.prepare(splat, this->task))
    {
      return;
    }
    this->count(this->exact.box);
    if constexpr (planes == 0)
    {
      this->emit(light.t, this->exact);
    }
    else
    {
      this->absorbAll(light, this->exact);
    }
  }

  /// With a footprint of its own, for which there is room.
  template <class Footprint>
  HWY_INLINE void drawAlone(const Splat& splat, Footprint& footprint)
  {
    if (splat.kind() == SplatKind::Near)
    {
      this->drawNear(splat);
    }
    else if (footprint.prepare(splat))
    {
      this->draw(splat, footprint);
    }
  }

  HWY_NOINLINE void drawNear(const Splat& splat)
  {
    const Projection& projection = *this->task.projection;
    const Camera& camera = projection.lens().camera();
    if (!this->near.hasTile())
    {
      this->near.setTile(camera, this->task.left, this->task.bottom);
      this->near.most = nearMostOfAPixel(this->task.kernel, camera);
    }
    const SlabLight light = projection.lightOf(splat);
    const bool onlyEmits = planes == 0 || mostOf(light.t) == 0;
    const double sigma = camera.scale * NearParticle::sigmas(this->task.kernel);
    const NearParticle particle = projection.near(splat);
    if (!(onlyEmits ? this->near.template prepare<false>(particle, sigma)
                    : this->near.template prepare<true>(particle, sigma)))
    {
      return;
    }
    if (!hasOpaque && onlyEmits && this->near.isAtNodes())
    {
      const bool isDepth = planes == 0 && this->task.isOneSource;
      this->lateNear.add(isDepth ? light.t : light.e, this->near.atNodes());
      if (this->lateNear.isFull())
      {
        this->emitLateNear();
      }
      return;
    }
    this->near.spread();
    this->draw(splat, this->near);
  }

  void emitLateNear()
  {
    this->lateNear.moveTo(this->sums.emitted);
    this->count({ 0, 0, tileSide, tileSide });
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

  /// What leaves out of a splat's weights the pixels whose opaque geometry is nearer.
  template <class Footprint>
  HWY_INLINE auto seeing() const
  {
    return [this](hn::Vec<typename Footprint::D> w, int y, int x) {
      if constexpr (hasOpaque)
      {
        const typename Footprint::D d;
        const auto opaque = hn::LoadU(d, &this->sums.opaque[y][x]);
        return hn::IfThenZeroElse(hn::Lt(opaque, hn::Set(d, this->depth)), w);
      }
      return w;
    };
  }

  template <class Footprint>
  HWY_INLINE void emit(const float* light, const Footprint& footprint)
  {
    addLight<hasOpaque>(this->sums.emitted, light, footprint, this->template seeing<Footprint>());
  }

  template <bool emits, bool isThin, class Footprint>
  HWY_NOINLINE void absorb(const SlabLight& light, const Footprint& footprint)
  {
    absorbLight<planes, emits, isThin>(this->sums, this->emittedBefore(footprint.box), light,
      footprint, this->template seeing<Footprint>());
  }

  /// Of any optical depth: a span ends before it with what it emits itself, and one begins with its
  /// depth, which nothing of that span has to outgrow.
  template <class Footprint>
  HWY_NOINLINE void absorbAll(const SlabLight& light, const Footprint& footprint)
  {
    const auto seen = this->template seeing<Footprint>();
    addEscaping<planes>(this->sums, light, footprint, seen);
    this->endSpan(footprint.box);
    addDepth<planes>(this->sums, light, footprint, seen);
  }

  /// In a box, E and what is still to be added to it.
  HWY_INLINE const TilePlanes<float>& emittedBefore(const Box& box)
  {
    if (!this->lateNear.empty())
    {
      this->emitLateNear();
    }
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
    if (!this->lateNear.empty())
    {
      this->lateNear.moveTo(this->sums.emitted);
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
  WideBatch late; ///< not yet in the sums
  NearFootprint near;
  ExactFootprint exact;
  NearLight lateNear;   ///< not yet in the sums
  BlockHits hits;       ///< in this span
  float depth = 0;      ///< of the splat that is drawn, kpc; only where something is opaque
  float depthSoFar = 0; ///< no pixel has more optical depth in this span
  float spanDepth;      ///< the most that it may be before an absorber is added
  float opaqueFrom;     ///< the optical depth of an absorber that is no part of any span
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
