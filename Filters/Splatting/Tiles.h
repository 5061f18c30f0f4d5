#ifndef galaxy_Tiles_h
#define galaxy_Tiles_h

#include "Filters/Splatting/Projection.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace galaxy
{
/// Pixels of a tile: its float sums then stay in the second cache of a core, and a wide footprint
/// is prepared for few tiles.
constexpr int tileWidth = 64;
constexpr int tileHeight = 64;

/// The tiles that cover an image, row by row from the lower left one.
struct TileGrid
{
  int columns = 0;
  int rows = 0;
  TileGrid(int width, int height)
    : columns((width + tileWidth - 1) / tileWidth)
    , rows((height + tileHeight - 1) / tileHeight)
  {
  }
  int size() const { return this->columns * this->rows; }
};

/// Which particles touch which tile: those of tile k, in the order of their index, are
/// `particles[first[k]]` to `particles[first[k + 1] - 1]`.
struct TileLists
{
  std::vector<std::size_t> first;
  Buffer<std::uint32_t> particles;
  ProjectionCounts counts;
};

/// Projects every particle and lists it in the tiles its footprint touches; the lists are the same
/// for any number of threads. Throws Error if there are more particles than 32 bits can number.
TileLists listByTile(const Projection& projection, const TileGrid& grid);
} // namespace galaxy

#endif
