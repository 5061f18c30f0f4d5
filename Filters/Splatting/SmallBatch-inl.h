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
  static constexpr int mostPixels = 16; ///< along each axis

  /// Pixels of h: of larger ones the differences of the cumulative share would lose digits.
  static constexpr float largest = 8;

  Box box;
  float most;
  const float* columns; ///< weights of columns: four of every splat, then four more
  const float* rows;    ///< weights of rows, a batch apart

  float mostOfAPixel() const { return this->most; }

  static constexpr bool isGeneral = false;
  HWY_INLINE Vector columnsAt(int x) const { return fours(this->columns, x); }
  HWY_INLINE Vector rowAt(int y) const { return hn::Set(D(), this->rows[y * batch]); }
  HWY_INLINE Vector weights(Vector at, int, int x) const { return hn::Mul(at, this->columnsAt(x)); }

private:
  static HWY_INLINE Vector fours(const float* from, int x)
  {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (batch == 8)
    {
      const hn::Half<D> half;
      const float* at = from + x * batch;
      return hn::Combine(D(), hn::LoadU(half, at + 4 * batch), hn::LoadU(half, at));
    }
#endif
    return hn::LoadU(D(), from + x / 4 * 4 * batch + x % 4);
  }
};

/// The footprints of as many splats as a vector has lanes, prepared together: the vectors run over
/// the splats, so that no splat waits for its own weights.
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
    const auto pixel = [&](hn::Vec<Ints> packed) {
      return hn::ConvertTo(d, hn::Sub(hn::And(packed, mask), hn::Set(ints, Splat::middle)));
    };
    const auto h = hn::Max(field(3), hn::Set(d, 1e-4F));
    const auto a = hn::Div(hn::Set(d, 3.0F), h);
    hn::Store(
      hn::Min(hn::Mul(hn::Mul(a, a), hn::Set(d, gaussianPeak)), hn::Set(d, 1.0F)), d, this->most);
    const int columnsMade = this->axis(pixel(where), field(1), h, a, this->x0, this->columns,
      [&](int k, Vector w) { this->wx[k] = w; });
    // Whole vectors of columns are read.
    const int columnsRead = (columnsMade + lanes() - 1) / lanes() * lanes();
    for (int k = columnsMade; k < columnsRead; ++k)
    {
      this->wx[k] = hn::Zero(d);
    }
    for (int k = 0; k < columnsRead; k += 4)
    {
      hn::StoreInterleaved4(this->wx[k], this->wx[k + 1], this->wx[k + 2], this->wx[k + 3], d,
        this->columnWeights + k * size);
    }
    this->axis(pixel(hn::ShiftRight<Splat::rowBit>(where)), field(2), h, a, this->y0, this->rows,
      [&](int k, Vector w) { hn::Store(w, d, this->rowWeights[k]); });
  }

  bool touches(int k) const { return this->columns[k] > 0 && this->rows[k] > 0; }
  int pixels(int k) const { return this->columns[k] * this->rows[k]; }
  bool isSmall(int k) const
  {
    return std::max(this->columns[k], this->rows[k]) <= SmallGaussian::mostPixels &&
      this->splats[k].h <= SmallGaussian::largest;
  }
  HWY_INLINE SmallGaussian footprint(int k) const
  {
    SmallGaussian f;
    f.box = { this->x0[k], this->y0[k], this->columns[k], this->rows[k] };
    f.most = this->most[k];
    f.columns = this->columnWeights + 4 * k;
    f.rows = &this->rowWeights[0][k];
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
    const auto reach = hn::Mul(h, hn::Set(d, kernelCut));
    const auto low = hn::Add(pixel, hn::Floor(hn::Sub(place, reach)));
    const auto high = hn::Add(hn::Add(pixel, hn::Set(d, 1.0F)), hn::Floor(hn::Add(place, reach)));
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
    auto before = cumulative(d, hn::Mul(a, start));
    for (int k = 0; k < edges; ++k)
    {
      const auto edge = hn::Add(start, hn::Set(d, static_cast<float>(k)));
      const auto after = cumulative(d, hn::Mul(a, hn::Add(edge, hn::Set(d, 1.0F))));
      put(k, hn::Max(hn::Sub(after, before), zero));
      before = after;
    }
    return edges;
  }

  Vector wx[SmallGaussian::mostPixels];
  alignas(64) float columnWeights[SmallGaussian::mostPixels * size];
  alignas(64) float rowWeights[SmallGaussian::mostPixels][size];
  alignas(64) float most[size];
  alignas(64) std::int32_t x0[size], y0[size], columns[size], rows[size];
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
