#ifndef galaxy_CellDistances_h
#define galaxy_CellDistances_h

#include <cstdint>
#include <vector>

namespace galaxy
{
/// From the particles counted in the cells of a cube to the mean distance between particles there.
///
/// A cell's d is s/k^(1/3) where s is the side of the cube about it that holds k particles. Over
/// blocks of 1, 2, 4, ... cells a side the count n(s) is known; between a block of more than k and
/// its child of fewer, n is taken as a power of s. That power is the dimension in which the
/// particles lie, so that a sheet thinner than a cell gets the d of its k nearest neighbours. Where
/// one cell holds more than k, the power is the one between it and its parent, from 2 to 3.
class CellDistances
{
public:
  explicit CellDistances(int neighbours);

  /// `counts` of 8^bits cells of side `cell`, x running fastest. Afterwards distance(i) holds d in
  /// the unit of `cell`, or 0 for an empty cube.
  void compute(const std::uint32_t* counts, int bits, double cell);
  float distance(std::size_t i) const { return this->blocks[0][i].distance; }

private:
  struct Block
  {
    float count;
    float distance;
  };

  void sumUp(const std::uint32_t* counts, int bits);
  void passDown(int level, int bits, double side);

  double neighbours;
  double perDistance;                     ///< k^(1/3)
  std::vector<std::vector<Block>> blocks; ///< by level: 2^level cells a side
};
} // namespace galaxy

#endif
