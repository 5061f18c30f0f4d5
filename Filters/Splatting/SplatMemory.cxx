#include "Filters/Splatting/SplatMemory.h"

#include <hwy/cache_control.h>

#include <cstdlib>
#include <cstring>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace galaxy
{
void SplatMemory::Free::operator()(Splat* splats) const
{
  std::free(splats);
}

void SplatMemory::reserve(std::size_t count)
{
  if (count <= this->capacity)
  {
    return;
  }
  constexpr std::size_t page = std::size_t(1) << 21;
  const std::size_t bytes = (count * sizeof(Splat) + page - 1) / page * page;
  this->splats.reset();
  this->capacity = 0;
  this->numbers = {};
  this->numbers.resize(count);
  this->splats.reset(static_cast<Splat*>(std::aligned_alloc(page, bytes)));
  if (!this->splats)
  {
    throw std::bad_alloc();
  }
#ifdef __linux__
  madvise(this->splats.get(), bytes, MADV_HUGEPAGE);
#endif
  this->capacity = count;
}

SplatWriter::SplatWriter(SplatMemory& memory, const std::vector<std::size_t>& places)
  : memory(memory)
  , particles(memory.particles())
  , lines(places.size())
  , first(places)
  , next(places)
{
}

/// Writes the line that ends with the place.
void SplatWriter::flush(std::size_t list, std::size_t last)
{
  const Line& line = this->lines[list];
  Splat* to = &this->memory[last - 1];
  if (last == this->first[list])
  {
    to[1] = line.splats[1]; // another share writes the line's first half
    return;
  }
#ifdef __SSE2__
  const auto* from = reinterpret_cast<const __m128i*>(&line);
  for (std::size_t k = 0; k < sizeof(line) / 16; ++k)
  {
    _mm_stream_si128(reinterpret_cast<__m128i*>(to) + k, _mm_load_si128(from + k));
  }
#else
  std::memcpy(to, &line, sizeof(line));
#endif
}

SplatWriter::~SplatWriter()
{
  for (std::size_t list = 0; list < this->lines.size(); ++list)
  {
    if (this->next[list] & 1 && this->next[list] > this->first[list])
    {
      this->memory[this->next[list] - 1] = this->lines[list].splats[0];
    }
  }
  hwy::FlushStream();
}
} // namespace galaxy
