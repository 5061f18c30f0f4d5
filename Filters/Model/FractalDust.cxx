#include "Filters/Model/FractalDust.h"

#include "Filters/Model/FractalNoise.h"
#include "Filters/Model/NormalSequence.h"
#include "Filters/Model/SineCosine.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// A place in the plane of the rings.
struct PlanePoint
{
  double r; ///< kpc
  SineCosine direction;
};

PlanePoint displaced(const PlanePoint& seed, double dx, double dy)
{
  const double x = seed.r * seed.direction.cosine + dx;
  const double y = seed.r * seed.direction.sine + dy;
  const double r = std::sqrt(x * x + y * y);
  return { r, r > 0 ? SineCosine{ y / r, x / r } : SineCosine{ 0, 1 } };
}
} // namespace

ParticleStarts countFractalDust(const Seeds& seeds, const ComponentDescription& component)
{
  ParticleStarts starts(seeds.size() + 1);
  for (std::size_t i = 0; i <= seeds.size(); ++i)
  {
    starts[i] = i * component.dust.children;
  }
  return starts;
}

void placeFractalDust(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
  const DustDescription& dust = component.dust;
  const FractalClouds clouds(dust, key);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const PlanePoint seed = { seeds.radius[i], sineCosine(seeds.azimuth[i]) };
    const double light = lightFactor * seeds.light[i] / (starts[i + 1] - starts[i]);
    NormalSequence<8> normal(key, RandomStream::FractalPlace, seeds.index[i]);
    for (std::uint64_t child = starts[i]; child < starts[i + 1]; ++child)
    {
      PlanePoint place = seed;
      const double height = dust.scaleHeight * normal.next();
      if (child > starts[i])
      {
        const double dx = dust.spread * normal.next(), dy = dust.spread * normal.next();
        place = displaced(seed, dx, dy);
        place = place.r >= seeds.innerRadius && place.r <= seeds.outerRadius ? place : seed;
      }
      const RingFrame ring = disk.frame(place.r);
      const auto [sine, cosine] = place.direction;
      const double highest = normalFocalHeight(ring);
      const double z = std::clamp(height, -highest, highest);
      const double weight = clouds.weight(place.r, cosine, sine, z);
      const Vec3 p = place.r * cosine * ring.a + place.r * sine * ring.b + z * ring.n;
      writer.write(child, p, static_cast<float>(light * weight), &seeds.color[3 * i],
        ringVelocity(ring, cosine, sine));
    }
  }
}
} // namespace galaxy
