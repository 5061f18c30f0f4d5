// The light of splats added up in a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_TilePainter_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_TilePainter_inl_h
#undef galaxy_TilePainter_inl_h
#else
#define galaxy_TilePainter_inl_h
#endif

#include "Filters/Splatting/SmallBatch-inl.h"
#include "Filters/Splatting/TileComposite.h"

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
      if (footprint.prepare(splat))
      {
        this->draw(splat, footprint);
      }
    }
    this->finish();
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
        else if (wide.prepare(batch.splats[i]))
        {
          this->draw(batch.splats[i], wide);
        }
      }
    }
    this->finish();
    return std::min(k, this->task.count);
  }

private:
  /// Sums move to double by blocks of 8 x 8 pixels, each after so many splats that touched it:
  /// contributions that are all rounded alike drift by 2^-25 each, 1e-6 in so many.
  static constexpr int blockSide = 8;
  static constexpr int blocks = tileSide / blockSide;
  static constexpr int lightMovesAfter = 64;
  static constexpr int tauMovesAfter = 256;
  static constexpr std::size_t looksAfter = 2048;
  /// An absorber too thin for single precision to see beside 1 is left to the optical depth's sum;
  /// the transmittance, which waits for that, is never more than this behind.
  static constexpr float thinnestSeen = 0x1p-20F;
  static constexpr std::size_t ahead = 12;
  static constexpr int planeSize = tileSide * tileStride; ///< from one channel to the next
  static constexpr int planes = absorption == TileAbsorption::None ? 0
    : absorption == TileAbsorption::Grey                           ? 1
                                                                   : 3;

  /// Now and then, before splat k: true if the rest is negligible.
  HWY_INLINE bool endsBefore(std::size_t k, std::size_t step)
  {
    return planes > 0 && k % looksAfter < step && k > 0 &&
      this->restIsNegligible(this->task.count - k);
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
    const std::size_t last = this->task.count - 1;
    if (!this->task.order)
    {
      return this->task.splats[k];
    }
    __builtin_prefetch(
      &this->task.splats[slotOf(this->task.order[last - std::min(k + ahead, last)])]);
    return this->task.splats[slotOf(this->task.order[last - k])];
  }

  template <class Footprint>
  HWY_INLINE void draw(const Splat& splat, const Footprint& footprint)
  {
    this->countHits(footprint.box, splat.kind() != SplatKind::Emits);
    if (splat.kind() == SplatKind::Emits)
    {
      this->emit(splat, splat.light, footprint);
    }
    else if constexpr (planes > 0)
    {
      const SlabLight light = this->task.projection->lightOf(splat);
      const float thickest =
        std::max({ light.t[0], light.t[1], light.t[2] }) * footprint.mostOfAPixel();
      if (thickest < thinnestSeen)
      {
        this->veil(splat, light, footprint);
        this->unseen += thickest;
        if (this->unseen > thinnestSeen)
        {
          this->moveAllTau();
        }
        return;
      }
      const bool emits = light.e[0] > 0 || light.e[1] > 0 || light.e[2] > 0;
      emits                 ? this->pass<true, false>(splat, light, footprint)
        : thickest < 0.125F ? this->pass<false, true>(splat, light, footprint)
                            : this->pass<false, false>(splat, light, footprint);
    }
  }

  /// Counts the splat in the blocks that it touches, and moves those that have had enough.
  HWY_INLINE void countHits(const Box& box, bool absorbs)
  {
    const int column1 = (box.x0 + box.columns - 1) / blockSide;
    const int row1 = (box.y0 + box.rows - 1) / blockSide;
    for (int row = box.y0 / blockSide; row <= row1; ++row)
    {
      for (int column = box.x0 / blockSide; column <= column1; ++column)
      {
        if (++this->hits[row][column] == lightMovesAfter)
        {
          this->moveLight(column, row);
        }
        if (planes > 0 && absorbs && ++this->veils[row][column] == tauMovesAfter)
        {
          this->moveTau(column, row);
        }
      }
    }
  }

  /// The weights with the pixels left out whose opaque geometry is nearer.
  template <class D>
  HWY_INLINE hn::Vec<D> seen(D d, hn::Vec<D> w, const Splat& splat, int y, int x) const
  {
    if constexpr (hasOpaque)
    {
      const auto opaque = hn::LoadU(d, &this->sums.opaque[y][x]);
      return hn::IfThenZeroElse(hn::Lt(opaque, hn::Set(d, splat.depth)), w);
    }
    return w;
  }

  /// I <- I + T e, tau <- tau + t: a slab whose phi(t) is 1.
  template <class Footprint>
  HWY_NOINLINE void veil(const Splat& splat, const SlabLight& light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    this->emit(splat, light.e, footprint);
    const Box& box = footprint.box;
    for (int y = 0; y < box.rows; ++y)
    {
      const auto row = footprint.rowAt(y);
      for (int x = 0; x < box.columns; x += lanes(d))
      {
        const Vector w = this->seen(d, footprint.weights(row, y, x), splat, box.y0 + y, box.x0 + x);
        for (int plane = 0; plane < planes; ++plane)
        {
          float* tau = &this->sums.recentTau.values[plane][box.y0 + y][box.x0 + x];
          const Vector t = hn::Set(d, light.t[plane]);
          hn::StoreU(hn::MulAdd(w, t, hn::LoadU(d, tau)), d, tau);
        }
      }
    }
  }

  /// I <- I + T e.
  template <class Footprint>
  HWY_INLINE void emit(const Splat& splat, const float* light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    const Box box = footprint.box;
    const Vector e[3] = { hn::Set(d, light[0]), hn::Set(d, light[1]), hn::Set(d, light[2]) };
    const int N = lanes(d);
    float* HWY_RESTRICT sum = &this->sums.recentLight.values[0][box.y0][box.x0];
    const float* HWY_RESTRICT through = &this->sums.through.values[0][box.y0][box.x0];
    for (int y = 0; y < box.rows; ++y, sum += tileStride, through += tileStride)
    {
      const auto row = footprint.rowAt(y);
      for (int x = 0; x < box.columns; x += N)
      {
        Vector w = this->seen(d, footprint.weights(row, y, x), splat, box.y0 + y, box.x0 + x);
        if constexpr (planes == 1)
        {
          w = hn::Mul(w, hn::LoadU(d, through + x));
        }
        for (int c = 0; c < 3; ++c)
        {
          const Vector seen =
            planes == 3 ? hn::Mul(w, hn::LoadU(d, through + c * planeSize + x)) : w;
          float* HWY_RESTRICT at = sum + c * planeSize + x;
          hn::StoreU(hn::MulAdd(seen, e[c], hn::LoadU(d, at)), d, at);
        }
      }
    }
  }

  /// I <- I + T e phi(t), T <- T e^-t.
  template <bool emits, bool isThin, class Footprint>
  HWY_NOINLINE void pass(const Splat& splat, const SlabLight& light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    const Box box = footprint.box;
    const int N = lanes(d);
    const int first = box.y0 * tileStride + box.x0;
    float* HWY_RESTRICT sums = &this->sums.recentLight.values[0][0][0] + first;
    float* HWY_RESTRICT throughs = &this->sums.through.values[0][0][0] + first;
    float* HWY_RESTRICT taus = &this->sums.recentTau.values[0][0][0] + first;
    for (int y = 0; y < box.rows; ++y)
    {
      const auto row = footprint.rowAt(y);
      for (int x = 0; x < box.columns; x += N)
      {
        const Vector w = this->seen(d, footprint.weights(row, y, x), splat, box.y0 + y, box.x0 + x);
        for (int plane = 0; plane < planes; ++plane)
        {
          const int at = plane * planeSize + y * tileStride + x;
          const Vector t = hn::Mul(w, hn::Set(d, light.t[plane]));
          const Vector T = hn::LoadU(d, throughs + at);
          Vector phi, dimmed;
          if constexpr (isThin)
          {
            phi = phiOfThin(d, t);
            dimmed = hn::NegMulAdd(hn::Mul(T, t), phi, T);
          }
          else
          {
            Vector decay;
            phiOfAny(d, t, phi, decay);
            dimmed = hn::Mul(T, decay);
          }
          // One plane of transmittance stands for all three channels.
          for (int c = plane; emits && c < (planes == 3 ? plane + 1 : 3); ++c)
          {
            float* HWY_RESTRICT sum = sums + c * planeSize + y * tileStride + x;
            const Vector e = hn::Mul(hn::Mul(w, hn::Set(d, light.e[c])), phi);
            hn::StoreU(hn::MulAdd(T, e, hn::LoadU(d, sum)), d, sum);
          }
          hn::StoreU(hn::Add(hn::LoadU(d, taus + at), t), d, taus + at);
          hn::StoreU(dimmed, d, throughs + at);
        }
      }
    }
  }

  /// Adds what float holds of a block's row to double and clears it.
  static HWY_INLINE void moveRow(float* recent, double* sum)
  {
    const hn::CappedTag<double, 4> wide;
    const hn::Rebind<float, hn::CappedTag<double, 4>> half;
    for (int x = 0; x < blockSide; x += lanes(wide))
    {
      const auto more = hn::PromoteTo(wide, hn::LoadU(half, recent + x));
      hn::StoreU(hn::Add(hn::LoadU(wide, sum + x), more), wide, sum + x);
      hn::StoreU(hn::Zero(half), half, recent + x);
    }
  }

  HWY_NOINLINE void moveLight(int column, int row)
  {
    this->hits[row][column] = 0;
    for (int c = 0; c < 3; ++c)
    {
      for (int y = row * blockSide; y < (row + 1) * blockSide; ++y)
      {
        moveRow(&this->sums.recentLight.values[c][y][column * blockSide],
          &this->sums.light.values[c][y][column * blockSide]);
      }
    }
  }

  /// Moves the optical depth and makes the transmittance anew.
  HWY_NOINLINE void moveTau(int column, int row)
  {
    this->veils[row][column] = 0;
    for (int c = 0; c < planes; ++c)
    {
      for (int y = row * blockSide; y < (row + 1) * blockSide; ++y)
      {
        const int first = column * blockSide;
        double* tau = &this->sums.tau.values[c][y][first];
        moveRow(&this->sums.recentTau.values[c][y][first], tau);
        HWY_ALIGN float depth[blockSide];
        for (int x = 0; x < blockSide; ++x)
        {
          depth[x] = static_cast<float>(tau[x]);
        }
        for (int x = 0; x < blockSide; x += lanes())
        {
          hn::StoreU(hn::Exp(tag, hn::Neg(hn::LoadU(tag, depth + x))), tag,
            &this->sums.through.values[c][y][first + x]);
        }
      }
    }
  }

  void moveAllTau()
  {
    this->unseen = 0;
    for (int block = 0; block < blocks * blocks; ++block)
    {
      this->moveTau(block % blocks, block / blocks);
    }
  }

  void finish()
  {
    for (int block = 0; block < blocks * blocks; ++block)
    {
      this->moveLight(block % blocks, block / blocks);
    }
    this->moveAllTau();
  }

  bool restIsNegligible(std::size_t rest) const
  {
    float most = 0;
    for (int c = 0; c < planes; ++c)
    {
      for (int y = 0; y < this->task.rows; ++y)
      {
        const float* row = this->sums.through.values[c][y];
        most = std::max(most, *std::max_element(row, row + this->task.columns));
      }
    }
    return most * this->task.brightest * static_cast<float>(rest) <= this->task.negligible;
  }

  const TileTask& task;
  TileSums& sums;
  float unseen = 0; ///< optical depth that the transmittance may be behind
  int hits[blocks][blocks] = {};
  int veils[blocks][blocks] = {};
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
