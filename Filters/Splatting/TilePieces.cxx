#include "Filters/Splatting/TilePieces.h"

#include "Filters/Model/ParallelFor.h"

#include <algorithm>
#include <array>

namespace galaxy
{
namespace
{
constexpr std::size_t mostPieces = 16;
constexpr std::size_t sampled = 4096;

/// Where pieces other than the first begin; such keys are a depth or a slot.
using Borders = std::vector<std::uint32_t>;

std::uint32_t keyOf(const TileTask& task, std::size_t slot, bool isOrdered)
{
  return isOrdered ? task.splats[slot].depth : static_cast<std::uint32_t>(slot);
}

/// Quantiles of a sample.
Borders bordersOf(const TileTask& task, bool isOrdered)
{
  std::vector<std::uint32_t> keys(sampled);
  for (std::size_t k = 0; k < sampled; ++k)
  {
    keys[k] = keyOf(task, task.count * k / sampled, isOrdered);
  }
  std::sort(keys.begin(), keys.end());
  const std::size_t pieces =
    std::clamp<std::size_t>(2 * task.count / TilePieces::fewestSplats, 1, mostPieces);
  Borders borders;
  for (std::size_t piece = 1; piece < pieces; ++piece)
  {
    borders.push_back(keys[sampled * piece / pieces]);
  }
  return borders;
}

/// The splats of a chunk of slots by their pieces, from the last slot to the first.
class Chunk
{
public:
  Chunk(const TileTask& task, const Omission& omission, bool isOrdered, const Borders& borders)
    : task(task)
    , omission(omission)
    , isOrdered(isOrdered)
    , borders(borders)
  {
  }

  /// Calls put(piece, slot).
  template <class Put>
  void forEach(std::size_t chunk, Put put) const
  {
    const std::size_t begin = chunk * size;
    for (std::size_t slot = std::min(begin + size, this->task.count); slot-- > begin;)
    {
      if (this->omission.omits() && this->omission.omits(this->task.splats[slot], this->task))
      {
        continue;
      }
      const std::uint32_t key = keyOf(this->task, slot, this->isOrdered);
      int piece = 0;
      for (const std::uint32_t border : this->borders)
      {
        piece += key >= border;
      }
      put(piece, slot);
    }
  }
  std::size_t chunks() const { return (this->task.count + size - 1) / size; }

private:
  static constexpr std::size_t size = std::size_t(1) << 16;
  const TileTask& task;
  const Omission& omission;
  bool isOrdered;
  const Borders& borders;
};
} // namespace

TilePieces::TilePieces(const TileTask& task, const Omission& omission, bool isOrdered)
{
  const Borders borders = bordersOf(task, isOrdered);
  const std::size_t pieces = borders.size() + 1;
  const Chunk chunk(task, omission, isOrdered, borders);
  const std::size_t chunks = chunk.chunks();
  std::vector<std::array<std::size_t, mostPieces>> places(chunks);
  parallelForDynamic<std::size_t>(0, chunks, 1, [&](std::size_t c) {
    places[c].fill(0);
    chunk.forEach(c, [&](int piece, std::size_t) { ++places[c][piece]; });
  });
  std::size_t sum = 0;
  for (std::size_t piece = 0; piece < pieces; ++piece)
  {
    this->first.push_back(sum);
    for (std::size_t c = chunks; c-- > 0;)
    {
      const std::size_t count = places[c][piece];
      places[c][piece] = sum;
      sum += count;
    }
  }
  this->first.push_back(sum);
  this->left = task.count - sum;
  this->slots.resize(sum);
  parallelForDynamic<std::size_t>(0, chunks, 1, [&](std::size_t c) {
    chunk.forEach(c, [&](int piece, std::size_t slot) {
      this->slots[places[c][piece]++] =
        keyedSlot(task.splats[slot].depth, static_cast<std::uint32_t>(slot));
    });
  });
}
} // namespace galaxy
