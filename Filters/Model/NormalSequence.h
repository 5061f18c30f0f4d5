#ifndef galaxy_NormalSequence_h
#define galaxy_NormalSequence_h

#include "Filters/Model/Random.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace galaxy
{
/// Replaces `count` numbers x, |x| <= 1 - 2^-32, by their normalQuantile: uniform numbers between
/// -1 and 1 become normal deviates of unit variance. The same on every machine.
void toNormalDeviates(double* numbers, std::size_t count);

/// The normal deviates of one particle, of unit variance, one after the other; made `Batch` (a
/// multiple of 4) at a time, in vector code.
template <std::size_t Batch>
class NormalSequence
{
  static_assert(Batch % 4 == 0);

public:
  /// None is larger: the quantile of 1 - 2^-32, 6.34, rounded up.
  static constexpr double largest = 6.4;

  NormalSequence(const RandomKey& key, RandomStream stream, std::uint64_t particle)
    : key(key)
    , stream(stream)
    , particle(particle)
  {
  }

  double next()
  {
    if (this->at == Batch)
    {
      this->refill();
    }
    return this->values[this->at++];
  }

private:
  void refill()
  {
    for (std::size_t k = 0; k < Batch; k += 4)
    {
      const auto bits = randomBits(this->key, this->stream, this->particle, this->block++);
      for (std::size_t j = 0; j < 4; ++j)
      {
        this->values[k + j] = (static_cast<std::int32_t>(bits[j]) + 0.5) * 0x1p-31;
      }
    }
    toNormalDeviates(this->values.data(), Batch);
    this->at = 0;
  }

  RandomKey key;
  RandomStream stream;
  std::uint64_t particle;
  std::uint32_t block = 0;
  std::size_t at = Batch;
  std::array<double, Batch> values;
};
} // namespace galaxy

#endif
