#include "Filters/Model/CloudSample.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SameClones.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace galaxy
{
namespace
{
constexpr std::size_t blockSize = 512;
constexpr float most = std::numeric_limits<float>::max();

struct Box
{
  float low[3] = { most, most, most };
  float high[3] = { -most, -most, -most };

  void add(const Box& box)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->low[c] = std::min(this->low[c], box.low[c]);
      this->high[c] = std::max(this->high[c], box.high[c]);
    }
  }
};

/// Widens `box` by n <= blockSize particles, the first of number `first`; `chosen` marks those
/// whose number's hash has no bit of `mask`.
GALAXY_SAME_CLONES
void survey(const float* position, std::uint32_t first, std::size_t n, std::uint32_t mask, Box& box,
  std::uint8_t* chosen)
{
  float lx = most, ly = most, lz = most, hx = -most, hy = -most, hz = -most;
#pragma omp simd reduction(min : lx, ly, lz) reduction(max : hx, hy, hz)
  for (std::size_t j = 0; j < n; ++j)
  {
    const float x = position[3 * j], y = position[3 * j + 1], z = position[3 * j + 2];
    const bool finite =
      (std::abs(x) <= most) & (std::abs(y) <= most) & (std::abs(z) <= most); // no branches
    lx = std::min(lx, finite ? x : most), hx = std::max(hx, finite ? x : -most);
    ly = std::min(ly, finite ? y : most), hy = std::max(hy, finite ? y : -most);
    lz = std::min(lz, finite ? z : most), hz = std::max(hz, finite ? z : -most);
    std::uint32_t hash = (first + static_cast<std::uint32_t>(j)) * 0x9e3779b1u;
    hash = (hash ^ hash >> 15) * 0x2c1b3c6du;
    chosen[j] = finite & ((hash >> 16 & mask) == 0);
  }
  box.add({ { lx, ly, lz }, { hx, hy, hz } });
}

/// Appends the chosen ones of n particles.
void copyChosen(
  const float* position, std::size_t n, const std::uint8_t* chosen, std::vector<float>& to)
{
  std::uint16_t list[blockSize];
  std::size_t m = 0;
  for (std::size_t j = 0; j < n; ++j)
  {
    list[m] = static_cast<std::uint16_t>(j);
    m += chosen[j];
  }
  for (std::size_t k = 0; k < m; ++k)
  {
    const float* p = position + 3 * list[k];
    to.insert(to.end(), p, p + 3);
  }
}
} // namespace

CloudSample::CloudSample(const float* position, std::size_t count, std::size_t most)
{
  std::uint32_t mask = 0;
  while (count * this->taken > most)
  {
    mask = mask << 1 | 1;
    this->taken /= 2;
  }
  Box all;
  this->chosen.resize(omp_get_max_threads());
  ParallelErrors errors;
#pragma omp parallel
  {
    Box box;
    std::vector<float> mine;
    errors.run([&] {
      mine.reserve(3 * static_cast<std::size_t>(count * this->taken / omp_get_num_threads()));
    });
    std::uint8_t marks[blockSize];
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < count; i += blockSize)
    {
      const std::size_t n = std::min(blockSize, count - i);
      survey(position + 3 * i, static_cast<std::uint32_t>(i), n, mask, box, marks);
      errors.run([&] { copyChosen(position + 3 * i, n, marks, mine); });
    }
#pragma omp critical
    all.add(box);
    this->chosen[omp_get_thread_num()] = std::move(mine);
  }
  errors.rethrow();
  for (int c = 0; c < 3; ++c)
  {
    this->low[c] = all.low[c];
    this->high[c] = all.high[c];
    this->longest = std::max(this->longest, double(all.high[c]) - all.low[c]);
  }
}

std::size_t CloudSample::size() const
{
  std::size_t size = 0;
  for (const std::vector<float>& piece : this->chosen)
  {
    size += piece.size() / 3;
  }
  return size;
}
} // namespace galaxy
