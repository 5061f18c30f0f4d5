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
#include "Filters/Splatting/TileMoves-inl.h"

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
      this->moveNowAndThen(k, 1);
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
      this->moveNowAndThen(k, SmallBatch::size);
    }
    this->finish();
    return std::min(k, this->task.count);
  }

private:
  /// Contributions that are all rounded alike drift by 2^-26 each: light moves to double after so
  /// many splats, optical depth in blocks of 8 x 8 pixels after so many absorbers that touched one.
  static constexpr std::size_t lightMovesAfter = 256;
  static constexpr int tauMovesAfter = 256;
  static constexpr int blockSide = 8;
  static constexpr int blocks = tileSide / blockSide;
  static constexpr std::size_t looksAfter = 2048;
  /// An absorber too thin for single precision to see beside 1 is left to the optical depth's sum;
  /// the transmittance, which waits for that, is never more than this behind.
  static constexpr float thinnestSeen = 0x1p-20F;
  static constexpr std::size_t ahead = 16;
  static constexpr int planeSize = tileSide * tileStride; ///< from one channel to the next
  static constexpr int planes = absorption == TileAbsorption::None ? 0
    : absorption == TileAbsorption::Grey                           ? 1
                                                                   : 3;
  using Moves = TileMoves<planes>;

  /// Now and then, before splat k: true if the rest is negligible.
  HWY_INLINE bool endsBefore(std::size_t k, std::size_t step)
  {
    return planes > 0 && k % looksAfter < step && k > 0 &&
      this->restIsNegligible(this->task.count - k);
  }

  HWY_INLINE void moveNowAndThen(std::size_t k, std::size_t step)
  {
    if ((k + step) % lightMovesAfter < step)
    {
      Moves::light(this->sums);
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
    if (splat.kind() == SplatKind::Emits || (planes == 0 && splat.kind() == SplatKind::Absorbs))
    {
      this->emit(splat, splat.light, footprint);
    }
    else if constexpr (planes == 0)
    {
      this->emit(splat, this->task.projection->lightOf(splat).t, footprint);
    }
    else
    {
      this->countVeils(footprint.box);
      const SlabLight light = this->task.projection->lightOf(splat);
      const float thickest =
        std::max({ light.t[0], light.t[1], light.t[2] }) * footprint.mostOfAPixel();
      const bool emits = light.e[0] > 0 || light.e[1] > 0 || light.e[2] > 0;
      if (thickest < thinnestSeen)
      {
        this->veil(splat, light, footprint);
        this->unseen += thickest;
        if (this->unseen > thinnestSeen)
        {
          this->moveAllTau();
        }
      }
      else if (emits)
      {
        this->pass<true, false>(splat, light, footprint);
      }
      else if (thickest < 0.125F)
      {
        this->pass<false, true>(splat, light, footprint);
      }
      else
      {
        this->pass<false, false>(splat, light, footprint);
      }
    }
  }

  /// Counts an absorber in the blocks that it touches, and moves those that have had enough.
  HWY_INLINE void countVeils(const Box& box)
  {
    const int column1 = (box.x0 + box.columns - 1) / blockSide;
    const int row1 = (box.y0 + box.rows - 1) / blockSide;
    for (int row = box.y0 / blockSide; row <= row1; ++row)
    {
      for (int column = box.x0 / blockSide; column <= column1; ++column)
      {
        if (++this->veils[row][column] == tauMovesAfter)
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
      const auto depth = hn::Set(d, static_cast<float>(splat.depth));
      return hn::IfThenZeroElse(hn::Lt(opaque, depth), w);
    }
    return w;
  }

  /// C <- C + e, tau <- tau + t: a slab whose phi(t) is 1.
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

  /// C <- C + e.
  template <class Footprint>
  HWY_INLINE void emit(const Splat& splat, const float* light, const Footprint& footprint)
  {
    // As many vectors a row as the footprint has: no loop then ends where none was expected to.
    const int vectors = (footprint.box.columns + lanes(tag) - 1) / lanes(tag);
    switch (hasOpaque || Footprint::isGeneral ? 0 : vectors)
    {
      case 1:
        return this->emitRows<1>(splat, light, footprint);
      case 2:
        return this->emitRows<2>(splat, light, footprint);
      case 3:
        return this->emitRows<3>(splat, light, footprint);
      case 4:
        return this->emitRows<4>(splat, light, footprint);
      default:
        return this->emitRows<0>(splat, light, footprint);
    }
  }

  /// Rows of so many vectors; 0: of any number, and of weights of any kind.
  template <int vectors, class Footprint>
  HWY_INLINE void emitRows(const Splat& splat, const float* light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
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
    float* HWY_RESTRICT sum = &this->sums.recentLight.values[0][box.y0][box.x0];
    for (int y = 0; y < box.rows; ++y, sum += tileStride)
    {
      const auto row = footprint.rowAt(y);
      for (int k = 0; k < count; ++k)
      {
        const Vector w = vectors > 0
          ? hn::Mul(row, columns[k])
          : this->seen(d, footprint.weights(row, y, k * N), splat, box.y0 + y, box.x0 + k * N);
        for (int c = 0; c < 3; ++c)
        {
          float* HWY_RESTRICT at = sum + c * planeSize + k * N;
          hn::StoreU(hn::MulAdd(w, e[c], hn::LoadU(d, at)), d, at);
        }
      }
    }
  }

  /// C <- C + e phi(t), then what of it the slab would hide is kept, and T <- T e^-t.
  template <bool emits, bool isThin, class Footprint>
  HWY_NOINLINE void pass(const Splat& splat, const SlabLight& light, const Footprint& footprint)
  {
    using D = typename Footprint::D;
    using Vector = hn::Vec<D>;
    const D d;
    const Box box = footprint.box;
    const int N = lanes(d);
    const int first = box.y0 * tileStride + box.x0;
    float* HWY_RESTRICT lights = &this->sums.recentLight.values[0][0][0] + first;
    const float* HWY_RESTRICT moved = &this->sums.movedLight.values[0][0][0] + first;
    float* HWY_RESTRICT kept = &this->sums.recentKept.values[0][0][0] + first;
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
          const Vector hidden = hn::Sub(T, dimmed);
          hn::StoreU(hn::Add(hn::LoadU(d, taus + at), t), d, taus + at);
          hn::StoreU(dimmed, d, throughs + at);
          // One plane of transmittance stands for all three channels.
          for (int c = plane; c < (planes == 3 ? plane + 1 : 3); ++c)
          {
            const int place = c * planeSize + y * tileStride + x;
            Vector recent = hn::LoadU(d, lights + place);
            if constexpr (emits)
            {
              recent = hn::MulAdd(hn::Mul(w, hn::Set(d, light.e[c])), phi, recent);
              hn::StoreU(recent, d, lights + place);
            }
            const Vector all = hn::Add(recent, hn::LoadU(d, moved + place));
            hn::StoreU(hn::MulAdd(hidden, all, hn::LoadU(d, kept + place)), d, kept + place);
          }
        }
      }
    }
  }

  void moveTau(int column, int row)
  {
    this->veils[row][column] = 0;
    Moves::tau(this->sums, column * blockSide, row * blockSide, blockSide);
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
    Moves::light(this->sums);
    if constexpr (planes > 0)
    {
      this->moveAllTau();
    }
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
  float unseen = 0; ///< optical depth that the transmittance may be behind
  int veils[blocks][blocks] = {};
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
