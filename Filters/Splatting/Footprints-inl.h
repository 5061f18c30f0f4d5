// The weights of one splat on the pixels of a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_Footprints_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_Footprints_inl_h
#undef galaxy_Footprints_inl_h
#else
#define galaxy_Footprints_inl_h
#endif

#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/LaneMath-inl.h"
#include "Filters/Splatting/Splat.h"
#include "Filters/Splatting/SplineWeights.h"
#include "Filters/Splatting/TileSums.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
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
    const float reach = kernelCut * h;
    // By scalars: a vector gathered from single numbers would wait for all stores before it.
    const int column = splat.column(), row = splat.row();
    const int x1 = inTile(column + 1, splat.x + reach);
    const int y1 = inTile(row + 1, splat.y + reach);
    this->x0 = inTile(column, splat.x - reach);
    this->y0 = inTile(row, splat.y - reach);
    this->columns = x1 - this->x0;
    this->rows = y1 - this->y0;
    return this->columns > 0 && this->rows > 0;
  }
};

/// The Gaussian kernel's means over all pixels of a tile's row and column, of splats no narrower
/// than `narrowest`: narrower ones take differences of the cumulative share, which here would lose
/// digits. Means of exp(-a^2 (x+u)^2) over the pixel |u| < 1/2 by powers of u and Hermite's
/// polynomials: with z = (a x)^2, b = a^2 they are e^-z times
///   1 + b (z - 1/2)/6 + b^2 (z^2 - 3z + 3/4)/120 + b^3 (z^3 - 15/2 z^2 + 45/4 z - 15/8)/5040.
class WideGaussian
{
public:
  static constexpr float narrowest = 5; ///< pixels of h

  /// `column` and `row` have room for tileStride numbers and end with zeros. Of an absorber they
  /// are exact to 1e-7 of themselves, of an emitter to 4e-7 of the centre's.
  template <bool isExact>
  static HWY_INLINE void weights(const Splat& splat, float* column, float* row)
  {
    const float a = 3 / splat.h, b = a * a;
    const float left = static_cast<float>(splat.column()) + splat.x;
    const float bottom = static_cast<float>(splat.row()) + splat.y;
    // By powers of z = (a x)^2.
    const float scale = a * norm;
    const float c[4] = { scale * (1 - b / 12 + b * b / 160 - b * b * b / 2688),
      scale * (b / 6 - b * b / 40 + b * b * b / 448), scale * (b * b / 120 - b * b * b / 672),
      scale * (b * b * b / 5040) };
    // The pixels that the kernel ends in.
    HWY_ALIGN float part[4];
    float* at[4];
    const auto end = [&](int k, float place, float* share) {
      const float pixel = __builtin_floorf(place);
      const bool isInTile = pixel >= 0 && pixel < static_cast<float>(tileSide);
      at[k] = share + (isInTile ? static_cast<int>(pixel) : tileSide);
      const float inside = place - pixel;
      part[k] = a * (k % 2 == 0 ? 1 - inside : inside);
    };
    end(0, left - splat.h, column);
    end(1, left + splat.h, column);
    end(2, bottom - splat.h, row);
    end(3, bottom + splat.h, row);
    axis<isExact>(a, left, c, column);
    axis<isExact>(a, bottom, c, row);
    using Ends = hn::CappedTag<float, 4>;
    const Ends ends;
    for (int k = 0; k < 4; k += lanes(ends))
    {
      hn::Store(shareAtEnd(ends, hn::Load(ends, part + k)), ends, part + k);
    }
    for (int k = 0; k < 4 && kernelCut == 1; ++k)
    {
      *at[k] = part[k];
    }
    column[tileSide] = row[tileSide] = 0;
  }

private:
  static constexpr float atEnd = 1.2340980e-4F; ///< e^-9
  static constexpr float norm = 0.56443785F;    ///< 1 / integral of the kernel

  template <bool isExact>
  static HWY_INLINE void axis(float a, float centre, const float* c, float* share)
  {
    const auto number = [](float x) { return hn::Set(tag, x); };
    const V c0 = number(c[0]), c1 = number(c[1]), c2 = number(c[2]), c3 = number(c[3]);
    const V edge = number(a * norm * atEnd);
    const V first = hn::Add(hn::Iota(tag, 0), number(0.5F - centre));
    for (int i = 0; i < tileSide; i += lanes())
    {
      const V s = hn::Mul(number(a), hn::Add(first, number(static_cast<float>(i))));
      const V z = hn::Min(hn::Mul(s, s), number(10));
      const V sum = hn::MulAdd(hn::MulAdd(hn::MulAdd(c3, z, c2), z, c1), z, c0);
      V mean = hn::MulSub(isExact ? hn::Exp(tag, hn::Neg(z)) : decay(z), sum, edge);
      if constexpr (kernelCut < 1)
      {
        mean = hn::IfThenElseZero(hn::Lt(z, number(9 * kernelCut * kernelCut)), mean);
      }
      hn::Store(hn::Max(mean, hn::Zero(tag)), tag, share + i);
    }
    for (int i = tileSide; i < tileStride; i += lanes())
    {
      hn::Store(hn::Zero(tag), tag, share + i);
    }
  }

