// The light of NearParticles in the pixels of a tile.
// Compiled once for every instruction set, as Highway has it.
#if defined(galaxy_NearFootprint_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef galaxy_NearFootprint_inl_h
#undef galaxy_NearFootprint_inl_h
#else
#define galaxy_NearFootprint_inl_h
#endif

#include "Filters/Splatting/Footprints-inl.h"
#include "Filters/Splatting/NearParticle.h"
#include "Filters/Splatting/TileNodes.h"

HWY_BEFORE_NAMESPACE();
namespace galaxy
{
namespace HWY_NAMESPACE
{
/// Adds to the pixels what follows from the values at a tile's nodes.
HWY_NOINLINE void addNodes(const float (&values)[TileNodes::size], float (*sums)[tileStride])
{
  HWY_ALIGN float rows[TileNodes::side][tileSide];
  for (int i = 0; i < TileNodes::side; ++i)
  {
    for (int x = 0; x < tileSide; x += lanes())
    {
      V sum = hn::Zero(tag);
      for (int j = 0; j < TileNodes::side; ++j)
      {
        sum = hn::MulAdd(hn::Set(tag, values[i * TileNodes::side + j]),
          hn::Load(tag, tileNodes.share[j] + x), sum);
      }
      hn::Store(sum, tag, rows[i] + x);
    }
  }
  for (int y = 0; y < tileSide; ++y)
  {
    for (int x = 0; x < tileSide; x += lanes())
    {
      V sum = hn::Zero(tag);
      for (int i = 0; i < TileNodes::side; ++i)
      {
        sum = hn::MulAdd(hn::Set(tag, tileNodes.share[i][y]), hn::Load(tag, rows[i] + x), sum);
      }
      // Where there is almost nothing a polynomial may be less.
      sum = hn::Max(sum, hn::Zero(tag));
      hn::StoreU(hn::Add(hn::LoadU(tag, sums[y] + x), sum), tag, sums[y] + x);
    }
  }
}

/// Light of near particles at the nodes of a tile, not yet in its pixels.
class NearLight
{
public:
  static constexpr int most = 32; ///< particles, so that float does not drift

  bool empty() const { return this->count == 0; }
  bool isFull() const { return this->count == most; }

  void add(const float* light, const float* weights)
  {
    for (int c = 0; c < 3; ++c)
    {
      const V e = hn::Set(tag, light[c]);
      for (int k = 0; k < TileNodes::size; k += lanes())
      {
        float* sum = this->values[c] + k;
        const V before = this->empty() ? hn::Zero(tag) : hn::Load(tag, sum);
        hn::Store(hn::MulAdd(e, hn::Load(tag, weights + k), before), tag, sum);
      }
    }
    ++this->count;
  }

  void moveTo(TilePlanes<float>& light)
  {
    for (int c = 0; c < 3; ++c)
    {
      addNodes(this->values[c], light.values[c]);
    }
    this->count = 0;
  }

private:
  int count = 0;
  HWY_ALIGN float values[3][TileNodes::size];
};

/// A NearParticle as the pixels of one tile see it, each along its own ray: where pixels are so
/// fine that the tile's nodes tell all, from there.
class NearFootprint
{
public:
  using D = Tag;
  static constexpr bool isGeneral = true;
  static constexpr Box box{ 0, 0, tileSide, tileSide };

  /// For a tile with such a corner.
  void setTile(const Camera& camera, int left, int bottom)
  {
    this->cone = TileCone(camera, left, bottom);
    this->hasNodes = TileNodes::suffice(camera);
    this->size = this->hasNodes ? TileNodes::size : tileSide * tileSide;
    const int side = this->hasNodes ? TileNodes::side : tileSide;
    for (int k = 0; k < this->size; ++k)
    {
      const int column = k % side, row = k / side;
      const double x = left + (this->hasNodes ? tileNodes.place[column] : column + 0.5);
      const double y = bottom + (this->hasNodes ? tileNodes.place[row] : row + 0.5);
      const Vec3 ray = TileCone::ray(camera, x, y);
      this->right[k] = static_cast<float>(ray.x);
      this->up[k] = static_cast<float>(ray.y);
      this->forward[k] = static_cast<float>(ray.z);
    }
  }
  bool hasTile() const { return this->size > 0; }
  bool isAtNodes() const { return this->hasNodes; }

