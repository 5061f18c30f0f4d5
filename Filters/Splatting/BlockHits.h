#ifndef galaxy_BlockHits_h
#define galaxy_BlockHits_h

#include "Filters/Splatting/TileSums.h"

#include <cstdint>
#include <cstring>

namespace galaxy
{
/// Watches over how many splats a pixel of a tile has had, by 16 blocks of its pixels.
class BlockHits
{
public:
  static constexpr int blockSide = tileSide / 4;
  /// What a pixel has had when isFull() becomes true, or fewer: its block, and the three before it
  /// whose splats may reach it, have had a quarter each.
  static constexpr int most = 512;

  /// A splat on the pixels from (x0, y0) to (x1, y1).
  void add(int x0, int y0, int x1, int y1)
  {
    if (x1 - x0 < blockSide && y1 - y0 < blockSide)
    {
      ++this->counts[y0 / blockSide][x0 / blockSide];
      return;
    }
    for (int y = y0 / blockSide; y <= y1 / blockSide; ++y)
    {
      for (int x = x0 / blockSide; x <= x1 / blockSide; ++x)
      {
        ++this->counts[y][x];
      }
    }
  }
  /// To be asked after each 64 splats at least.
  bool isFull() const
  {
    std::uint64_t words[2];
    std::memcpy(words, this->counts, sizeof(words));
    return ((words[0] | words[1]) & 0x8080808080808080) != 0;
  }
  void clear() { std::memset(this->counts, 0, sizeof(this->counts)); }

private:
  static constexpr int blocks = tileSide / blockSide;
  std::uint8_t counts[blocks][blocks] = {};
  static_assert(sizeof(counts) == 16, "two words");
};
} // namespace galaxy

#endif