  /// The share of the last e before the end, in s: the integral of e^-9 (exp(6 s - s^2) - 1), whose
  /// terms are Hermite's numbers at 3.
  template <class D>
  static HWY_INLINE hn::Vec<D> shareAtEnd(D d, hn::Vec<D> e)
  {
    auto sum = hn::Set(d, 0.0999F);
    for (const float c : { 0.9679F, 2.8048F, 5.3F, 7.3F, 7.5F, 5.6666667F, 3.0F })
    {
      sum = hn::MulAdd(sum, e, hn::Set(d, c));
    }
    return hn::Mul(hn::Mul(hn::Set(d, norm * atEnd), sum), hn::Mul(e, e));
  }
};

/// The Gaussian kernel's means over the pixels, see gaussianCumulative(): a product of a function
/// of the pixel's column and one of its row.
class Gaussian
{
public:
  using D = Tag;
  Box box;

  /// False if the splat misses the tile.
  HWY_INLINE bool prepare(const Splat& splat)
  {
    const float h = std::max(splat.h, 1e-4F);
    if (!this->box.clip(splat, h))
    {
      return false;
    }
    const float a = 3 / h;
    this->most = gaussianMostOfAPixel(a);
    if (h >= WideGaussian::narrowest)
    {
      splat.kind() == SplatKind::Emits
        ? WideGaussian::weights<false>(splat, this->column, this->row)
        : WideGaussian::weights<true>(splat, this->column, this->row);
      return true;
    }
    this->axis(a, static_cast<float>(this->box.x0 - splat.column()) - splat.x, this->box.columns,
      this->column + this->box.x0);
    this->axis(a, static_cast<float>(this->box.y0 - splat.row()) - splat.y, this->box.rows,
      this->row + this->box.y0);
    return true;
  }
  float mostOfAPixel() const { return this->most; }

  static constexpr bool isGeneral = false; ///< else the weights are no product of row and column
  HWY_INLINE V rowAt(int y) const { return hn::Set(tag, this->row[this->box.y0 + y]); }
  HWY_INLINE V columnsAt(int x) const { return hn::LoadU(tag, this->column + this->box.x0 + x); }
  /// The weights of the lanes that begin at column x of row y of the box.
  HWY_INLINE V weights(V at, int, int x) const { return hn::Mul(at, this->columnsAt(x)); }

private:
  /// The shares of the pixels of an axis, the first of which begins at `start` from the centre.
  HWY_INLINE void axis(float a, float start, int pixels, float* share) const
  {
    const int N = lanes();
    const V scale = hn::Set(tag, a);
    const V first = hn::Add(hn::Iota(tag, 0), hn::Set(tag, start));
    V before = cumulative(tag, hn::Mul(scale, first));
    for (int i = 0; i < pixels; i += N)
    {
      const V d = hn::Add(first, hn::Set(tag, static_cast<float>(i)));
      // The last edge of so many pixels is among the lanes, or begins the next ones; nothing of
      // the kernel is in lanes beyond them that lie in the tile.
      const V next = pixels - i < N
        ? hn::Set(tag, 0.5F)
        : cumulative(
            tag, hn::MulAdd(scale, hn::Set(tag, static_cast<float>(N)), hn::Mul(scale, d)));
      // Rounding may make a share of almost nothing less than that.
      const V all = hn::Max(hn::Sub(following(before, next), before), hn::Zero(tag));
      hn::StoreU(all, tag, share + i);
      before = next;
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

  float most;
  HWY_ALIGN float column[tileStride];
  HWY_ALIGN float row[tileStride];
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
    this->most = splineMostOfAPixel(h);
    return true;
  }
  float mostOfAPixel() const { return this->most; }

  static constexpr bool isGeneral = true;
  HWY_INLINE V rowAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V columnsAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V weights(V, int y, int x) const { return hn::LoadU(tag, this->table.weights[y] + x); }

private:
  SplineWeights table;
  float most;
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
