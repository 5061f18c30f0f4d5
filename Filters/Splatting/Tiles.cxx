#include "Filters/Splatting/Tiles.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Splatting/SplatBlock.h"
#include "Readers/Formats/AvailableMemory.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
/// How much of a picture's time counting and dealing take, about; the rest is drawing.
constexpr double countingShare = 0.1;
constexpr double dealingShare = 0.35;

/// Beside the particles themselves: the splats of a band, and the home.
constexpr std::size_t bytesPerParticle = 16;
constexpr std::size_t bytesOfHome = sizeof(std::uint32_t);

/// The particles that one of `parts` shares begins with, a multiple of the block's size.
std::size_t shareBegin(std::size_t size, std::size_t part, std::size_t parts)
{
  const std::size_t blocks = (size + SplatBlock::most - 1) / SplatBlock::most;
  return std::min(size, blocks * part / parts * SplatBlock::most);
}

/// The nearest and the farthest, kpc.
struct DepthRange
{
  double nearest = std::numeric_limits<double>::infinity();
  double farthest = -std::numeric_limits<double>::infinity();
  void add(double depth)
  {
    this->nearest = std::min(this->nearest, depth);
    this->farthest = std::max(this->farthest, depth);
  }
};
} // namespace

/// One thread's share of the particles, which it counts or deals.
class TileDealer::Share
{
public:
  Share(const TileDealer& dealer, std::size_t part, std::size_t parts)
    : dealer(dealer)
    , begin(shareBegin(dealer.projection.size(), part, parts))
    , end(shareBegin(dealer.projection.size(), part + 1, parts))
    , block(new SplatBlock)
  {
  }

  void count(Buffer<std::uint32_t>& home, std::vector<std::uint32_t>& counts,
    std::vector<DepthRange>& depths, ParticleCounts& absent)
  {
    const std::unique_ptr<BlockTiles> tiles(new BlockTiles);
    for (std::size_t i = this->begin; i < this->end; i += SplatBlock::most)
    {
      const int size = this->sizeAt(i);
      const float* radius = this->dealer.projection.radii(i, size, this->scaledRadii);
      for (int k = 0; k < size; ++k)
      {
        this->places.set(k, this->dealer.projection.position(i + k), radius[k]);
      }
      locateBlock(this->places, size, this->dealer.projection.lens(), this->dealer.tiles, *tiles);
      for (int k = 0; k < size; ++k)
      {
        home[i + k] = this->countOne(i + k, *tiles, k, counts, depths, absent);
      }
      if (!this->dealer.progress.advance(size))
      {
        return;
      }
    }
  }

  /// The writer has a list for every tile of the band.
  void deal(SplatWriter& writer, const TileSpan& band, ParticleCounts& counts)
  {
    std::size_t next = this->begin;
    this->list(next, band, this->lists[0]);
    for (int turn = 0; next < this->end; turn ^= 1)
    {
      const std::size_t i = next;
      next = std::min(next + SplatBlock::most, this->end);
      // What is fetched now is there when it is its turn.
      this->list(next, band, this->lists[turn ^ 1]);
      this->deal(i, this->lists[turn], writer, band);
      if (!this->dealer.progress.advance(next - i))
      {
        return;
      }
    }
    this->count(counts);
  }
  float brightest() const { return this->mostLight; }

private:
  int sizeAt(std::size_t i) const
  {
    return static_cast<int>(std::min<std::size_t>(SplatBlock::most, this->end - i));
  }

  /// Particles of a block that have a splat in the band, by their numbers in it.
  struct List
  {
    int count = 0;
    std::uint32_t which[SplatBlock::most + 16];
  };

  void list(std::size_t i, const TileSpan& band, List& list) const
  {
    list.count =
      listInTiles(this->dealer.memory.home.data() + i, this->sizeAt(i), band, list.which);
    for (int k = 0; k < list.count; ++k)
    {
      this->dealer.projection.fetch(i + list.which[k]);
    }
  }

  void deal(std::size_t i, const List& list, SplatWriter& writer, const TileSpan& band)
  {
    const Projection& projection = this->dealer.projection;
    const float* radius = projection.radii(i, this->sizeAt(i), this->scaledRadii);
    for (int k = 0; k < list.count; ++k)
    {
      const std::uint32_t j = list.which[k];
      this->places.set(k, projection.position(i + j), radius[j]);
    }
    projection.light(i, list.which, list.count, this->lights);
    projectBlock(
      this->places, this->lights, list.count, projection.lens(), this->dealer.tiles, *this->block);
    this->mostLight = std::max(this->mostLight, this->block->brightest);
    for (int k = 0; k < list.count; ++k)
    {
      const std::uint32_t home = this->block->tiles.home[k];
      if (TileHome::isOne(home))
      {
        ++this->tally[static_cast<int>(this->block->fate[k])];
        Splat splat = this->block->splat(k);
        splat.depth = this->dealer.depths[home].stepOf(this->block->tiles.depth[k]);
        writer.write(static_cast<int>(home) - band.first, splat, this->lights.particle[k]);
      }
      else
      {
        this->dealToSeveral(k, writer, band);
      }
    }
  }

