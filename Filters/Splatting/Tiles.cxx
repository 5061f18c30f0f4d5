#include "Filters/Splatting/Tiles.h"

#include "Filters/Splatting/SplatBlock.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
/// Tiles, the last ones included.
struct TileRange
{
  int column0, row0, column1, row1;
  static TileRange of(const PixelBox& box)
  {
    return { box.x0 / tileSide, box.y0 / tileSide, (box.x1 - 1) / tileSide,
      (box.y1 - 1) / tileSide };
  }
};

/// The particles that one of `parts` shares begins with, a multiple of the block's size.
std::size_t shareBegin(std::size_t size, std::size_t part, std::size_t parts)
{
  const std::size_t blocks = (size + SplatBlock::most - 1) / SplatBlock::most;
  return std::min(size, blocks * part / parts * SplatBlock::most);
}
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
    , lit(new LitBlock)
  {
  }

  void count(
    Buffer<std::uint32_t>& home, std::vector<std::uint32_t>& counts, ProjectionCounts& absent)
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
      locateBlock(this->places, size, this->dealer.camera, this->dealer.tiles.columns, *tiles);
      for (int k = 0; k < size; ++k)
      {
        home[i + k] = this->countOne(i + k, *tiles, k, counts, absent);
      }
    }
  }

  /// `place` says, for every tile of the band, where this share's next splat goes.
  void deal(std::vector<std::size_t>& place, TileBand& band, ProjectionCounts& counts)
  {
    const Projection& projection = this->dealer.projection;
    for (std::size_t i = this->begin; i < this->end; i += SplatBlock::most)
    {
      const int size = this->sizeAt(i);
      const std::uint32_t* home = &this->dealer.home[i];
      const int count = this->listWanted(home, size, band);
      if (count == 0)
      {
        continue;
      }
      const float* radius = projection.radii(i, size, this->scaledRadii);
      for (int k = 0; k < count; ++k)
      {
        const int j = this->wanted[k];
        this->places.set(k, projection.position(i + j), radius[j]);
      }
      projectBlock(this->places, count, this->dealer.camera, this->dealer.kernel, *this->block);
      projection.light(i, this->wanted, count, this->block->perArea, *this->lit);
      for (int k = 0; k < count; ++k)
      {
        const int j = this->wanted[k];
        TileHome::isOne(home[j])
          ? this->dealToOne(k, static_cast<int>(home[j]), place, band, counts)
          : this->dealToSeveral(i + j, k, home[j] == TileHome::odd, place, band, counts);
      }
    }
  }

private:
  int sizeAt(std::size_t i) const
  {
    return static_cast<int>(std::min<std::size_t>(SplatBlock::most, this->end - i));
  }

  /// Lists the particles of a block that the band may want; their number.
  int listWanted(const std::uint32_t* home, int size, const TileBand& band)
  {
    const auto first = static_cast<std::uint32_t>(band.firstTile);
    const auto width = static_cast<std::uint32_t>(band.lastTile - band.firstTile);
    const int row0 = this->firstRow(band), row1 = this->lastRow(band);
    int count = 0;
    for (int k = 0; k < size; ++k)
    {
      this->wanted[count] = static_cast<std::uint16_t>(k);
      const std::uint32_t h = home[k];
      const bool isHere = TileHome::isOne(h) ? h - first < width
        : h >= TileHome::odd                 ? h == TileHome::odd
                             : TileHome::row0(h) <= row1 && TileHome::row1(h) >= row0;
      count += isHere;
    }
    return count;
  }

  int firstRow(const TileBand& band) const { return band.firstTile / this->dealer.tiles.columns; }
  int lastRow(const TileBand& band) const
  {
    return (band.lastTile - 1) / this->dealer.tiles.columns;
  }

  /// Counts particle i in the tiles that it may touch, and says where it is.
  std::uint32_t countOne(std::size_t i, const BlockTiles& tiles, int k,
    std::vector<std::uint32_t>& counts, ProjectionCounts& absent) const
  {
    const std::uint32_t home = tiles.home[k];
    if (home == TileHome::nowhere || (home != TileHome::odd && !this->dealer.projection.visible(i)))
    {
      ++absent.culled;
      return TileHome::nowhere;
    }
    if (TileHome::isOne(home))
    {
      ++counts[home];
      return home;
    }
    TileRange range = { tiles.column0[k], tiles.row0[k], tiles.column1[k], tiles.row1[k] };
    if (home == TileHome::odd)
    {
      ProjectionCounts one;
      const PixelBox box = this->dealer.projection.classify(i, one);
      if (box.empty())
      {
        absent += one;
        return TileHome::nowhere;
      }
      range = TileRange::of(box);
    }
    this->forEachTile(range, [&](int tile, int, int) { ++counts[tile]; });
    return home;
  }

  /// Calls visit(tile, its left and lower pixel) for each tile of a range.
  template <typename Visit>
  void forEachTile(const TileRange& range, Visit visit) const
  {
    for (int row = range.row0; row <= range.row1; ++row)
    {
      for (int column = range.column0; column <= range.column1; ++column)
      {
        visit(row * this->dealer.tiles.columns + column, column * tileSide, row * tileSide);
      }
    }
  }

  /// The k-th particle of the block, all of it in one tile.
  void dealToOne(int k, int tile, std::vector<std::size_t>& place, TileBand& band,
    ProjectionCounts& counts) const
  {
    const int columns = this->dealer.tiles.columns;
    this->lit->count(k, counts);
    this->write(k, tile % columns * tileSide, tile / columns * tileSide,
      band.splats[place[tile - band.firstTile]++]);
  }

  void dealToSeveral(std::size_t i, int k, bool isOdd, std::vector<std::size_t>& place,
    TileBand& band, ProjectionCounts& counts)
  {
    const SplatBlock& b = *this->block;
    PixelBox box = { b.x0[k], b.y0[k], b.x1[k], b.y1[k] };
    if (isOdd)
    {
      ProjectionCounts known;
      box = this->dealer.projection.classify(i, known);
      this->dealer.projection.place(i, this->dealer.kernel, *this->block, k);
      this->dealer.projection.light(i, k, b.perArea[k], *this->lit);
    }
    TileRange range = TileRange::of(box);
    // A particle counts in the band that has its first tile.
    if (band.has(range.row0 * this->dealer.tiles.columns + range.column0))
    {
      this->lit->count(k, counts);
    }
    range.row0 = std::max(range.row0, this->firstRow(band));
    range.row1 = std::min(range.row1, this->lastRow(band));
    this->forEachTile(range, [&](int tile, int left, int bottom) {
      if (band.has(tile))
      {
        this->write(k, left, bottom, band.splats[place[tile - band.firstTile]++]);
      }
    });
  }

  /// Writes the splat as the tile with this left and lower pixel sees it.
  void write(int k, int left, int bottom, Splat& splat) const
  {
    const SplatBlock& b = *this->block;
    const int column = std::clamp(b.column[k] - left, -Splat::farPixel, Splat::farPixel);
    const int row = std::clamp(b.row[k] - bottom, -Splat::farPixel, Splat::farPixel);
    splat.where = Splat::pack(column, row, this->lit->kind[k]);
    splat.x = b.x[k] + static_cast<float>(b.column[k] - left - column);
    splat.y = b.y[k] + static_cast<float>(b.row[k] - bottom - row);
    splat.h = b.h[k];
    splat.depth = b.depth[k];
    splat.light[0] = this->lit->light[0][k];
    splat.light[1] = this->lit->light[1][k];
    splat.light[2] = this->lit->light[2][k];
    // Hundreds of tiles take turns: the line that this one's next splats will need can come until
    // then, where a store would wait for it.
    __builtin_prefetch(&splat + 4, 1);
  }

  const TileDealer& dealer;
  std::size_t begin, end;
  std::unique_ptr<SplatBlock> block;
  BlockPlaces places = {};
  float scaledRadii[SplatBlock::most];
  std::unique_ptr<LitBlock> lit;
  std::uint16_t wanted[SplatBlock::most];
};

