#include "Filters/Splatting/Tiles.h"

#include "Filters/Splatting/SplatBlock.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <memory>
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
    const auto first = static_cast<std::uint32_t>(band.firstTile);
    const auto width = static_cast<std::uint32_t>(band.lastTile - band.firstTile);
    std::uint16_t wanted[SplatBlock::most];
    for (std::size_t i = this->begin; i < this->end; i += SplatBlock::most)
    {
      const int size = this->sizeAt(i);
      const std::uint32_t* home = &this->dealer.home[i];
      int count = 0;
      for (int k = 0; k < size; ++k)
      {
        wanted[count] = static_cast<std::uint16_t>(k);
        count += home[k] - first < width || home[k] - isOdd < nowhere - isOdd;
      }
      const float* radius = this->dealer.projection.radii(i, size, this->scaledRadii);
      for (int k = 0; k < count; ++k)
      {
        this->places.set(k, this->dealer.projection.position(i + wanted[k]), radius[wanted[k]]);
      }
      projectBlock(this->places, count, this->dealer.camera, this->dealer.kernel, *this->block);
      for (int k = 0; k < count; ++k)
      {
        this->dealOne(i + wanted[k], k, home[wanted[k]], place, band, counts);
      }
    }
  }

private:
  int sizeAt(std::size_t i) const
  {
    return static_cast<int>(std::min<std::size_t>(SplatBlock::most, this->end - i));
  }

  /// Counts particle i in the tiles that it may touch, and says where it is.
  std::uint32_t countOne(std::size_t i, const BlockTiles& tiles, int k,
    std::vector<std::uint32_t>& counts, ProjectionCounts& absent) const
  {
    const std::uint32_t home = tiles.home[k];
    if (home == nowhere || (home != isOdd && !this->dealer.projection.visible(i)))
    {
      ++absent.culled;
      return nowhere;
    }
    if (home < isOdd)
    {
      ++counts[home];
      return home;
    }
    TileRange range = { tiles.column0[k], tiles.row0[k], tiles.column1[k], tiles.row1[k] };
    if (home == isOdd)
    {
      ProjectionCounts one;
      const PixelBox box = this->dealer.projection.classify(i, one);
      if (box.empty())
      {
        absent += one;
        return nowhere;
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

  void dealOne(std::size_t i, int k, std::uint32_t home, std::vector<std::size_t>& place,
    TileBand& band, ProjectionCounts& counts)
  {
    if (home < isOdd)
    {
      const int columns = this->dealer.tiles.columns;
      const auto tile = static_cast<int>(home);
      const SplatKind kind = this->light(i, k, counts, this->lit);
      this->write(k, tile % columns * tileSide, tile / columns * tileSide, kind,
        band.splats[place[tile - band.firstTile]++]);
      return;
    }
    const SplatBlock& b = *this->block;
    PixelBox box = { b.x0[k], b.y0[k], b.x1[k], b.y1[k] };
    if (home == isOdd)
    {
      ProjectionCounts known;
      box = this->dealer.projection.classify(i, known);
      this->dealer.projection.place(i, this->dealer.kernel, *this->block, k);
    }
    // A particle counts in the band that has its first tile.
    const TileRange range = TileRange::of(box);
    const int firstTile = range.row0 * this->dealer.tiles.columns + range.column0;
    ProjectionCounts ignored;
    const SplatKind kind = this->light(i, k, band.has(firstTile) ? counts : ignored, this->lit);
    this->forEachTile(range, [&](int tile, int left, int bottom) {
      if (band.has(tile))
      {
        this->write(k, left, bottom, kind, band.splats[place[tile - band.firstTile]++]);
      }
    });
  }

  /// Writes the splat as the tile with this left and lower pixel sees it.
  void write(int k, int left, int bottom, SplatKind kind, Splat& splat) const
  {
    const SplatBlock& b = *this->block;
    const int column = std::clamp(b.column[k] - left, -Splat::farPixel, Splat::farPixel);
    const int row = std::clamp(b.row[k] - bottom, -Splat::farPixel, Splat::farPixel);
    splat.where = Splat::pack(column, row, kind);
    splat.x = b.x[k] + static_cast<float>(b.column[k] - left - column);
    splat.y = b.y[k] + static_cast<float>(b.row[k] - bottom - row);
    splat.h = b.h[k];
    splat.depth = b.depth[k];
    splat.light[0] = this->lit[0];
    splat.light[1] = this->lit[1];
    splat.light[2] = this->lit[2];
  }

  /// The light over the pixel's area and what it does; none if the particle has no effect.
  SplatKind light(std::size_t i, int k, ProjectionCounts& counts, float* lit) const
  {
    const ParticleLight light = this->dealer.projection.light(i);
    const float perArea = this->block->perArea[k];
    const bool emits = light.emits(), absorbs = light.absorbs();
    const bool isValid = light.valid();
    // Luminosity per pixel area must stay finite in float.
    if (!isValid || !(emits || absorbs) || !(light.most() * perArea < 1e37F))
    {
      ++(isValid ? counts.culled : counts.invalid);
      std::fill_n(lit, 3, 0.0F);
      return SplatKind::Emits;
    }
    ++counts.drawn;
    counts.emitters += emits;
    for (int c = 0; c < 3; ++c)
    {
      lit[c] = (absorbs ? light.K[c] : light.L[c]) * perArea;
    }
    if (!absorbs)
    {
      return SplatKind::Emits;
    }
    ++counts.absorbers;
    counts.colored += !light.grey();
    if (!emits)
    {
      return SplatKind::Absorbs;
    }
    SlabName{ static_cast<std::uint32_t>(i), perArea }.write(lit);
    return SplatKind::Slab;
  }

  const TileDealer& dealer;
  std::size_t begin, end;
  std::unique_ptr<SplatBlock> block;
  BlockPlaces places = {};
  float scaledRadii[SplatBlock::most];
  float lit[3]; ///< of the particle that is dealt
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
  if (projection.size() > UINT32_MAX - 2)
  {
    throw Error("particles", "", "more than 2^32 - 3 in one rendering; render fewer at a time");
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
}

std::vector<int> TileDealer::bands(std::size_t bytes)
{
  std::vector<int> starts = { 0 };
  std::size_t inBand = 0;
  this->largestBand = 0;
  for (int tile = 0; tile < this->tiles.size(); ++tile)
  {
    if (inBand > 0 && (inBand + this->totals[tile]) * sizeof(Splat) > bytes)
    {
      starts.push_back(tile);
      inBand = 0;
    }
    inBand += this->totals[tile];
    this->largestBand = std::max(this->largestBand, inBand);
  }
  starts.push_back(this->tiles.size());
  return starts;
}

void TileDealer::deal(int firstTile, int lastTile, TileBand& band) const
{
  const int width = lastTile - firstTile;
  const std::size_t parts = this->counts.size();
  band.firstTile = firstTile;
  band.lastTile = lastTile;
  band.first.assign(width + 1, 0);
  band.counts = {};
  // Tile after tile, and in a tile share after share, which is the order of the particles' index.
  std::vector<std::vector<std::size_t>> places(parts, std::vector<std::size_t>(width));
  std::size_t sum = 0;
  for (int k = 0; k < width; ++k)
  {
    band.first[k] = sum;
    for (std::size_t part = 0; part < parts; ++part)
    {
      places[part][k] = sum;
      sum += this->counts[part][firstTile + k];
    }
  }
  band.first[width] = sum;
  if (band.splats.size() < sum)
  {
    band.splats = Buffer<Splat>(std::max(sum, this->largestBand));
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
