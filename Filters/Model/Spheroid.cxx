#include "Filters/Model/Spheroid.h"

#include "Filters/Model/ClusterSystem.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SpheroidPlaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace galaxy
{
namespace
{
using ColorBytes = std::array<std::uint8_t, 3>;

/// The colour relative to its largest channel, which the light takes over.
ColorBytes relativeColor(const Color& color, double largest)
{
  ColorBytes bytes{};
  for (int c = 0; c < 3; ++c)
  {
    const double ratio = largest > 0 ? color[c] / largest : 0;
    bytes[c] = static_cast<std::uint8_t>(255 * std::clamp(ratio, 0.0, 1.0) + 0.5);
  }
  return bytes;
}

Vec3 randomVelocity(const RandomKey& key, std::size_t i, double dispersion)
{
  Random random(key, RandomStream::SpheroidVelocity, i);
  const auto [u, v] = random.normalPair();
  return dispersion * Vec3{ u, v, random.normal() };
}

/// What is the same of all particles of a spheroid.
struct Common
{
  float light;
  ColorBytes color;
  double dispersion;
};

template <class Places>
void writeAt(const Places& places, const RandomKey& key, std::size_t count, const Common& common,
  const ParticleWriter& writer)
{
  const bool moves = writer.wantsVelocity() && common.dispersion > 0;
  constexpr std::size_t atOnce = 1024;
  parallelFor<std::size_t>(0, (count + atOnce - 1) / atOnce, [&](std::size_t block) {
    const std::size_t first = block * atOnce, last = std::min(first + atOnce, count);
    for (std::size_t i = first; i < last; ++i)
    {
      const Vec3 velocity = moves ? randomVelocity(key, i, common.dispersion) : Vec3{};
      writer.write(i, places(i), common.light, common.color.data(), velocity);
    }
    writer.advance(last - first);
  });
}
} // namespace

double spheroidLight(const TiltedDisk& disk, const SpheroidDescription& spheroid)
{
  if (std::isfinite(spheroid.luminosity))
  {
    return spheroid.luminosity;
  }
  // Flattening along the line of sight leaves a surface density as it is; across it, the area
  // shrinks by the other two axes.
  const RadialProfile profile(spheroid);
  const double s = profile.radius(0.5);
  const SemiAxes axes = SpheroidShape(spheroid, disk).semiAxes(s);
  const double area = length(axes[0]) * length(axes[1]) / (s * s);
  return spheroid.centralBrightness * area / profile.surfaceBrightness();
}

void placeSpheroid(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, std::size_t count, double lightFactor, const ParticleWriter& writer)
{
  const SpheroidDescription& spheroid = component.spheroid;
  const double largest = *std::max_element(component.color.begin(), component.color.end());
  const double shown = component.role == ComponentRole::Absorbs ? 1 : largest;
  const double total = lightFactor * shown * spheroidLight(disk, spheroid);
  const Common common = { static_cast<float>(total / count),
    relativeColor(component.color, largest), component.velocityDispersion };
  if (ClusterSystem::describedBy(spheroid))
  {
    writeAt(ClusterSystem(spheroid, disk, key, count), key, count, common, writer);
  }
  else
  {
    writeAt(
      SpheroidPlaces(spheroid, disk, key, RandomStream::SpheroidPlace), key, count, common, writer);
  }
}
} // namespace galaxy
