#ifndef galaxy_SplatBlock_h
#define galaxy_SplatBlock_h

#include "Filters/Splatting/Projection.h"

#include <cstdint>
#include <cstring>

namespace galaxy
{
/// Up to `most` particles as the camera has yet to see them.
struct BlockPlaces
{
  static constexpr int most = particlesAtOnce;

  float x[most], y[most], z[most]; ///< kpc
  float radius[most];              ///< smoothing length as drawn, kpc

  void set(int k, const float* position, float r)
  {
    this->x[k] = position[0];
    this->y[k] = position[1];
    this->z[k] = position[2];
    this->radius[k] = r;
  }
};

/// Where a particle is drawn, in four bytes: in one tile (its row times the grid's columns plus its
/// column), in several, of which the first and the last row are kept, or as below.
struct TileHome
{
  static constexpr std::uint32_t nowhere = UINT32_MAX;     ///< off the image or behind the eye
  static constexpr std::uint32_t invalid = UINT32_MAX - 1; ///< NaN, infinite, negative
  static constexpr std::uint32_t several = 1U << 31;

  static bool isOne(std::uint32_t home) { return home < several; }
};

/// Tiles, the last ones included.
struct TileRange
{
  int column0, row0, column1, row1;
};

/// The tiles that the particles touch.
struct BlockTiles
{
  static constexpr int most = BlockPlaces::most;

  std::uint32_t home[most];                                          ///< a TileHome
  std::int32_t column0[most], row0[most], column1[most], row1[most]; ///< the last ones included
  double depth[most];                                                ///< kpc

  TileRange range(int k) const
  {
    return { this->column0[k], this->row0[k], this->column1[k], this->row1[k] };
  }
};

/// What the particles emit and absorb, and their numbers among all.
struct BlockLights
{
  static constexpr int most = BlockPlaces::most;

  float L[3][most]; ///< luminosity
  float K[3][most]; ///< cross-section, kpc^2
  std::uint32_t particle[most];
  /// Factors on the pixels' areas, see LightScale.
  double areaOfLight = 1, areaOfDepth = 1;
};

/// What becomes of a particle.
enum class Fate : std::int32_t
{
  Emits,
  AbsorbsGrey,
  AbsorbsColors, ///< differently in the three channels
  SlabGrey,      ///< emits and absorbs
  SlabColors,
  Culled, ///< has no light
  Invalid,
};
constexpr int fates = 7;

/// The particles on the image plane.
struct SplatBlock
{
  static constexpr int most = BlockPlaces::most;

  /// Without its depth, which is counted from the tile's nearest.
  Splat splat(int k) const
  {
    Splat splat;
    std::memcpy(&splat, this->head[k], sizeof(this->head[k]));
    std::memcpy(&splat.depth, this->tail[k], sizeof(this->tail[k]));
    return splat;
  }

  BlockTiles tiles;
  float brightest; ///< the largest luminosity over a pixel's area
  Fate fate[most];
  alignas(64) float head[most][4]; ///< Splat's first half, as the first tile sees it
  alignas(64) float tail[most][4]; ///< its second half

  // What is known before the light is.
  std::uint32_t where[most];
  float x[most], y[most], h[most];
  /// 1 / (pixel area there, kpc^2), whose h the kernel keeps, times what lights say.
  float lightArea[most], depthArea[most];
  std::int32_t near[most]; ///< all bits for a NearParticle
};

/// Both project `count` particles by vectors, in double precision, since a camera may be
/// megaparsecs from the origin. Where BlockTiles::home is nowhere or invalid the rest means
/// nothing.
void locateBlock(
  const BlockPlaces& places, int count, const Lens& lens, const TileGrid& grid, BlockTiles& tiles);
void projectBlock(const BlockPlaces& places, const BlockLights& lights, int count, const Lens& lens,
  const TileGrid& grid, SplatBlock& block);

/// The tiles from `first` to one before `end` of a grid.
struct TileSpan
{
  int first, end, gridColumns;
  bool has(int tile) const { return tile >= this->first && tile < this->end; }
  int firstRow() const { return this->first / this->gridColumns; }
  int lastRow() const { return (this->end - 1) / this->gridColumns; }
};

/// Which of `count` particles at home in such places may have a splat in the tiles: their numbers
/// in `which`, which has room for BlockPlaces::most and a vector, and how many.
int listInTiles(const std::uint32_t* home, int count, const TileSpan& span, std::uint32_t* which);
} // namespace galaxy

#endif
