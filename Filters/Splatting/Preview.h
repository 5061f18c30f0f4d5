#ifndef galaxy_Preview_h
#define galaxy_Preview_h

#include "Filters/Splatting/ParticleArrays.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace galaxy
{
/// Particles drawn at random, all with the same chance, in random order: of any length, its
/// beginning is a fair sample of all, with about as many from each part of the list.
class PreviewSample
{
public:
  /// Copies so many particles, or all if there are fewer.
  explicit PreviewSample(const ParticleView& particles, std::size_t most = std::size_t(1) << 21);

  std::size_t size() const { return this->arrays.size(); }

  /// The first particles of the sample, each of which stands for as many of all as it takes: light
  /// and what absorbers let through are the whole's on average. `like` has what is not the
  /// particles': the components and which of them are shown.
  ParticleView first(std::size_t count, const ParticleView& like) const;

private:
  std::size_t of = 0; ///< how many particles it was drawn from
  ParticleArrays arrays;
};

/// Pictures of a part of the particles, as large as time allows. Kept from picture to picture it
/// knows its sample and how fast it is.
class Preview
{
public:
  /// Draws at accuracy level `Sorted` in about so many seconds, besides those that the sample takes
  /// the first time. `version` tells one set of particles from another.
  RenderedImage render(const ParticleView& particles, std::uint64_t version, const Camera& camera,
    const RenderOptions& options, double seconds);

  /// Particles that a picture can have, 0 before the first one.
  std::size_t most() const { return this->sample ? this->sample->size() : 0; }

private:
  std::unique_ptr<PreviewSample> sample;
  std::uint64_t version = 0;
  double rate = 0; ///< particles a second; 0: not known yet
};
} // namespace galaxy

#endif
