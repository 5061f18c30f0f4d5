#ifndef galaxy_ParticleWriter_h
#define galaxy_ParticleWriter_h

#include "Filters/Model/Particles.h"
#include "Readers/Formats/Vec3.h"

#include <cstdint>

namespace galaxy
{
/// Memory for `size` particles, with velocities where asked.
inline Particles allocateParticles(std::size_t size, bool velocities)
{
  Particles particles;
  particles.position = Buffer<float>(3 * size);
  particles.smoothingLength = Buffer<float>(size);
  particles.intensity = Buffer<float>(size);
  particles.color = Buffer<std::uint8_t>(3 * size);
  particles.component = Buffer<std::uint8_t>(size);
  particles.velocity = Buffer<float>(velocities ? 3 * size : 0);
  return particles;
}

/// Writes one component's particles into its stretch of the arrays, from `offset` on.
class ParticleWriter
{
public:
  ParticleWriter(
    Particles& particles, std::size_t offset, std::uint8_t component, double smoothingLength)
    : particles(particles)
    , offset(offset)
    , component(component)
    , smoothingLength(static_cast<float>(smoothingLength))
  {
  }

  bool wantsVelocity() const { return !this->particles.velocity.empty(); }

  /// `velocity` is not looked at unless wanted.
  void write(std::size_t i, const Vec3& p, float intensity, const std::uint8_t* color,
    const Vec3& velocity) const
  {
    const std::size_t k = this->offset + i;
    store(&this->particles.position[3 * k], p);
    this->particles.smoothingLength[k] = this->smoothingLength;
    this->particles.intensity[k] = intensity;
    this->particles.color[3 * k] = color[0];
    this->particles.color[3 * k + 1] = color[1];
    this->particles.color[3 * k + 2] = color[2];
    this->particles.component[k] = this->component;
    if (this->wantsVelocity())
    {
      store(&this->particles.velocity[3 * k], velocity);
    }
  }

private:
  static void store(float* to, const Vec3& v)
  {
    to[0] = static_cast<float>(v.x);
    to[1] = static_cast<float>(v.y);
    to[2] = static_cast<float>(v.z);
  }

  Particles& particles;
  std::size_t offset;
  std::uint8_t component;
  float smoothingLength;
};
} // namespace galaxy

#endif
