#include "Filters/Model/Placement.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/ParticleWriter.h"
#include "Readers/Formats/ComponentLimit.h"
#include "Readers/Formats/Error.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// ICRS components to those along the frame's axes.
Vec3 seenFrom(const SkyFrame& frame, const Vec3& v)
{
  return { dot(frame.axes()[0], v), dot(frame.axes()[1], v), dot(frame.axes()[2], v) };
}

Vec3 load(const float* from)
{
  return { from[0], from[1], from[2] };
}

void store(float* to, const Vec3& v)
{
  to[0] = static_cast<float>(v.x);
  to[1] = static_cast<float>(v.y);
  to[2] = static_cast<float>(v.z);
}

bool allHaveVelocities(const std::vector<Particles>& galaxies)
{
  return std::all_of(galaxies.begin(), galaxies.end(),
    [](const Particles& galaxy) { return galaxy.velocity.size() == 3 * galaxy.size(); });
}
} // namespace

Placement placementOf(
  const SkyFrame& galaxy, const SkyFrame& origin, double magnification, double separation)
{
  Placement placement;
  placement.centre = separation * seenFrom(origin, galaxy.centre() - origin.centre());
  for (int k = 0; k < 3; ++k)
  {
    placement.axes[k] = seenFrom(origin, galaxy.axes()[k]);
  }
  placement.magnification = magnification;
  return placement;
}

void placeParticles(const Placement& placement, Particles& particles)
{
  const double S = placement.magnification;
  parallelFor<std::size_t>(0, particles.size(), [&](std::size_t i) {
    store(&particles.position[3 * i], placement.apply(load(&particles.position[3 * i])));
    particles.smoothingLength[i] = static_cast<float>(S * particles.smoothingLength[i]);
    particles.intensity[i] = static_cast<float>(S * S * particles.intensity[i]);
    if (!particles.velocity.empty())
    {
      store(&particles.velocity[3 * i], placement.rotate(load(&particles.velocity[3 * i])));
    }
  });
}

Particles mergeParticles(
  const std::vector<Particles>& galaxies, const std::vector<std::string>& names)
{
  std::size_t total = 0;
  for (const Particles& galaxy : galaxies)
  {
    total += galaxy.size();
  }
  Particles merged = allocateParticles(total, allHaveVelocities(galaxies));
  std::size_t start = 0;
  for (std::size_t k = 0; k < galaxies.size(); ++k)
  {
    const Particles& galaxy = galaxies[k];
    const std::size_t firstComponent = merged.components.size();
    for (ComponentInfo info : galaxy.components)
    {
      info.name = names[k] + "/" + info.name;
      merged.components.push_back(info);
    }
    if (merged.components.size() > mostComponents)
    {
      throw Error(names[k], "component",
        "more than 256 components with those of the members before; leave some out");
    }
    std::copy(galaxy.position.begin(), galaxy.position.end(), merged.position.begin() + 3 * start);
    std::copy(galaxy.smoothingLength.begin(), galaxy.smoothingLength.end(),
      merged.smoothingLength.begin() + start);
    std::copy(galaxy.intensity.begin(), galaxy.intensity.end(), merged.intensity.begin() + start);
    std::copy(galaxy.color.begin(), galaxy.color.end(), merged.color.begin() + 3 * start);
    std::transform(galaxy.component.begin(), galaxy.component.end(),
      merged.component.begin() + start, [firstComponent](std::uint8_t component) {
        return static_cast<std::uint8_t>(component + firstComponent);
      });
    if (!merged.velocity.empty())
    {
      std::copy(
        galaxy.velocity.begin(), galaxy.velocity.end(), merged.velocity.begin() + 3 * start);
    }
    start += galaxy.size();
  }
  return merged;
}
} // namespace galaxy