  /// Counts particle i in the tiles that it may touch, and says where it is.
  std::uint32_t countOne(std::size_t i, const BlockTiles& tiles, int k,
    std::vector<std::uint32_t>& counts, std::vector<DepthRange>& depths,
    ParticleCounts& absent) const
  {
    const std::uint32_t home = tiles.home[k];
    if (home == TileHome::invalid)
    {
      ++absent.invalid;
      return TileHome::nowhere;
    }
    if (home == TileHome::nowhere || !this->dealer.projection.visible(i))
    {
      ++absent.culled;
      return TileHome::nowhere;
    }
    if (TileHome::isOne(home))
    {
      ++counts[home];
      depths[home].add(tiles.depth[k]);
      return home;
    }
    const TileRange range = tiles.range(k);
    for (int row = range.row0; row <= range.row1; ++row)
    {
      for (int column = range.column0; column <= range.column1; ++column)
      {
        ++counts[row * this->dealer.tiles.columns + column];
        depths[row * this->dealer.tiles.columns + column].add(tiles.depth[k]);
      }
    }
    return home;
  }

  /// The k-th particle of the block, to each of its tiles that is in the band.
  void dealToSeveral(int k, SplatWriter& writer, const TileSpan& band)
  {
    const TileRange range = this->block->tiles.range(k);
    // A particle counts in the band that has its first tile.
    if (band.has(range.row0 * band.gridColumns + range.column0))
    {
      ++this->tally[static_cast<int>(this->block->fate[k])];
    }
    const Splat splat = this->block->splat(k);
    const int row1 = std::min(range.row1, band.lastRow());
    for (int row = std::max(range.row0, band.firstRow()); row <= row1; ++row)
    {
      for (int column = range.column0; column <= range.column1; ++column)
      {
        const int tile = row * band.gridColumns + column;
        if (band.has(tile))
        {
          Splat seen =
            splat.from((column - range.column0) * tileSide, (row - range.row0) * tileSide);
          seen.depth = this->dealer.depths[tile].stepOf(this->block->tiles.depth[k]);
          writer.write(tile - band.first, seen, this->lights.particle[k]);
        }
      }
    }
  }

  void count(ParticleCounts& counts) const
  {
    const auto of = [this](Fate fate) { return this->tally[static_cast<int>(fate)]; };
    const std::size_t colors = of(Fate::AbsorbsColors) + of(Fate::SlabColors);
    const std::size_t absorbers = colors + of(Fate::AbsorbsGrey) + of(Fate::SlabGrey);
    counts.drawn += of(Fate::Emits) + absorbers;
    counts.emitters += of(Fate::Emits) + of(Fate::SlabGrey) + of(Fate::SlabColors);
    counts.absorbers += absorbers;
    counts.colored += colors;
    counts.culled += of(Fate::Culled);
    counts.invalid += of(Fate::Invalid);
  }

  const TileDealer& dealer;
  std::size_t begin, end;
  std::unique_ptr<SplatBlock> block;
  BlockPlaces places = {};
  BlockLights lights;
  float scaledRadii[SplatBlock::most];
  List lists[2];
  float mostLight = 0;           ///< of a splat over a pixel's area
  std::size_t tally[fates] = {}; ///< particles by fate
};

