#ifndef galaxy_ParticleArrays_h
#define galaxy_ParticleArrays_h

#include "Filters/Model/Particles.h"
#include "Filters/Splatting/Render.h"
#include "Readers/Formats/AvailableMemory.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace galaxy
{
/// Throws Error where copies of so many particles, of so many floats and bytes each, would not fit
/// into memory.
inline void requireMemoryOfCopies(std::size_t count, std::size_t floats, std::size_t bytes)
{
  requireMemory(double(count) * double(sizeof(float) * floats + bytes), "particles", "",
    "a changed copy of " + std::to_string(count) + " of them",
    "use a smaller ParticleScale or hide some");
}

/// The arrays of a ParticleView as one's own: those of a part of its particles, of several sets of
/// them one after another, or changed ones.
struct ParticleArrays
{
  Buffer<float> position, smoothingLength, intensity, emission, absorption;
  Buffer<std::uint8_t> color, component;

  std::size_t size() const { return this->smoothingLength.size(); }

  /// These particles. What has no array here, and what is not the particles' own, is as in `like`.
  ParticleView view(const ParticleView& like = {}) const
  {
    ParticleView view = like;
    const auto take = [](auto& to, const auto& own) { to = own.empty() ? to : own.data(); };
    view.size = this->size();
    take(view.position, this->position);
    take(view.smoothingLength, this->smoothingLength);
    take(view.intensity, this->intensity);
    take(view.color, this->color);
    take(view.component, this->component);
    take(view.emission, this->emission);
    take(view.absorption, this->absorption);
    return view;
  }
};
} // namespace galaxy

#endif
