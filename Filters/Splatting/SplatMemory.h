#ifndef galaxy_SplatMemory_h
#define galaxy_SplatMemory_h

#include "Filters/Model/Particles.h"
#include "Filters/Splatting/Splat.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace galaxy
{
/// Memory for splats, which begins with a cache line; on Linux in large pages where there are any,
/// since what is dealt to a thousand tiles goes to a thousand places.
class SplatMemory
{
public:
  /// Room for so many, what was there lost. Throws std::bad_alloc.
  void reserve(std::size_t count);
  Splat* data() { return this->splats.get(); }
  const Splat* data() const { return this->splats.get(); }
  /// The particle that each of them is.
  std::uint32_t* particles() { return this->numbers.data(); }
  const std::uint32_t* particles() const { return this->numbers.data(); }
  Splat& operator[](std::size_t i) { return this->splats.get()[i]; }

private:
  struct Free
  {
    void operator()(Splat* splats) const;
  };
  std::unique_ptr<Splat, Free> splats;
  Buffer<std::uint32_t> numbers;
  std::size_t capacity = 0;
};

/// Writes splats to many places in turn, two by two: whole cache lines, that memory takes without
/// having been read before.
class SplatWriter
{
public:
  /// `places` are the slots of `memory` where the next splat of each of the lists goes.
  SplatWriter(SplatMemory& memory, const std::vector<std::size_t>& places);
  ~SplatWriter();
  SplatWriter(const SplatWriter&) = delete;
  void operator=(const SplatWriter&) = delete;

  void write(std::size_t list, const Splat& splat, std::uint32_t particle)
  {
    const std::size_t place = this->next[list]++;
    this->particles[place] = particle;
    this->lines[list].splats[place & 1] = splat;
    if (place & 1)
    {
      this->flush(list, place);
    }
  }

private:
  struct alignas(64) Line
  {
    Splat splats[2];
  };
  void flush(std::size_t list, std::size_t last);

  // Apart, so that a core's caches hold as much of them as they can.
  SplatMemory& memory;
  std::uint32_t* particles;
  std::vector<Line> lines;
  std::vector<std::size_t> first, next;
};
} // namespace galaxy

#endif
