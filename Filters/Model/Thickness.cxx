#include "Filters/Model/Thickness.h"

#include "Filters/Model/SineCosine.h"
#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
ParticleStarts countChildren(const Seeds& seeds, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, const std::string& file)
{
  if (!(component.thickness.children >= 0) || !(component.thickness.compression <= 1))
  {
    throw Error(
      file, component.name, "thickness: children must not be negative, compression not above 1");
  }
  const ThicknessProfile profile(component.thickness, disk);
  const double most = std::max(1, component.thickness.maximumChildren);
  ParticleStarts starts(seeds.size() + 1);
  starts[0] = 0;
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    Random random(key, RandomStream::ChildCount, seeds.index[i]);
    const double mean = profile.meanChildren(seeds.radius[i], seeds.intensity[i]);
    const double rounded = std::floor(std::min(mean, most) + random.uniform());
    starts[i + 1] = static_cast<std::uint64_t>(std::clamp(rounded, 1.0, most));
  }
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    starts[i + 1] += starts[i];
  }
  return starts;
}

void placeChildren(const Seeds& seeds, const ParticleStarts& starts, const TiltedDisk& disk,
  const ComponentDescription& component, const RandomKey& key, double lightFactor,
  const ParticleWriter& writer)
{
  const ThicknessProfile profile(component.thickness, disk);
  const double sigma = profile.inPlaneSigma();
  const LayerLaw law = profile.law();
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const double r = seeds.radius[i];
    const auto [sine, cosine] = sineCosine(seeds.azimuth[i]);
    const RingFrame ring = disk.frame(r);
    const Vec3 centre = r * cosine * ring.a + r * sine * ring.b;
    const Vec3 velocity = ringVelocity(ring, cosine, sine);
    const double height = profile.scaleHeight(r);
    const double highest = normalFocalHeight(ring);
    const auto light =
      static_cast<float>(lightFactor * seeds.light[i] / (starts[i + 1] - starts[i]));

    Random random(key, RandomStream::ChildPlace, seeds.index[i]);
    for (std::uint64_t child = starts[i]; child < starts[i + 1]; ++child)
    {
      Vec3 p = centre;
      if (sigma > 0)
      {
        const auto [u, v] = random.normalPair();
        p = p + sigma * u * ring.a + sigma * v * ring.b;
      }
      const double z = height > 0 ? height * sampleHeight(law, random) : 0;
      p = p + std::clamp(z, -highest, highest) * ring.n;
      writer.write(child, p, light, &seeds.color[3 * i], velocity);
    }
  }
}
} // namespace galaxy
