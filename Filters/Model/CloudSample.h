#ifndef galaxy_CloudSample_h
#define galaxy_CloudSample_h

#include <array>
#include <cstddef>
#include <vector>

namespace galaxy
{
/// The extent of a cloud of particles, and a share of them chosen by a hash of their number.
/// Particles without a finite position belong to neither.
class CloudSample
{
public:
  /// `position` has 3 numbers a particle. All are taken where there are no more than `most`, else
  /// every second, fourth, ... on average, between most/2 and most of them.
  CloudSample(const float* position, std::size_t count, std::size_t most);

  const std::array<float, 3>& lowest() const { return this->low; }
  const std::array<float, 3>& highest() const { return this->high; }
  /// The longest side of the box about the cloud; 0 where no two particles are apart.
  double side() const { return this->longest; }
  /// The share taken: a power of 1/2.
  double share() const { return this->taken; }
  /// Positions of those taken, 3 numbers each, in pieces.
  const std::vector<std::vector<float>>& pieces() const { return this->chosen; }
  /// How many were taken.
  std::size_t size() const;

private:
  std::array<float, 3> low{}, high{};
  double longest = 0;
  double taken = 1;
  std::vector<std::vector<float>> chosen;
};
} // namespace galaxy

#endif
