#ifndef galaxy_ChildLattice_h
#define galaxy_ChildLattice_h

#include "Filters/Model/Random.h"

#include <array>
#include <cstdint>

namespace galaxy
{
/// Where the children of a seed lie in a cube of uniform random numbers, one after the other: the
/// k-th of a run of 16 children at
///   shift + k (1/g, 1/g^2, 1/g^3) modulo 1, g^4 = g + 1,
/// the additive recurrence R3 (Roberts 2018), whose first n points fill the cube evenly for every
/// n. The shift is random (Cranley & Patterson 1976) and every run's own: each child by itself is
/// uniform, the children of a run avoid one another and are less noisy than independent ones, and
/// no lattice grows large enough to be seen. All arithmetic is modulo 2^32 and therefore exact.
class ChildLattice
{
public:
  ChildLattice(const RandomKey& key, RandomStream stream, std::uint64_t particle)
    : key(key)
    , stream(stream)
    , particle(particle)
  {
  }

  /// The next child's coordinates, stretched to (-1, 1), on a grid of 2^-31 about 2^-32.
  std::array<double, 3> next()
  {
    constexpr std::uint32_t run = 16;
    if (this->child % run == 0)
    {
      this->turn = randomBits(this->key, this->stream, this->particle, this->child / run);
    }
    ++this->child;
    const auto unfolded = [](std::uint32_t turn) {
      return (static_cast<std::int32_t>(turn) + 0.5) * 0x1p-31;
    };
    const std::array<double, 3> point = { unfolded(this->turn[0]), unfolded(this->turn[1]),
      unfolded(this->turn[2]) };
    this->turn[0] += 3518319155; // 2^32/g and so on
    this->turn[1] += 2882110345;
    this->turn[2] += 2360945575;
    return point;
  }

private:
  RandomKey key;
  RandomStream stream;
  std::uint64_t particle;
  std::uint32_t child = 0;
  std::array<std::uint32_t, 4> turn{};
};
} // namespace galaxy

#endif
