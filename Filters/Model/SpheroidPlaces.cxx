#include "Filters/Model/SpheroidPlaces.h"

#include <cmath>

namespace galaxy
{
Vec3 randomDirection(Random& random)
{
  constexpr double twoPi = 6.283185307179586;
  const double u = random.uniform();
  const auto [sine, cosine] = sineCosine(twoPi * random.uniform());
  const double radius = 2 * std::sqrt(u * (1 - u));
  return { radius * cosine, radius * sine, 1 - 2 * u };
}

SpheroidPlaces::SpheroidPlaces(const SpheroidDescription& spheroid, const TiltedDisk& disk,
  const RandomKey& key, RandomStream stream)
  : profile(spheroid)
  , shape(spheroid, disk)
  , key(key)
  , stream(stream)
  , fraction(key, stream)
{
}

Vec3 SpheroidPlaces::operator()(std::uint64_t i) const
{
  Random random(this->key, this->stream, i);
  return this->shape.position(this->profile.radius(this->fraction(i)), randomDirection(random));
}
} // namespace galaxy