  /// False if the particle misses the tile; sigma in pixels as SplatBlock has them. Of an absorber
  /// exact to 1e-7, as WideGaussian is.
  template <bool isExact>
  bool prepare(const NearParticle& particle, double sigmaInPixels)
  {
    if (this->cone.misses(particle))
    {
      return false;
    }
    const auto number = [](double x) { return hn::Set(tag, static_cast<float>(x)); };
    const V x = number(particle.x), y = number(particle.y), z = number(particle.z);
    const V peak = number(nearPeak / (sigmaInPixels * sigmaInPixels));
    const V half = number(0.5);
    const V share = number(particle.share), perSigma = number(particle.perSigma);
    const V u = number(particle.u), v = number(particle.v);
    for (int k = 0; k < this->size; k += lanes())
    {
      const V right = hn::Load(tag, this->right + k), up = hn::Load(tag, this->up + k),
              forward = hn::Load(tag, this->forward + k);
      const V s = hn::MulAdd(x, right, hn::MulAdd(y, up, hn::Mul(z, forward)));
      // From the ray to the centre, since |centre|^2 - s^2 would lose digits.
      const V bx = hn::NegMulAdd(s, right, x), by = hn::NegMulAdd(s, up, y),
              bz = hn::NegMulAdd(s, forward, z);
      const V b2 = hn::MulAdd(bx, bx, hn::MulAdd(by, by, hn::Mul(bz, bz)));
      V profile = profileAt<isExact>(b2);
      if (particle.share > 0)
      {
        const V du = hn::Mul(hn::Sub(hn::Div(right, forward), u), perSigma);
        const V dv = hn::Mul(hn::Sub(hn::Div(up, forward), v), perSigma);
        const V circle = profileAt<isExact>(hn::MulAdd(du, du, hn::Mul(dv, dv)));
        profile = hn::MulAdd(share, hn::Sub(circle, profile), profile);
      }
      const V before = hn::Max(hn::Add(cumulative(tag, s), half), hn::Zero(tag));
      hn::Store(hn::Mul(hn::Mul(peak, profile), before), tag, this->values + k);
    }
    return true;
  }
  /// With isAtNodes(), TileNodes::size of them.
  const float* atNodes() const { return this->values; }

  /// Before weights() is asked.
  void spread()
  {
    for (int y = 0; y < tileSide; ++y)
    {
      for (int x = 0; x < tileSide; x += lanes())
      {
        hn::StoreU(this->hasNodes ? hn::Zero(tag) : hn::Load(tag, this->values + y * tileSide + x),
          tag, this->table[y] + x);
      }
    }
    if (this->hasNodes)
    {
      HWY_ALIGN float nodes[TileNodes::size];
      std::copy_n(this->values, TileNodes::size, nodes);
      addNodes(nodes, this->table);
    }
  }

  float most; ///< of a pixel
  float mostOfAPixel() const { return this->most; }
  HWY_INLINE V rowAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V columnsAt(int) const { return hn::Zero(tag); }
  HWY_INLINE V weights(V, int y, int x) const { return hn::LoadU(tag, this->table[y] + x); }

private:
  template <bool isExact>
  static HWY_INLINE V profileAt(V b2)
  {
    const V inside = hn::Min(b2, hn::Set(tag, 10.0F));
    const V falls = isExact ? hn::Exp(tag, hn::Neg(inside)) : decay(inside);
    const V end = hn::Set(tag, -static_cast<float>(std::exp(-9.0)));
    return hn::Max(hn::Add(falls, end), hn::Zero(tag));
  }

  TileCone cone;
  bool hasNodes = false;
  int size = 0; ///< of nodes or pixels, row by row
  // Their rays, of length 1.
  HWY_ALIGN float right[tileSide * tileSide], up[tileSide * tileSide], forward[tileSide * tileSide];
  HWY_ALIGN float values[tileSide * tileSide];
  HWY_ALIGN float table[tileSide][tileStride];
};
} // namespace HWY_NAMESPACE
} // namespace galaxy
HWY_AFTER_NAMESPACE();

#endif
