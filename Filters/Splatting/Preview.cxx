#include "Filters/Splatting/Preview.h"

#include "Filters/Model/Random.h"

#include <algorithm>
#include <omp.h>
#include <vector>

namespace galaxy
{
namespace
{
/// `width` numbers of each of the particles listed; none if there is no array.
template <typename T>
Buffer<T> pick(const T* values, std::size_t width, const std::vector<std::size_t>& which)
{
  Buffer<T> picked(values ? width * which.size() : 0);
  for (std::size_t k = 0; values && k < which.size(); ++k)
  {
    std::copy_n(values + width * which[k], width, &picked[width * k]);
  }
  return picked;
}

/// So many different numbers below `size` in random order. The first of them, however many, come
/// one from each of as many parts of equal length: they are the bits of 0, 1, 2 ... backwards, with
/// each bit changed at random as those above it say (Owen 1995; by the hash of Laine and Karras
/// 2011).
std::vector<std::size_t> drawFrom(std::size_t size, std::size_t count)
{
  int bits = 0;
  while (bits < 63 && size > std::size_t(1) << bits)
  {
    ++bits;
  }
  const auto random = randomBits({}, RandomStream::Preview, 0, 0);
  const std::uint64_t seed = std::uint64_t(random[0]) << 32 | random[1];
  std::vector<std::size_t> drawn;
  drawn.reserve(count);
  for (std::uint64_t k = 0; drawn.size() < count; ++k)
  {
    // A bit of a product or a sum depends on those below it only.
    std::uint64_t x = k + seed;
    for (const std::uint64_t factor : { 0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U, 0x8d22f6e6U })
    {
      x ^= x * factor;
    }
    std::uint64_t backwards = 0;
    for (int bit = 0; bit < bits; ++bit)
    {
      backwards |= (x >> bit & 1) << (bits - 1 - bit);
    }
    if (backwards < size)
    {
      drawn.push_back(backwards);
    }
  }
  return drawn;
}
} // namespace

PreviewSample::PreviewSample(const ParticleView& particles, std::size_t most)
  : of(particles.size)
{
  const std::vector<std::size_t> which = drawFrom(this->of, std::min(most, this->of));
  this->arrays.position = pick(particles.position, 3, which);
  this->arrays.smoothingLength = pick(particles.smoothingLength, 1, which);
  this->arrays.intensity = pick(particles.intensity, 1, which);
  this->arrays.color = pick(particles.color, 3, which);
  this->arrays.component = pick(particles.component, 1, which);
  this->arrays.emission = pick(particles.emission, particles.emissionChannels, which);
  this->arrays.absorption = pick(particles.absorption, particles.absorptionChannels, which);
}

ParticleView PreviewSample::first(std::size_t count, const ParticleView& like) const
{
  ParticleView view = this->arrays.view(like);
  view.size = std::min(count, this->size());
  view.weight = view.size > 0 ? double(this->of) / double(view.size) : 1;
  return view;
}

RenderedImage Preview::render(const ParticleView& particles, std::uint64_t version_,
  const Camera& camera, const RenderOptions& options, double seconds)
{
  if (!this->sample || this->version != version_)
  {
    this->sample = std::make_unique<PreviewSample>(particles);
    this->version = version_;
  }
  constexpr double fewest = 20000;
  RenderOptions sorted = options;
  sorted.accuracy = Accuracy::Sorted;
  const double start = omp_get_wtime();
  for (;;)
  {
    const double left = seconds - (omp_get_wtime() - start);
    const double count = std::max(fewest, 0.8 * this->rate * left);
    const double before = omp_get_wtime();
    const ParticleView view = this->sample->first(static_cast<std::size_t>(count), particles);
    RenderedImage image = renderSorted(view, camera, sorted);
    const double now = omp_get_wtime();
    const bool isFirst = this->rate == 0;
    this->rate = double(view.size) / std::max(1e-4, now - before);
    // The first one may be too small by far; any other took as long as it should.
    if (!isFirst || image.aborted || view.size == this->sample->size() ||
      now - start > 0.3 * seconds)
    {
      image.statistics.sampled = view.size;
      return image;
    }
  }
}
} // namespace galaxy
