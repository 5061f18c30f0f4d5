#ifndef galaxy_ParticleTable_h
#define galaxy_ParticleTable_h

#include "Filters/Model/Particles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace galaxy
{
/// Particles to be written, seen in place: `size` values or triples behind each pointer, which must
/// outlive the view. Only the positions are required; what is null is written as said below.
struct ParticleTable
{
  std::size_t size = 0;
  const float* position = nullptr;         ///< 3 N, kpc
  const float* velocity = nullptr;         ///< 3 N, km/s; else 0
  const float* smoothingLength = nullptr;  ///< N, kpc, where the kernel ends; else 0
  const float* intensity = nullptr;        ///< N, luminosity or cross-section in kpc^2; else 1
  const std::uint8_t* color = nullptr;     ///< 3 N, RGB_s; else white
  const std::uint8_t* component = nullptr; ///< N, index into `components`; else 0
  const float* emission = nullptr;         ///< emissionChannels N, luminosity; else not written
  const float* absorption = nullptr;       ///< absorptionChannels N, kpc^2; else not written
  int emissionChannels = 3;                ///< 1 or 3
  int absorptionChannels = 3;              ///< 1 or 3
  std::vector<ComponentInfo> components{ 1 };
  std::string madeUp; ///< what of it is not the particles' own, for the file to say; or empty

  float intensityOf(std::size_t i) const { return this->intensity ? this->intensity[i] : 1; }
  float smoothingLengthOf(std::size_t i) const
  {
    return this->smoothingLength ? this->smoothingLength[i] : 0;
  }
  std::array<float, 3> velocityOf(std::size_t i) const
  {
    const float* v = this->velocity + 3 * i;
    return this->velocity ? std::array<float, 3>{ v[0], v[1], v[2] } : std::array<float, 3>{};
  }
  std::array<std::uint8_t, 3> colorOf(std::size_t i) const
  {
    const std::uint8_t* c = this->color + 3 * i;
    return this->color ? std::array<std::uint8_t, 3>{ c[0], c[1], c[2] }
                       : std::array<std::uint8_t, 3>{ 255, 255, 255 };
  }
  std::uint8_t componentOf(std::size_t i) const
  {
    return this->component ? this->component[i] : std::uint8_t{ 0 };
  }
};

inline ParticleTable tableOf(const Particles& particles)
{
  ParticleTable table;
  table.size = particles.size();
  table.position = particles.position.data();
  table.velocity = particles.velocity.empty() ? nullptr : particles.velocity.data();
  table.smoothingLength = particles.smoothingLength.data();
  table.intensity = particles.intensity.data();
  table.color = particles.color.data();
  table.component = particles.component.data();
  table.components = particles.components;
  return table;
}
} // namespace galaxy

#endif
