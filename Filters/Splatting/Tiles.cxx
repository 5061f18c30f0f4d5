#include "Filters/Splatting/Tiles.h"
#include "Readers/Formats/Error.h"

#include <omp.h>

namespace galaxy
{
namespace
{
/// Calls visit(tile) for each tile that the box of pixels touches.
template <typename Visit>
void forEachTile(const PixelBox& box, const TileGrid& grid, Visit visit)
{
  for (int row = box.y0 / tileHeight; row <= (box.y1 - 1) / tileHeight; ++row)
  {
    for (int column = box.x0 / tileWidth; column <= (box.x1 - 1) / tileWidth; ++column)
    {
      visit(row * grid.columns + column);
    }
  }
}

/// The particles that one of `parts` equal shares begins with.
std::size_t shareBegin(std::size_t size, std::size_t part, std::size_t parts)
{
  return size / parts * part + size % parts * part / parts;
}

/// Where a particle is listed, remembered from counting to listing.
constexpr std::uint32_t nowhere = UINT32_MAX;
constexpr std::uint32_t inSeveral = UINT32_MAX - 1;

/// The tile that holds all of a box, if one does.
std::uint32_t homeOf(const PixelBox& box, const TileGrid& grid)
{
  if (box.empty())
  {
    return nowhere;
  }
  const int row = box.y0 / tileHeight;
  const int column = box.x0 / tileWidth;
  const bool isOne = row == (box.y1 - 1) / tileHeight && column == (box.x1 - 1) / tileWidth;
  return isOne ? row * grid.columns + column : inSeveral;
}

/// Turns each share's counts per tile into where it writes its first particle of that tile: tile
/// after tile, and in a tile share after share, which is the order of the particles' index.
std::vector<std::size_t> firstPlaces(std::vector<std::vector<std::size_t>>& shares, int tiles)
{
  std::vector<std::size_t> first(tiles + 1);
  std::size_t sum = 0;
  for (int tile = 0; tile < tiles; ++tile)
  {
    first[tile] = sum;
    for (std::vector<std::size_t>& share : shares)
    {
      const std::size_t count = share[tile];
      share[tile] = sum;
      sum += count;
    }
  }
  first[tiles] = sum;
  return first;
}

/// One thread's share of the particles, which it counts and then lists.
class Share
{
public:
  Share(const Projection& projection_, const TileGrid& grid_, std::size_t part, std::size_t parts)
    : projection(projection_)
    , grid(grid_)
    , begin(shareBegin(projection_.size(), part, parts))
    , end(shareBegin(projection_.size(), part + 1, parts))
  {
  }

  std::vector<std::size_t> countByTile(Buffer<std::uint32_t>& home, ProjectionCounts& counts) const
  {
    std::vector<std::size_t> tileCounts(this->grid.size());
    ProjectionCounts mine;
    for (std::size_t i = this->begin; i < this->end; ++i)
    {
      const PixelBox box = this->projection.classify(i, mine);
      home[i] = homeOf(box, this->grid);
      if (home[i] < inSeveral)
      {
        ++tileCounts[home[i]];
      }
      else if (home[i] == inSeveral)
      {
        forEachTile(box, this->grid, [&](int tile) { ++tileCounts[tile]; });
      }
    }
    counts = mine;
    return tileCounts;
  }

  void list(const Buffer<std::uint32_t>& home, std::vector<std::size_t>& place,
    Buffer<std::uint32_t>& particles) const
  {
    ProjectionCounts ignored;
    for (std::size_t i = this->begin; i < this->end; ++i)
    {
      const auto append = [&](
                            int tile) { particles[place[tile]++] = static_cast<std::uint32_t>(i); };
      if (home[i] < inSeveral)
      {
        append(home[i]);
      }
      else if (home[i] == inSeveral)
      {
        forEachTile(this->projection.classify(i, ignored), this->grid, append);
      }
    }
  }

private:
  const Projection& projection;
  const TileGrid& grid;
  std::size_t begin, end;
};
} // namespace

TileLists listByTile(const Projection& projection, const TileGrid& grid)
{
  if (projection.size() > UINT32_MAX)
  {
    throw Error("particles", "", "more than 2^32 - 1 in one rendering; render fewer at a time");
  }
  const int parts = omp_get_max_threads();
  std::vector<std::vector<std::size_t>> places(parts);
  std::vector<ProjectionCounts> counts(parts);
  Buffer<std::uint32_t> home(projection.size());
#pragma omp parallel for schedule(static, 1)
  for (int part = 0; part < parts; ++part)
  {
    places[part] = Share(projection, grid, part, parts).countByTile(home, counts[part]);
  }
  TileLists lists;
  lists.first = firstPlaces(places, grid.size());
  lists.particles = Buffer<std::uint32_t>(lists.first.back());
#pragma omp parallel for schedule(static, 1)
  for (int part = 0; part < parts; ++part)
  {
    Share(projection, grid, part, parts).list(home, places[part], lists.particles);
  }
  for (const ProjectionCounts& part : counts)
  {
    lists.counts += part;
  }
  return lists;
}
} // namespace galaxy
