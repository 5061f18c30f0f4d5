#ifndef galaxy_Random_h
#define galaxy_Random_h

#include "Filters/Model/SineCosine.h"
#include "Readers/Formats/Vec3.h"

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace galaxy
{
/// What a random number is for; numbers of different streams are independent.
enum class RandomStream : std::uint32_t
{
  SeedPlace,
  ChildCount,
  ChildPlace,
  FilamentPlane,
  FilamentHeight,
  SpheroidPlace,
  FractalPlace,
  SeedSheet,
  PixelFill,
  ChildVelocity,
  ClusterStar,
  SpheroidVelocity,
  FractalNoise,
  Preview,
};

/// What all random numbers of one component share.
struct RandomKey
{
  std::uint64_t seed = 1;
  std::uint32_t component = 0;
};

/// 128 random bits: a pure function of (seed, component, stream, particle, block) by Philox4x32-10
/// (Salmon et al. 2011), hence the same for any number of threads.
inline std::array<std::uint32_t, 4> randomBits(
  const RandomKey& key, RandomStream stream, std::uint64_t particle, std::uint32_t block)
{
  const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(
    { { block, static_cast<std::uint32_t>(particle), static_cast<std::uint32_t>(particle >> 32),
      key.component << 8 | static_cast<std::uint32_t>(stream) } },
    { { static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32) } });
  return { bits.v[0], bits.v[1], bits.v[2], bits.v[3] };
}

/// The random numbers of one particle, drawn one after the other.
class Random
{
public:
  Random(const RandomKey& key, RandomStream stream, std::uint64_t particle)
    : key(key)
    , stream(stream)
    , particle(particle)
  {
  }

  /// Uniform in the open interval (0, 1), on a grid of 2^-52 about 2^-53.
  double uniform()
  {
    if (this->left == 0)
    {
      this->refill();
    }
    return this->words[--this->left];
  }

  /// Two independent normal deviates of unit variance (Box and Muller 1958).
  std::array<double, 2> normalPair()
  {
    constexpr double twoPi = 6.283185307179586;
    const double radius = std::sqrt(-2 * std::log(this->uniform()));
    const auto [sine, cosine] = sineCosine(twoPi * this->uniform());
    return { radius * cosine, radius * sine };
  }

  /// A normal deviate of unit variance.
  double normal()
  {
    if (this->hasSpare)
    {
      this->hasSpare = false;
      return this->spare;
    }
    const auto [first, second] = this->normalPair();
    this->spare = second;
    this->hasSpare = true;
    return first;
  }

  /// Three normal deviates of unit variance.
  Vec3 normalVector()
  {
    const double x = this->normal();
    const double y = this->normal();
    return { x, y, this->normal() };
  }

private:
  void refill()
  {
    const auto bits = randomBits(this->key, this->stream, this->particle, this->block++);
    // 52 bits leave room for the half step that keeps 0 and 1 out.
    const auto toUnit = [](std::uint64_t high, std::uint64_t low) {
      return (static_cast<double>((high << 32 | low) >> 12) + 0.5) * 0x1p-52;
    };
    this->words = { toUnit(bits[3], bits[2]), toUnit(bits[1], bits[0]) };
    this->left = 2;
  }

  RandomKey key;
  RandomStream stream;
  std::uint64_t particle;
  std::uint32_t block = 0;
  std::array<double, 2> words{};
  double spare = 0;
  int left = 0;
  bool hasSpare = false;
};
} // namespace galaxy

#endif