TileDealer::TileDealer(Projection& projection_, RenderMemory& memory_, WorkProgress& progress_)
  : projection(projection_)
  , tiles(projection_.lens().camera().width, projection_.lens().camera().height)
  , memory(memory_)
  , progress(progress_)
  , counts(omp_get_max_threads(), std::vector<std::uint32_t>(this->tiles.size()))
  , totals(this->tiles.size())
  , depths(this->tiles.size())
{
  if (projection.size() > UINT32_MAX)
  {
    throw Error("particles", "", "more than 2^32 - 1 in one picture; hide some components");
  }
  if (this->memory.home.size() < projection.size())
  {
    requireMemory(double(bytesPerParticle) * double(projection.size()), "particles", "",
      "drawing " + std::to_string(projection.size()) + " of them",
      "use a smaller ParticleScale or hide some components");
    this->memory.home = Buffer<std::uint32_t>(projection.size());
  }
  this->progress.begin(countingShare, projection.size());
  const std::size_t parts = this->counts.size();
  std::vector<ParticleCounts> absences(parts);
  std::vector<std::vector<DepthRange>> ranges(parts, std::vector<DepthRange>(this->tiles.size()));
  parallelFor<std::size_t>(0, parts, [&](std::size_t part) {
    const std::unique_ptr<Share> share(new Share(*this, part, parts));
    share->count(this->memory.home, this->counts[part], ranges[part], absences[part]);
  });
  if (this->progress.isAborted())
  {
    this->starts = { 0 };
    return;
  }
  for (std::size_t part = 0; part < parts; ++part)
  {
    this->absent += absences[part];
    for (int tile = 0; tile < this->tiles.size(); ++tile)
    {
      this->totals[tile] += this->counts[part][tile];
    }
  }
  for (int tile = 0; tile < this->tiles.size(); ++tile)
  {
    DepthRange all;
    for (std::size_t part = 0; part < parts; ++part)
    {
      all.nearest = std::min(all.nearest, ranges[part][tile].nearest);
      all.farthest = std::max(all.farthest, ranges[part][tile].farthest);
    }
    this->depths[tile] = TileDepths(all.nearest, all.farthest);
  }
  this->sum = std::accumulate(this->totals.begin(), this->totals.end(), std::size_t(0));
  this->cutIntoBands();
}

void TileDealer::cutIntoBands()
{
  constexpr std::size_t bytesPerSplat = sizeof(Splat) + sizeof(std::uint32_t);
  constexpr std::size_t fewestBytes = std::size_t(64) << 20;
  const std::size_t bytes =
    std::max(fewestBytes, (bytesPerParticle - bytesOfHome) * this->projection.size());
  this->starts = { 0 };
  std::size_t inBand = 0;
  for (int tile = 0; tile < this->tiles.size(); ++tile)
  {
    if (inBand > 0 && (inBand + this->totals[tile]) * bytesPerSplat > bytes)
    {
      this->starts.push_back(tile);
      inBand = 0;
    }
    inBand += this->totals[tile];
    this->largestBand = std::max(this->largestBand, inBand);
  }
  this->starts.push_back(this->tiles.size());
}

const TileBand& TileDealer::deal(int k) const
{
  TileBand& band = this->memory.band;
  const int firstTile = this->starts[k], lastTile = this->starts[k + 1];
  const int width = lastTile - firstTile;
  const std::size_t parts = this->counts.size();
  band.firstTile = firstTile;
  band.lastTile = lastTile;
  band.first.assign(width + 1, 0);
  // Tile after tile, and in a tile share after share, which is the order of the particles' index.
  std::vector<std::vector<std::size_t>> places(parts, std::vector<std::size_t>(width));
  std::size_t sum = 0;
  for (int tile = 0; tile < width; ++tile)
  {
    band.first[tile] = sum;
    for (std::size_t part = 0; part < parts; ++part)
    {
      places[part][tile] = sum;
      sum += this->counts[part][firstTile + tile];
    }
  }
  band.first[width] = sum;
  if (sum > 0)
  {
    band.splats.reserve(this->largestBand);
  }
  const double share = double(sum) / double(std::max<std::size_t>(1, this->sum));
  this->progress.begin(dealingShare * share, this->projection.size());
  this->fill(band, places);
  if (!this->projection.holds(band.brightest, band.counts.emitters > 0) &&
    !this->progress.isAborted())
  {
    this->projection.fitLight();
    this->progress.begin(0, this->projection.size());
    this->fill(band, places);
  }
  this->progress.begin((1 - countingShare - dealingShare) * share, sum);
  return band;
}

/// `places` are where each share's splats of each tile begin.
void TileDealer::fill(TileBand& band, const std::vector<std::vector<std::size_t>>& places) const
{
  const std::size_t parts = this->counts.size();
  band.counts = {};
  band.brightest = 0;
  parallelFor<std::size_t>(0, parts, [&](std::size_t part) {
    ParticleCounts counted;
    SplatWriter writer(band.splats, places[part]);
    const std::unique_ptr<Share> share(new Share(*this, part, parts));
    share->deal(writer, { band.firstTile, band.lastTile, this->tiles.columns }, counted);
#pragma omp critical
    {
      band.counts += counted;
      band.brightest = std::max(band.brightest, share->brightest());
    }
  });
}
} // namespace galaxy