TileDealer::TileDealer(const Projection& projection_, const Camera& camera_, Kernel kernel_)
  : projection(projection_)
  , camera(camera_)
  , kernel(kernel_)
  , tiles(camera_.width, camera_.height)
  , home(projection_.size())
  , counts(omp_get_max_threads(), std::vector<std::uint32_t>(this->tiles.size()))
  , totals(this->tiles.size())
{
  if (projection.size() > UINT32_MAX)
  {
    throw Error("particles", "", "more than 2^32 - 1 in one rendering; render fewer at a time");
  }
  const std::size_t parts = this->counts.size();
  std::vector<ProjectionCounts> absences(parts);
#pragma omp parallel for schedule(static, 1)
  for (std::size_t part = 0; part < parts; ++part)
  {
    Share(*this, part, parts).count(this->home, this->counts[part], absences[part]);
  }
  for (std::size_t part = 0; part < parts; ++part)
  {
    this->absent += absences[part];
    for (int tile = 0; tile < this->tiles.size(); ++tile)
    {
      this->totals[tile] += this->counts[part][tile];
    }
  }
  this->cutIntoBands();
}

void TileDealer::cutIntoBands()
{
  constexpr std::size_t bytesPerParticle = 16 - sizeof(std::uint32_t); // the rest has its home
  constexpr std::size_t fewestBytes = std::size_t(64) << 20;
  const std::size_t bytes = std::max(fewestBytes, bytesPerParticle * this->projection.size());
  this->starts = { 0 };
  std::size_t inBand = 0;
  for (int tile = 0; tile < this->tiles.size(); ++tile)
  {
    if (inBand > 0 && (inBand + this->totals[tile]) * sizeof(Splat) > bytes)
    {
      this->starts.push_back(tile);
      inBand = 0;
    }
    inBand += this->totals[tile];
    this->largestBand = std::max(this->largestBand, inBand);
  }
  this->starts.push_back(this->tiles.size());
}

std::size_t TileDealer::splats() const
{
  return std::accumulate(this->totals.begin(), this->totals.end(), std::size_t(0));
}

void TileDealer::deal(int k, TileBand& band) const
{
  const int firstTile = this->starts[k], lastTile = this->starts[k + 1];
  const int width = lastTile - firstTile;
  const std::size_t parts = this->counts.size();
  band.firstTile = firstTile;
  band.lastTile = lastTile;
  band.first.assign(width + 1, 0);
  band.counts = {};
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
  if (band.splats.size() < sum)
  {
    band.splats = Buffer<Splat>(this->largestBand);
  }
#pragma omp parallel for schedule(static, 1)
  for (std::size_t part = 0; part < parts; ++part)
  {
    ProjectionCounts counted;
    Share(*this, part, parts).deal(places[part], band, counted);
#pragma omp critical
    band.counts += counted;
  }
}
} // namespace galaxy
