#include "Filters/Splatting/TileComposite.h"

#include "Filters/Splatting/ErfPolynomial.h"
#include "Filters/Splatting/SplineWeights.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Filters/Splatting/TileComposite.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 8>; ///< more lanes would run over the edges of most splats
using V = hn::Vec<Tag>;
constexpr Tag tag;

template <class D>
HWY_INLINE int lanes(D d)
{
  return static_cast<int>(hn::Lanes(d));
}
HWY_INLINE int lanes()
{
  return lanes(tag);
}

/// erf(u), 2e-7: the polynomial's even and odd terms apart, so that neither waits for the other.
template <class D>
HWY_INLINE hn::Vec<D> erf(D d, hn::Vec<D> u)
{
  constexpr float end = ErfPolynomial::end;
  const auto v = hn::Max(hn::Min(u, hn::Set(d, end)), hn::Set(d, -end));
  const auto s = hn::MulSub(hn::Mul(v, v), hn::Set(d, 2 / (end * end)), hn::Set(d, 1.0F));
  const auto s2 = hn::Mul(s, s);
  constexpr int last = ErfPolynomial::degree;
  static_assert(last % 2 == 1, "as many even terms as odd ones");
  const float* c = erfPolynomial.coefficients;
  auto even = hn::Set(d, c[last - 1]);
  auto odd = hn::Set(d, c[last]);
  for (int k = last - 3; k >= 0; k -= 2)
  {
    even = hn::MulAdd(even, s2, hn::Set(d, c[k]));
    odd = hn::MulAdd(odd, s2, hn::Set(d, c[k + 1]));
  }
  return hn::Mul(v, hn::MulAdd(odd, s, even));
}

/// phi(t) by its Taylor series, 2e-8 for t < 1/8.
template <class D>
HWY_INLINE hn::Vec<D> phiOfThin(D d, hn::Vec<D> t)
{
  auto sum = hn::Set(d, 1.0F / 120);
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 1.0F / 24));
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 1.0F / 6));
  sum = hn::NegMulAdd(sum, t, hn::Set(d, 0.5F));
  return hn::NegMulAdd(sum, t, hn::Set(d, 1.0F));
}

/// phi(t) and e^-t by phi's series below 1/2 and by definition above: 2e-7 everywhere.
template <class D>
HWY_INLINE void phiOfAny(D d, hn::Vec<D> t, hn::Vec<D>& phi, hn::Vec<D>& decay)
{
  auto sum = hn::Set(d, 1.0F / 362880);
  for (const float c :
    { 1.0F / 40320, 1.0F / 5040, 1.0F / 720, 1.0F / 120, 1.0F / 24, 1.0F / 6, 0.5F, 1.0F })
  {
    sum = hn::NegMulAdd(sum, t, hn::Set(d, c));
  }
  const auto one = hn::Set(d, 1.0F);
  const auto thick = hn::Exp(d, hn::Neg(t));
  const auto isThin = hn::Lt(t, hn::Set(d, 0.5F));
  phi = hn::IfThenElse(isThin, sum, hn::Div(hn::Sub(one, thick), t));
  decay = hn::IfThenElse(isThin, hn::NegMulAdd(t, sum, one), thick);
}

/// The squared distance along an axis to a pixel that begins at d.
template <class D>
HWY_INLINE hn::Vec<D> squaredGap(D tag, hn::Vec<D> d)
{
  const auto half = hn::Set(tag, 0.5F);
  const auto gap = hn::Max(hn::Sub(hn::Abs(hn::Add(d, half)), half), hn::Zero(tag));
  return hn::Mul(gap, gap);
}

/// The pixels of a tile that a splat touches.
struct Box
{
  int x0, y0, columns, rows;

  static HWY_INLINE int inTile(int pixel, float offset)
  {
    const float at = static_cast<float>(pixel) + __builtin_floorf(offset);
    return static_cast<int>(std::min(std::max(at, 0.0F), static_cast<float>(tileSide)));
  }

  HWY_INLINE bool clip(const Splat& splat, float h)
  {
    // By scalars: a vector gathered from single numbers would wait for all stores before it.
    const int x1 = inTile(splat.column() + 1, splat.x + h);
    const int y1 = inTile(splat.row() + 1, splat.y + h);
    this->x0 = inTile(splat.column(), splat.x - h);
    this->y0 = inTile(splat.row(), splat.y - h);
    this->columns = x1 - this->x0;
    this->rows = y1 - this->y0;
    return this->columns > 0 && this->rows > 0;
  }
};

/// exp(-b^2/sigma^2), sigma = h/3, in the pixels that touch the disc b < h: in each the pixel's
/// mean, which is a product of a function of its column and one of its row (GaussianFootprint has
/// the share that this leaves out, which a splat's light already makes up for).
class Gaussian
{
public:
  using D = Tag;
  Box box;

