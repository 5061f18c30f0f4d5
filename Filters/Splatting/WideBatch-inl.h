// Emitters of many pixels, added to a tile many at a time.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_WideBatch_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_WideBatch_inl_h
#undef galaxy_WideBatch_inl_h
#else
#define galaxy_WideBatch_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Emitters whose light is still to be added to the tile. As their weights are products of a
/// function of the row and one of the column, the light of all of them is a product of matrices,
///   C[channel, row; column] = sum over emitters (light row)[channel, row; emitter]
///   column[emitter],
/// added up in registers: memory then sees one sum where it would see as many as there are
/// emitters.
class WideBatch
{
public:
  static constexpr int size = 16; ///< their weights stay in a core's first cache
  /// In the tile; a splat of fewer is faster added by itself.
  static constexpr int fewestPixels = 64;

  bool empty() const { return this->count == 0; }
  bool isFull() const { return this->count == size; }
  void clear() { this->count = 0; }

  /// Needs room.
  HWY_INLINE void add(const Splat& splat)
  {
    Emitter& emitter = this->emitters[this->count++];
    WideGaussian::weights<false>(splat, emitter.column, this->row);
    for (int y = 0; y < tileSide; y += lanes())
    {
      const V w = hn::Load(tag, this->row + y);
      for (int c = 0; c < 3; ++c)
      {
        hn::Store(hn::Mul(w, hn::Set(tag, splat.light[c])), tag, emitter.rows[c] + y);
      }
    }
  }

  /// Adds their light to all pixels of a tile.
  void addTo(TilePlanes<float>& light) const
  {
    for (int y = 0; y < tileSide; ++y)
    {
      for (int x = 0; x < tileSide; x += mostVectors * lanes())
      {
        this->addRow<mostVectors>(y, x, &light.values[0][y][x], &light.values[0][y][x]);
      }
    }
  }

  /// Their light and `light` in the pixels of a box, to `sum`.
  HWY_NOINLINE void addTo(
    const Box& box, const TilePlanes<float>& light, TilePlanes<float>& sum) const
  {
    for (int y = box.y0; y < box.y0 + box.rows; ++y)
    {
      for (int x = box.x0; x < box.x0 + box.columns; x += lanes())
      {
        this->addRow<1>(y, x, &light.values[0][y][x], &sum.values[0][y][x]);
      }
    }
  }

private:
  /// With three channels and what they share, 16 registers.
  static constexpr int mostVectors = std::min(4, tileSide / static_cast<int>(hn::MaxLanes(Tag())));

  struct Emitter
  {
    HWY_ALIGN float column[tileStride];
    HWY_ALIGN float rows[3][tileSide]; ///< times the light
  };

  template <int vectors>
  HWY_INLINE void addRow(int y, int x, const float* light, float* sum) const
  {
    constexpr int plane = tileSide * tileStride;
    V sums[3][vectors];
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < vectors; ++k)
      {
        sums[c][k] = hn::Zero(tag);
      }
    }
    const Emitter* const end = this->emitters + this->count;
    for (const Emitter* emitter = this->emitters; emitter != end; ++emitter)
    {
      V columns[vectors];
      for (int k = 0; k < vectors; ++k)
      {
        columns[k] = hn::LoadU(tag, emitter->column + x + k * lanes());
      }
      for (int c = 0; c < 3; ++c)
      {
        const V row = hn::Set(tag, emitter->rows[c][y]);
        for (int k = 0; k < vectors; ++k)
        {
          sums[c][k] = hn::MulAdd(row, columns[k], sums[c][k]);
        }
      }
    }
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < vectors; ++k)
      {
        const int at = c * plane + k * lanes();
        hn::StoreU(hn::Add(hn::LoadU(tag, light + at), sums[c][k]), tag, sum + at);
      }
    }
  }

  int count = 0;
  HWY_ALIGN float row[tileStride];
  Emitter emitters[size];
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
