#ifndef galaxy_TileGrid_h
#define galaxy_TileGrid_h

#include "Filters/Splatting/TileSums.h"

#include <algorithm>

namespace galaxy
{
/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox
{
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return this->x0 >= this->x1 || this->y0 >= this->y1; }
};

/// The tiles that cover an image, row by row from the lower left one. The middle of the image is
/// the middle of a tile: a thin disc seen edge-on, or the centre of a galaxy, would otherwise lie
/// in two or four.
struct TileGrid
{
  int width, height; ///< of the image, pixels
  int left, bottom;  ///< pixels of the first tiles that are outside the image
  int columns, rows;

  TileGrid(int width, int height)
    : width(width)
    , height(height)
    , left(outside(width))
    , bottom(outside(height))
    , columns((left + width + tileSide - 1) / tileSide)
    , rows((bottom + height + tileSide - 1) / tileSide)
  {
  }
  int size() const { return this->columns * this->rows; }

  /// The pixel of the image where a tile begins; may be negative.
  int leftOf(int tile) const { return tile % this->columns * tileSide - this->left; }
  int bottomOf(int tile) const { return tile / this->columns * tileSide - this->bottom; }
  /// The pixels of a tile that are in the image, counted from the tile's corner.
  PixelBox pixelsOf(int tile) const
  {
    const int x = this->leftOf(tile), y = this->bottomOf(tile);
    return { std::max(0, -x), std::max(0, -y), std::min(tileSide, this->width - x),
      std::min(tileSide, this->height - y) };
  }

private:
  static int outside(int size)
  {
    return (tileSide + tileSide / 2 - size / 2 % tileSide) % tileSide;
  }
};
} // namespace galaxy

#endif
