#ifndef galaxy_Splat_h
#define galaxy_Splat_h

#include "Filters/Splatting/Knobs.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace galaxy
{
/// What a splat does to the light behind it.
enum class SplatKind : std::uint32_t
{
  Emits,   ///< adds `light`
  Absorbs, ///< dims by the optical depth `light`
  Slab,    ///< both, or is very thick; `light` says which particle it is (SlabName)
  Near,    ///< a NearParticle, on all pixels; named like a slab
};

/// A particle on the image plane as a tile sees it: 32 bytes, of which a picture of many millions
/// holds as many at a time as its memory allows.
struct Splat
{
  std::uint32_t where; ///< pixel of the centre and kind, see pack()
  float x, y;          ///< the centre in that pixel, 0 to 1: float then has digits for the smallest
  float h;             ///< radius of the footprint, pixels
  std::uint32_t depth; ///< distance (perspective) or depth (parallel), see TileDepths
  float light[3]; ///< luminosity, or cross-section, over the pixel's area at the particle (kpc^2)

  /// Where counting in pixels stops: a centre farther off has the rest in x and y.
  static constexpr int farPixel = 16000;
  static constexpr int middle = 0x4000; ///< what pixels are counted from
  static constexpr int rowBit = 15, kindBit = 30;

  /// The pixel, from -farPixel to farPixel from the tile's corner, and the kind. One number, since
  /// fields of bits would read memory in order to write it.
  static std::uint32_t pack(int column, int row, SplatKind kind)
  {
    return static_cast<std::uint32_t>(column + middle) |
      static_cast<std::uint32_t>(row + middle) << rowBit |
      static_cast<std::uint32_t>(kind) << kindBit;
  }
  int column() const { return static_cast<int>(this->where & 0x7fff) - middle; }
  int row() const { return static_cast<int>(this->where >> rowBit & 0x7fff) - middle; }
  SplatKind kind() const { return static_cast<SplatKind>(this->where >> kindBit); }

  /// The same as a tile sees it whose corner is so many pixels right and up.
  Splat from(int right, int up) const
  {
    Splat splat = *this;
    const int column = std::max(this->column() - right, -farPixel);
    const int row = std::max(this->row() - up, -farPixel);
    splat.where = pack(column, row, this->kind());
    splat.x += static_cast<float>(this->column() - right - column);
    splat.y += static_cast<float>(this->row() - up - row);
    return splat;
  }
};
static_assert(sizeof(Splat) == 32, "two splats a cache line");

/// The depths of a tile's splats in 32 bits: steps from the nearest, as many as lie between it and
/// the farthest. Single precision, at 100 kpc, has steps of 7.6e-6 kpc, in which neighbours of a
/// dense galaxy lie together. What shares a step is put in order by orderTies().
struct TileDepths
{
  double nearest = 0; ///< kpc
  double farthest = 0;
  double steps = 0; ///< per kpc
  static constexpr double mostSteps = (std::uint64_t(1) << depthBits) - 1;

  TileDepths() = default;
  TileDepths(double nearest, double farthest)
    : nearest(nearest)
    , farthest(farthest)
    , steps(farthest > nearest ? mostSteps / (farthest - nearest) : 0)
  {
  }
  std::uint32_t stepOf(double depth) const
  {
    const double inside = std::clamp(depth, this->nearest, this->farthest);
    return static_cast<std::uint32_t>((inside - this->nearest) * this->steps);
  }
  double depthOf(std::uint32_t step) const
  {
    return this->nearest + (this->steps > 0 ? step / this->steps : 0);
  }
};

/// What Splat::light holds of a slab or a near particle.
struct SlabName
{
  std::uint32_t particle;
  float lightArea, depthArea; ///< what its luminosity and its cross-section are multiplied with

  static SlabName of(const Splat& splat)
  {
    SlabName name;
    std::memcpy(&name.particle, &splat.light[0], sizeof(float));
    name.lightArea = splat.light[1];
    name.depthArea = splat.light[2];
    return name;
  }
};

/// The largest of three channels.
inline float mostOf(const float* channels)
{
  return std::max({ channels[0], channels[1], channels[2] });
}

/// What a slab emits and absorbs, as Splat::light.
struct SlabLight
{
  float e[3];
  float t[3];
};
} // namespace galaxy

#endif