  /// False if the splat misses the tile.
  HWY_INLINE bool prepare(const Splat& splat)
  {
    const float h = std::max(splat.h, 1e-4f);
    if (!this->box.clip(splat, h))
    {
      return false;
    }
    this->h2 = h * h;
    const float a = 3 / h;
    this->axis(a, static_cast<float>(this->box.x0 - splat.column()) - splat.x, this->box.columns,
      this->column, this->columnGap);
    this->axis(a, static_cast<float>(this->box.y0 - splat.row()) - splat.y, this->box.rows,
      this->row, this->rowGap);
    // The pixel in the middle has the most of all: no more than all, nor than the peak.
    this->most = std::min(1.0f, 0.3184f * a * a);
    return true;
  }
  float mostOfAPixel() const { return this->most; }

  struct Row
  {
    V share, limit;
  };
  HWY_INLINE Row rowAt(int y) const
  {
    return { hn::Set(tag, this->row[y]), hn::Set(tag, this->h2 - this->rowGap[y]) };
  }
  /// The weights of the lanes that begin at column x of row y of the box.
  HWY_INLINE V weights(const Row& at, int, int x) const
  {
    const V share = hn::Mul(at.share, hn::LoadU(tag, this->column + x));
    return hn::IfThenElseZero(hn::Lt(hn::LoadU(tag, this->columnGap + x), at.limit), share);
  }

private:
  /// Above this, 1/1.7 pixels, differences of erf are used; below, where they would lose digits,
  /// the series. They agree to 5e-7 of the centre there.
  static constexpr float narrowest = 0.6F;

  /// The means of a/sqrt(pi) exp(-(a x)^2) over the pixels of an axis, the first of which begins at
  /// `start` from the centre, and their squared distance to it.
  HWY_INLINE void axis(float a, float start, int pixels, float* share, float* gap2) const
  {
    const int N = lanes();
    const V scale = hn::Set(tag, a);
    const V first = hn::Add(hn::Iota(tag, 0), hn::Set(tag, start));
    const V half = hn::Set(tag, 0.5f);
    if (a <= narrowest)
    {
      for (int i = 0; i < pixels; i += N)
      {
        const V d = hn::Add(first, hn::Set(tag, static_cast<float>(i)));
        hn::StoreU(wideMean(hn::Add(d, half), a), tag, share + i);
        hn::StoreU(squaredGap(tag, d), tag, gap2 + i);
      }
      return;
    }
    V cumulative = erf(tag, hn::Mul(scale, first));
    for (int i = 0; i < pixels; i += N)
    {
      const V d = hn::Add(first, hn::Set(tag, static_cast<float>(i)));
      // The last edge of so many pixels is among the lanes, or begins the next ones.
      const V next = pixels - i < N
        ? cumulative
        : erf(tag, hn::MulAdd(scale, hn::Set(tag, static_cast<float>(N)), hn::Mul(scale, d)));
      hn::StoreU(hn::Mul(half, hn::Sub(following(cumulative, next), cumulative)), tag, share + i);
      hn::StoreU(squaredGap(tag, d), tag, gap2 + i);
      cumulative = next;
    }
  }

  /// Every lane the next one's value; the last has `first` of what follows.
  static HWY_INLINE V following(V v, V first)
  {
    const hn::RebindToSigned<Tag> ints;
    const int last = lanes() - 1;
    const auto next = hn::Min(hn::Iota(ints, 1), hn::Set(ints, last));
    const V moved = hn::TableLookupLanes(v, hn::IndicesFromVec(tag, next));
    const auto isLast = hn::Eq(hn::Iota(tag, 0), hn::Set(tag, static_cast<float>(last)));
    const V all = hn::TableLookupLanes(first, hn::IndicesFromVec(tag, hn::Zero(ints)));
    return hn::IfThenElse(isLast, all, moved);
  }

  /// exp(-a^2 (x+u)^2) in powers of u, by Hermite's polynomials, averaged over the pixel |u| < 1/2:
  /// with z = (a x)^2, b = a^2 it is a/sqrt(pi) e^-z times
  ///   1 + b (z - 1/2)/6 + b^2 (z^2 - 3z + 3/4)/120 + b^3 (z^3 - 15/2 z^2 + 45/4 z - 15/8)/5040.
  static HWY_INLINE V wideMean(V x, float a)
  {
    const auto number = [](float c) { return hn::Set(tag, c); };
    const float b = a * a;
    const V z = hn::Mul(number(b), hn::Mul(x, x));
    const V second = hn::Sub(z, number(0.5F));
    const V fourth = hn::MulAdd(hn::Sub(z, number(3)), z, number(0.75F));
    const V sixth =
      hn::MulAdd(hn::MulAdd(hn::Sub(z, number(7.5F)), z, number(11.25F)), z, number(-1.875F));
    const V sum = hn::MulAdd(sixth, number(b * b * b / 5040),
      hn::MulAdd(fourth, number(b * b / 120), hn::MulAdd(second, number(b / 6), number(1))));
    return hn::Mul(hn::Mul(number(a * 0.564189584F), hn::Exp(tag, hn::Neg(z))), sum);
  }

