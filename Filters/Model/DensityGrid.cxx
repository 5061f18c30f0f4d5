#include "Filters/Model/DensityGrid.h"

#include "Filters/Model/CellDistances.h"
#include "Filters/Model/CloudSample.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SameClones.h"
#include "Filters/Model/WorkProgress.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace galaxy
{
namespace
{
constexpr std::size_t mostCounted = 1 << 21;
constexpr std::size_t blockSize = 256;

// A place is three whole numbers of placeBits bits, of which a cell takes the next few.
constexpr int placeBits = 30;
constexpr std::int32_t lastPlace = (1 << placeBits) - 1;

// The word of a refined cell: the highest bit, three for `bits` of its cube, then first/8.
constexpr std::uint32_t refined = 1u << 31;
constexpr int bitsAt = 28;
constexpr std::uint32_t firstMask = (1u << bitsAt) - 1;

constexpr int mostRootBits = 5;
constexpr int mostBits = 5;
constexpr double perCell = 12; ///< particles that a cube is made for, on average over its cells
constexpr int refineAbove = 2; ///< times `neighbours`

std::size_t cellsOf(int bits)
{
  return std::size_t(1) << 3 * bits;
}

/// The bits of a cube that gives n particles about `perCell` a cell.
int bitsFor(double n, int most)
{
  return std::clamp<int>(std::lround(std::log2(std::max(n, 1.0) / perCell) / 3), 1, most);
}
} // namespace

/// A block of places and the cells they lie in.
struct CellPlaces
{
  std::size_t size;
  std::int32_t x[blockSize], y[blockSize], z[blockSize];
  std::uint32_t cell[blockSize];
  std::uint32_t word[blockSize]; ///< of the cell
  std::int32_t shift[blockSize]; ///< the cell's side is 2^shift
};

namespace
{
using Word = std::uint32_t;

GALAXY_SAME_CLONES
void toPlaces(const float* position, std::size_t n, const double* corner, double scale,
  std::int32_t* x, std::int32_t* y, std::int32_t* z)
{
  const auto place = [scale](float p, double corner) {
    const double u = (p - corner) * scale;
    const double notBelow = u > 0 ? u : 0; // nor not a number
    return static_cast<std::int32_t>(notBelow < lastPlace ? notBelow : lastPlace);
  };
#pragma omp simd
  for (std::size_t j = 0; j < n; ++j)
  {
    x[j] = place(position[3 * j], corner[0]);
    y[j] = place(position[3 * j + 1], corner[1]);
    z[j] = place(position[3 * j + 2], corner[2]);
  }
}

/// Goes down from the first cube to the leaves, all places one level at a time, without branches.
GALAXY_SAME_CLONES
void findLeaves(const Word* cells, int rootBits, CellPlaces& places)
{
  std::fill_n(places.word, places.size, refined | Word(rootBits) << bitsAt);
  std::fill_n(places.cell, places.size, 0);
  std::fill_n(places.shift, places.size, placeBits);
  Word left = refined;
  while (left & refined)
  {
    left = 0;
#pragma omp simd reduction(| : left)
    for (std::size_t j = 0; j < places.size; ++j)
    {
      const Word word = places.word[j];
      const std::int32_t bits = (word & refined) ? word >> bitsAt & 7 : 0;
      const std::int32_t shift = places.shift[j] - bits;
      const Word last = (1u << bits) - 1;
      const Word x = places.x[j] >> shift & last;
      const Word y = places.y[j] >> shift & last;
      const Word z = places.z[j] >> shift & last;
      const Word cell = 8 * (word & firstMask) + ((z << bits | y) << bits | x);
      places.shift[j] = shift;
      places.cell[j] = (word & refined) ? cell : places.cell[j];
      places.word[j] = cells[places.cell[j]];
      left |= places.word[j];
    }
  }
}

/// Moves each place at random within the cube as large as its cell, centred on it. The hash is that
/// of an eighth of the cell's side, which the last bits of a coordinate hardly ever change.
GALAXY_SAME_CLONES
void scatter(CellPlaces& places)
{
#pragma omp simd
  for (std::size_t j = 0; j < places.size; ++j)
  {
    const std::int32_t shift = places.shift[j];
    const auto coarse = [by = std::max(shift - 3, 0)](
                          std::int32_t place) { return Word(place >> by); };
    Word hash = coarse(places.x[j]) * 0x9e3779b1u ^ coarse(places.y[j]) * 0x85ebca77u ^
      coarse(places.z[j]) * 0xc2b2ae3du;
    hash = (hash ^ hash >> 15) * 0x2c1b3c6du;
    hash ^= hash >> 13;
    const auto moved = [shift](std::int32_t place, Word random) {
      const std::int32_t by = std::int32_t(random) >> 1 >> (31 - shift);
      return std::min(std::max(place + by, 0), lastPlace);
    };
    places.x[j] = moved(places.x[j], hash * 0x297a2d39u);
    places.y[j] = moved(places.y[j], hash * 0x5f356495u);
    places.z[j] = moved(places.z[j], hash * 0xb5297a4du);
  }
}
} // namespace

DensityGrid::DensityGrid(const float* position, std::size_t count, int neighbours)
  : neighbours(neighbours)
{
  const CloudSample sample(position, count, mostCounted);
  if (!(sample.side() > 0))
  {
    return;
  }
  // Round the cloud, in steps that no round number is at the end of: where the outermost particle
  // moves by the last bit of its coordinate, the cells stay.
  constexpr double odd = 1.6180339887498949;
  const double step = std::ldexp(1, std::ilogb(odd * sample.side()) - 12);
  double side = 0;
  for (int c = 0; c < 3; ++c)
  {
    this->corner[c] = step * (std::floor(sample.lowest()[c] / step - odd) + odd);
    side = std::max(
      side, step * (std::ceil((sample.highest()[c] - this->corner[c]) / step - odd) + odd));
  }
  this->scale = lastPlace / side;
  this->rootBits = bitsFor(sample.size(), mostRootBits);
  this->fresh = { { 0, this->rootBits, placeBits - this->rootBits } };
  this->cells.resize(cellsOf(this->rootBits));
  // Only of clumps upon clumps, such as many particles at each of a few places, there are more.
  const std::size_t mostCells = 3 * sample.size() + (1 << 16);
  while (!this->fresh.empty())
  {
    this->countFresh(sample);
    this->measureFresh(sample.share(), this->cells.size() <= mostCells);
    this->refine();
  }
}

void DensityGrid::locate(const float* position, std::size_t n, CellPlaces& places) const
{
  places.size = n;
  toPlaces(position, n, this->corner.data(), this->scale, places.x, places.y, places.z);
  findLeaves(this->cells.data(), this->rootBits, places);
}

void DensityGrid::countFresh(const CloudSample& sample)
{
  const std::size_t begin = this->fresh.front().first;
  const std::size_t size = this->cells.size() - begin;
  // Counts of each thread, for which a share of the sample's own memory is enough.
  const std::size_t affordable = 1 + sample.size() / size;
  const int threads = std::min<std::size_t>(affordable, omp_get_max_threads());
  // The first for those in older cells.
  std::vector<std::vector<std::uint32_t>> counts(threads, std::vector<std::uint32_t>(size + 1));
#pragma omp parallel num_threads(threads)
  {
    std::vector<std::uint32_t>& mine = counts[omp_get_thread_num()];
    CellPlaces places;
    for (const std::vector<float>& piece : sample.pieces())
    {
      const std::size_t count = piece.size() / 3;
#pragma omp for schedule(static) nowait
      for (std::size_t i = 0; i < count; i += blockSize)
      {
        this->locate(&piece[3 * i], std::min(blockSize, count - i), places);
        for (std::size_t j = 0; j < places.size; ++j)
        {
          ++mine[places.cell[j] < begin ? 0 : places.cell[j] - begin + 1];
        }
      }
    }
#pragma omp barrier
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < size; ++i)
    {
      for (const std::vector<std::uint32_t>& part : counts)
      {
        this->cells[begin + i] += part.empty() ? 0 : part[i + 1];
      }
    }
  }
}

