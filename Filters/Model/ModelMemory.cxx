#include "Filters/Model/ModelMemory.h"

#include "Filters/Model/ParticleWriter.h"
#include "Readers/Formats/AvailableMemory.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// Of a seed: its arrays, and where its particles start.
constexpr double bytesOfSeed = 5 * 4 + 3 + 8;
/// Of a particle among those whose neighbours are sought: its number, and its share of the tree.
constexpr double bytesOfNeighbour = 8 + 16;

const char* const cure = "use a smaller ParticleScale or fewer `particles`";

double bytesOfParticle(const BuildOptions& options)
{
  constexpr double vertex = 4;                    // that ParaView shows it by
  return (options.velocities ? 36 : 24) + vertex; // see Particles
}

double bytesOfSmoothing(const ComponentDescription& component)
{
  return component.smoothing.model == SmoothingModel::Neighbours ? bytesOfNeighbour : 0;
}

std::string modelOf(double particles)
{
  return std::to_string(static_cast<long long>(particles)) + " particles: the model";
}
} // namespace

void requireMemoryFor(
  const std::vector<const GalaxyDescription*>& galaxies, const BuildOptions& options, double copies)
{
  double particles = 0;
  for (const GalaxyDescription* galaxy : galaxies)
  {
    for (const ComponentDescription& component : galaxy->components)
    {
      const auto own = static_cast<double>(scaledCount(options,
        component.automaticCount ? 0 : static_cast<double>(component.particles), galaxy->file,
        component.name));
      particles += own;
      const double besides = component.type == ComponentType::Disk ? bytesOfSeed : 0;
      requireMemory(copies * particles * bytesOfParticle(options) +
          own * std::max(besides, bytesOfSmoothing(component)),
        galaxy->file, component.name, modelOf(particles), cure);
    }
  }
}

void addParticles(std::size_t count, const BuildOptions& options, const std::string& file,
  const ComponentDescription& component, Particles& particles)
{
  const auto own = static_cast<double>(count);
  requireMemory(own * (bytesOfParticle(options) + bytesOfSmoothing(component)), file,
    component.name, modelOf(own), cure);
  resizeParticles(particles, particles.size() + count, options.velocities);
}
} // namespace galaxy
