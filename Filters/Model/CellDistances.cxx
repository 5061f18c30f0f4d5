#include "Filters/Model/CellDistances.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Where cell i of a cube of 2^bits cells a side lies in the one of half as many.
std::size_t parentOf(std::size_t i, int bits)
{
  const std::size_t last = (std::size_t(1) << bits) - 1;
  const std::size_t x = i & last;
  const std::size_t y = i >> bits & last;
  const std::size_t z = i >> 2 * bits;
  return ((z >> 1) << (bits - 1) | y >> 1) << (bits - 1) | x >> 1;
}
} // namespace

CellDistances::CellDistances(int neighbours)
  : neighbours(neighbours)
  , perDistance(std::cbrt(neighbours))
{
}

void CellDistances::compute(const std::uint32_t* counts, int bits, double cell)
{
  this->sumUp(counts, bits);
  const Block& all = this->blocks[bits][0];
  const double side = std::ldexp(cell, bits);
  this->blocks[bits][0].distance = all.count > 0 ? side / std::cbrt(all.count) : 0;
  for (int level = bits - 1; level >= 0; --level)
  {
    this->passDown(level, bits, std::ldexp(cell, level));
  }
}

void CellDistances::sumUp(const std::uint32_t* counts, int bits)
{
  if (this->blocks.size() <= std::size_t(bits))
  {
    this->blocks.resize(bits + 1);
  }
  const std::size_t size = std::size_t(1) << 3 * bits;
  this->blocks[0].resize(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    this->blocks[0][i].count = counts[i];
  }
  for (int level = 1; level <= bits; ++level)
  {
    const std::vector<Block>& children = this->blocks[level - 1];
    std::vector<Block>& parents = this->blocks[level];
    parents.assign(children.size() / 8, Block{ 0, 0 });
    for (std::size_t i = 0; i < children.size(); ++i)
    {
      parents[parentOf(i, bits - level + 1)].count += children[i].count;
    }
  }
}

void CellDistances::passDown(int level, int bits, double side)
{
  const std::vector<Block>& parents = this->blocks[level + 1];
  std::vector<Block>& blocks = this->blocks[level];
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const double k = this->neighbours;
    const Block& parent = parents[parentOf(i, bits - level)];
    const double n = blocks[i].count;
    if (parent.count < k || n == 0)
    {
      blocks[i].distance = parent.distance;
      continue;
    }
    const double power = std::log2(parent.count / n);
    const double s = n < k ? 2 * side * std::pow(k / parent.count, 1 / power)
                           : side * std::pow(k / n, 1 / std::clamp(power, 2.0, 3.0));
    blocks[i].distance = s / this->perDistance;
  }
}
} // namespace galaxy
