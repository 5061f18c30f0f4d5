#ifndef galaxy_ParticleWriter_h
#define galaxy_ParticleWriter_h

#include "Filters/Model/Particles.h"
#include "Filters/Model/WorkProgress.h"
#include "Readers/Formats/Vec3.h"

#include <cstdint>

namespace galaxy
{
/// Grows or shrinks the arrays, the velocities where asked; what fits is kept.
inline void resizeParticles(Particles& particles, std::size_t size, bool velocities)
{
  particles.position.resize(3 * size);
  particles.smoothingLength.resize(size);
  particles.intensity.resize(size);
  particles.color.resize(3 * size);
  particles.component.resize(size);
  particles.velocity.resize(velocities ? 3 * size : 0);
}

/// Memory for `size` particles, with velocities where asked.
inline Particles allocateParticles(std::size_t size, bool velocities)
{
  Particles particles;
  resizeParticles(particles, size, velocities);
  return particles;
}

/// Writes all but the smoothing lengths of one component's particles into its stretch of the
/// arrays, from `offset` on.
class ParticleWriter
{
public:
  /// `work` is told how many are done; null: nobody is.
  ParticleWriter(
    Particles& particles, std::size_t offset, std::uint8_t component, WorkProgress* work = nullptr)
    : particles(particles)
    , offset(offset)
    , component(component)
    , work(work)
  {
  }

  /// So many more are written, or about to be. False when they are not wanted any more.
  bool advance(std::size_t count) const { return !this->work || this->work->advance(count); }

  bool wantsVelocity() const { return !this->particles.velocity.empty(); }

  /// `velocity` is not looked at unless wanted.
  void write(std::size_t i, const Vec3& p, float intensity, const std::uint8_t* color,
    const Vec3& velocity) const
  {
    const std::size_t k = this->offset + i;
    store(&this->particles.position[3 * k], p);
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

  /// Multiplies the intensities of the first `count` particles written.
  void scaleIntensities(std::size_t count, double factor) const
  {
#pragma omp parallel for schedule(static)
    for (std::size_t k = this->offset; k < this->offset + count; ++k)
    {
      this->particles.intensity[k] = static_cast<float>(factor * this->particles.intensity[k]);
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
  WorkProgress* work;
};
} // namespace galaxy

#endif
