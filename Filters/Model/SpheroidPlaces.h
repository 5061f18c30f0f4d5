#ifndef galaxy_SpheroidPlaces_h
#define galaxy_SpheroidPlaces_h

#include "Filters/Model/RadialProfile.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/SpheroidShape.h"

namespace galaxy
{
/// Fractions that fill (0, 1) far more evenly than random ones, however many are taken: multiples
/// of the golden section modulo 1 (Weyl) from a random start. Any n of them in a row miss the
/// share of any interval by the order of ln n, not sqrt n.
class EvenFractions
{
public:
  /// Another start for each key and stream.
  EvenFractions(const RandomKey& key, RandomStream stream)
    : start(static_cast<std::uint64_t>(0x1p64 * Random(key, stream, ~0ull).uniform()))
  {
  }
  double operator()(std::uint64_t i) const
  {
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;
    return (static_cast<double>((this->start + i * golden) >> 12) + 0.5) * 0x1p-52;
  }

private:
  std::uint64_t start;
};

/// A direction of unit length; all are equally likely.
Vec3 randomDirection(Random& random);

/// Places of a spheroid's density, each a pure function of the key, the stream and its index: the
/// radius by an even fraction of the mass, the direction at random.
class SpheroidPlaces
{
public:
  SpheroidPlaces(const SpheroidDescription& spheroid, const TiltedDisk& disk, const RandomKey& key,
    RandomStream stream);

  Vec3 operator()(std::uint64_t i) const;

private:
  RadialProfile profile;
  SpheroidShape shape;
  RandomKey key;
  RandomStream stream;
  EvenFractions fraction;
};
} // namespace galaxy

#endif
