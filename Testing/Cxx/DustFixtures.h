#ifndef galaxy_DustFixtures_h
#define galaxy_DustFixtures_h

#include "Filters/Model/DustFilaments.h"
#include "Testing/Cxx/ModelFixtures.h"

namespace galaxy
{
/// An exponential disc of dust.
inline ComponentDescription dustDisk()
{
  ComponentDescription component;
  component.name = "dust";
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 5;
  component.role = ComponentRole::Absorbs;
  component.hasDust = true;
  return component;
}

/// The dust of a disc with these rings, whose light is 2.5 times its seeds'.
struct Filaments
{
  Filaments(const RingTable& rings, const ComponentDescription& component, std::size_t count)
    : disk(rings, m83Distance)
    , seeds(sampleSeeds(this->disk, component, {}, {}, count, "m83.galaxy"))
  {
    requireStableFilaments(this->seeds, this->disk, component, "m83.galaxy");
    this->starts = countFilaments(this->seeds, this->disk, component, {});
    this->particles = allocateParticles(this->starts[this->seeds.size()], true);
    placeFilaments(this->seeds, this->starts, this->disk, component, {}, 2.5,
      ParticleWriter(this->particles, 0, 0));
  }

  Vec3 position(std::size_t i) const { return vector(this->particles.position, i); }
  Vec3 velocity(std::size_t i) const { return vector(this->particles.velocity, i); }

  static Vec3 vector(const Buffer<float>& values, std::size_t i)
  {
    return { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
  }

  TiltedDisk disk;
  Seeds seeds;
  ParticleStarts starts;
  Particles particles;
};
} // namespace galaxy

#endif