  float h2;
  float most;
  HWY_ALIGN float column[tileStride];
  HWY_ALIGN float columnGap[tileStride];
  HWY_ALIGN float row[tileStride];
  HWY_ALIGN float rowGap[tileStride];
};

/// The projected cubic spline, see SplineWeights.
class Spline
{
public:
  using D = Tag;
  Box box;

  HWY_INLINE bool prepare(const Splat& splat)
  {
    const float h = std::max(splat.h, 1e-3f);
    if (!this->box.clip(splat, h))
    {
      return false;
    }
    this->table.fill(static_cast<float>(splat.column() - this->box.x0) + splat.x,
      static_cast<float>(splat.row() - this->box.y0) + splat.y, h, this->box.columns,
      this->box.rows);
    this->most = std::min(1.0f, 2 / (h * h)); // c(0) = 1.91
    return true;
  }
  float mostOfAPixel() const { return this->most; }

  struct Row
  {
  };
  HWY_INLINE Row rowAt(int) const { return {}; }
  HWY_INLINE V weights(const Row&, int y, int x) const
  {
    return hn::LoadU(tag, this->table.weights[y] + x);
  }

private:
  SplineWeights table;
  float most;
};

/// One splat of a SmallBatch.
class SmallGaussian
{
public:
  using D = Tag;
  using Vector = hn::Vec<D>;
  static constexpr int batch = static_cast<int>(hn::MaxLanes(D()));
  static constexpr int mostPixels = 8; ///< along each axis

  Box box;
  float most;
  const float* columns; ///< weights of columns: four of every splat, then four more
  const float* gaps;    ///< squared distances, likewise
  const float* rows;    ///< weights of rows, a batch apart
  const float* limits;  ///< of the columns' squared distances, likewise

  float mostOfAPixel() const { return this->most; }

  struct Row
  {
    Vector share, limit;
  };
  HWY_INLINE Row rowAt(int y) const
  {
    return { hn::Set(D(), this->rows[y * batch]), hn::Set(D(), this->limits[y * batch]) };
  }
  HWY_INLINE Vector weights(const Row& at, int, int x) const
  {
    const Vector share = hn::Mul(at.share, fours(this->columns, x));
    return hn::IfThenElseZero(hn::Lt(fours(this->gaps, x), at.limit), share);
  }

private:
  static HWY_INLINE Vector fours(const float* from, int x)
  {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (batch == 8)
    {
      const hn::Half<D> half;
      return hn::Combine(D(), hn::LoadU(half, from + 4 * batch), hn::LoadU(half, from));
    }
#endif
    return hn::LoadU(D(), from + x / 4 * 4 * batch + x % 4);
  }
};

/// The footprints of as many splats as a vector has lanes, prepared together: the vectors run over
/// the splats, so that no splat waits for its own erf.
class SmallBatch
{
public:
  static constexpr int size = SmallGaussian::batch;
  alignas(64) Splat splats[size];

  /// Prepares the splats that are small: those for which isSmall() then is true.
  HWY_INLINE void prepare()
  {
    const D d;
    const Ints ints;
    const auto steps = hn::Mul(hn::Iota(ints, 0), hn::Set(ints, 8));
    const auto* words = reinterpret_cast<const std::int32_t*>(this->splats);
    const auto field = [&](
                         int k) { return hn::BitCast(d, hn::GatherIndex(ints, words + k, steps)); };
    const auto where = hn::GatherIndex(ints, words, steps);
    const auto mask = hn::Set(ints, 0x7fff);
    const auto middle = hn::Set(ints, 0x4000);
    const auto column = hn::ConvertTo(d, hn::Sub(hn::And(where, mask), middle));
    const auto row = hn::ConvertTo(d, hn::Sub(hn::And(hn::ShiftRight<15>(where), mask), middle));
    const auto h = hn::Max(field(3), hn::Set(d, 1e-4F));
    const auto a = hn::Div(hn::Set(d, 3.0F), h);
    const auto h2 = hn::Mul(h, h);
    hn::Store(
      hn::Min(hn::Mul(hn::Mul(a, a), hn::Set(d, 0.3184F)), hn::Set(d, 1.0F)), d, this->most);
    const int columnsMade = this->axis(
      column, field(1), h, a, this->x0, this->columns, [&](int k, Vector w, Vector gap2) {
        this->wx[k] = w;
        this->gx[k] = gap2;
      });
    for (int k = columnsMade; k < SmallGaussian::mostPixels; ++k)
    {
      this->wx[k] = hn::Zero(d);
      this->gx[k] = hn::Zero(d);
    }
    this->interleave(this->wx, this->columnWeights);
    this->interleave(this->gx, this->columnGaps);
    this->axis(row, field(2), h, a, this->y0, this->rows, [&](int k, Vector w, Vector gap2) {
      hn::Store(w, d, this->rowWeights[k]);
      hn::Store(hn::Sub(h2, gap2), d, this->limits[k]);
    });
  }

