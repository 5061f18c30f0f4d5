#ifndef galaxy_SplatBlock_h
#define galaxy_SplatBlock_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Projection.h"

#include <cstddef>
#include <cstdint>

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
  static constexpr std::uint32_t nowhere = UINT32_MAX; ///< off the image or behind the eye
  static constexpr std::uint32_t odd = UINT32_MAX - 1; ///< NaN, infinite, negative: not for vectors
  static constexpr std::uint32_t several = 1U << 31;

  static bool isOne(std::uint32_t home) { return home < several; }
  static int row0(std::uint32_t home) { return static_cast<int>(home & 0x7fff); }
  static int row1(std::uint32_t home) { return static_cast<int>(home >> 15 & 0x7fff); }
};

/// The tiles that the particles touch.
struct BlockTiles
{
  static constexpr int most = BlockPlaces::most;

  std::uint32_t home[most];                                          ///< a TileHome
  std::int32_t column0[most], row0[most], column1[most], row1[most]; ///< the last ones included
};

/// The particles on the image plane.
struct SplatBlock
{
  static constexpr int most = BlockPlaces::most;

  std::int32_t x0[most], y0[most], x1[most], y1[most]; ///< pixels touched: x0 <= x < x1
  std::int32_t column[most], row[most];                ///< the pixel that holds the centre
  float x[most], y[most];                              ///< the centre in it
  float h[most];                                       ///< radius, pixels
  float depth[most];                                   ///< kpc
  float perArea[most]; ///< 1 / (pixel area there, kpc^2), and the kernel's gain
};

/// Both project `count` particles by vectors, in double precision, since a camera may be
/// megaparsecs from the origin. Where BlockTiles::home is nowhere or odd the rest means nothing.
void locateBlock(
  const BlockPlaces& places, int count, const Camera& camera, int gridColumns, BlockTiles& tiles);
void projectBlock(
  const BlockPlaces& places, int count, const Camera& camera, Kernel kernel, SplatBlock& block);
} // namespace galaxy

#endif