void DensityGrid::measureFresh(double share, bool mayRefine)
{
  const double toAll = std::cbrt(share);
  const std::uint32_t most = refineAbove * this->neighbours;
  std::vector<CellDistances> spaces(omp_get_max_threads(), CellDistances(this->neighbours));
  parallelForDynamic<std::size_t>(0, this->fresh.size(), 16, [&](std::size_t k) {
    const Cube& cube = this->fresh[k];
    std::uint32_t* counts = &this->cells[cube.first];
    CellDistances& distances = spaces[omp_get_thread_num()];
    distances.compute(counts, cube.bits, std::ldexp(1 / this->scale, cube.shift));
    for (std::size_t i = 0; i < cellsOf(cube.bits); ++i)
    {
      if (mayRefine && cube.shift > 0 && counts[i] > most)
      {
        counts[i] |= refined;
        continue;
      }
      const float d = static_cast<float>(toAll * distances.distance(i));
      std::memcpy(counts + i, &d, sizeof(d));
    }
  });
}

void DensityGrid::refine()
{
  std::vector<Cube> parents;
  parents.swap(this->fresh);
  std::size_t end = this->cells.size();
  for (const Cube& parent : parents)
  {
    for (std::size_t i = parent.first; i < parent.first + cellsOf(parent.bits); ++i)
    {
      if (this->cells[i] & refined)
      {
        const int bits = bitsFor(this->cells[i] & ~refined, std::min(mostBits, parent.shift));
        this->cells[i] = refined | Word(bits) << bitsAt | Word(end / 8);
        this->fresh.push_back({ end, bits, parent.shift - bits });
        end += cellsOf(bits);
      }
    }
  }
  this->cells.resize(end);
}

void DensityGrid::blockDistances(const float* position, std::size_t n, float* d) const
{
  CellPlaces places;
  this->locate(position, n, places);
  scatter(places);
  findLeaves(this->cells.data(), this->rootBits, places);
  std::memcpy(d, places.word, n * sizeof(float));
}

void DensityGrid::meanDistances(
  const float* position, std::size_t count, float* d, const Progress& progress) const
{
  if (this->cells.empty())
  {
    std::fill_n(d, count, 0.0f);
    return;
  }
  WorkProgress work(progress);
  work.begin(1, count);
  parallelFor<std::size_t>(0, (count + blockSize - 1) / blockSize, [&](std::size_t block) {
    const std::size_t first = block * blockSize, n = std::min(blockSize, count - first);
    if (work.advance(n))
    {
      this->blockDistances(position + 3 * first, n, d + first);
    }
  });
  if (work.isAborted())
  {
    throw Aborted("particles", "", "their smoothing lengths were given up");
  }
}
} // namespace galaxy
