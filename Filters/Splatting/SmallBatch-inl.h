// The weights of several splats of few pixels at once.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_SmallBatch_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_SmallBatch_inl_h
#undef galaxy_SmallBatch_inl_h
#else
#define galaxy_SmallBatch_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
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
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