  bool touches(int k) const { return this->columns[k] > 0 && this->rows[k] > 0; }
  bool isSmall(int k) const
  {
    return std::max(this->columns[k], this->rows[k]) <= SmallGaussian::mostPixels;
  }
  HWY_INLINE SmallGaussian footprint(int k) const
  {
    SmallGaussian f;
    f.box = { this->x0[k], this->y0[k], this->columns[k], this->rows[k] };
    f.most = this->most[k];
    f.columns = this->columnWeights + 4 * k;
    f.gaps = this->columnGaps + 4 * k;
    f.rows = &this->rowWeights[0][k];
    f.limits = &this->limits[0][k];
    return f;
  }

private:
  using D = SmallGaussian::D;
  using Ints = hn::RebindToSigned<D>;
  using Vector = hn::Vec<D>;

  /// The pixels of an axis and what each of them has; `put` gets them one after the other. Their
  /// largest number among small splats.
  template <class Put>
  HWY_INLINE int axis(Vector pixel, Vector place, Vector h, Vector a, std::int32_t* first,
    std::int32_t* count, Put put)
  {
    const D d;
    const Ints ints;
    const auto zero = hn::Zero(d);
    const auto side = hn::Set(d, static_cast<float>(tileSide));
    const auto low = hn::Add(pixel, hn::Floor(hn::Sub(place, h)));
    const auto high = hn::Add(hn::Add(pixel, hn::Set(d, 1.0F)), hn::Floor(hn::Add(place, h)));
    const auto begin = hn::Min(hn::Max(low, zero), side);
    const auto end = hn::Min(hn::Max(high, zero), side);
    const auto pixels = hn::Sub(end, begin);
    hn::Store(hn::ConvertTo(ints, begin), ints, first);
    hn::Store(hn::ConvertTo(ints, pixels), ints, count);
    // Of those that are small.
    const auto most = hn::Set(d, static_cast<float>(SmallGaussian::mostPixels));
    const auto few = hn::IfThenElseZero(hn::Le(pixels, most), pixels);
    const int edges = static_cast<int>(hn::GetLane(hn::MaxOfLanes(d, few)));
    const auto start = hn::Sub(hn::Sub(begin, pixel), place);
    auto before = erf(d, hn::Mul(a, start));
    for (int k = 0; k < edges; ++k)
    {
      const auto edge = hn::Add(start, hn::Set(d, static_cast<float>(k)));
      const auto after = erf(d, hn::Mul(a, hn::Add(edge, hn::Set(d, 1.0F))));
      put(k, hn::Mul(hn::Set(d, 0.5F), hn::Sub(after, before)), squaredGap(d, edge));
      before = after;
    }
    return edges;
  }

  HWY_INLINE void interleave(const Vector* pixels, float* to) const
  {
    const D d;
    hn::StoreInterleaved4(pixels[0], pixels[1], pixels[2], pixels[3], d, to);
    hn::StoreInterleaved4(pixels[4], pixels[5], pixels[6], pixels[7], d, to + 4 * size);
  }

  Vector wx[SmallGaussian::mostPixels], gx[SmallGaussian::mostPixels];
  alignas(64) float columnWeights[SmallGaussian::mostPixels * size];
  alignas(64) float columnGaps[SmallGaussian::mostPixels * size];
  alignas(64) float rowWeights[SmallGaussian::mostPixels][size];
  alignas(64) float limits[SmallGaussian::mostPixels][size];
  alignas(64) float most[size];
  alignas(64) std::int32_t x0[size], y0[size], columns[size], rows[size];
};

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
      SlabLight light = { {}, { splat.light[0], splat.light[1], splat.light[2] } };
      if (splat.kind() == SplatKind::Slab)
      {
        light = this->task.slabLight(splat);
      }
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

template <TileAbsorption absorption, bool hasOpaque>
std::size_t paintWith(const TileTask& task, TileSums& sums)
{
  Painter<absorption, hasOpaque> painter(task, sums);
  return task.kernel == Kernel::Gaussian ? painter.paintGaussians()
                                         : painter.template paint<Spline>();
}

std::size_t paintTile(const TileTask& task, TileSums& sums)
{
  switch (task.absorption)
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
  return HWY_DYNAMIC_DISPATCH(paintTile)(task, sums);
}
} // namespace galaxy
#endif
