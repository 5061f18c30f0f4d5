#include "Filters/Splatting/ActiveEffects.h"
#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/TileImage.h"

#include <atomic>
#include <memory>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
template <bool hasOpaque, class Footprint>
GALAXY_INLINE void compositeAll(const std::vector<Splat>& splats,
  const std::vector<KeyedSlot>& order, Footprint& footprint, TileImage& tile)
{
  constexpr std::size_t ahead = 8;
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    __builtin_prefetch(&splats[slotOf(order[std::min(k + ahead, order.size() - 1)])]);
    const Splat& splat = splats[slotOf(order[k])];
    if (!footprint.prepare(splat))
    {
      continue;
    }
    if (splat.absorbs())
    {
      tile.template absorb<hasOpaque>(splat, footprint);
    }
    else
    {
      tile.template emit<hasOpaque>(splat, footprint);
    }
  }
  tile.flush();
}

/// The inner loops, one clone per instruction set. `order` is from the farthest to the nearest.
GALAXY_CLONES void composite(const std::vector<Splat>& splats, const std::vector<KeyedSlot>& order,
  GaussianFootprint& footprint, bool hasOpaque, TileImage& tile)
{
  hasOpaque ? compositeAll<true>(splats, order, footprint, tile)
            : compositeAll<false>(splats, order, footprint, tile);
}

GALAXY_CLONES void composite(const std::vector<Splat>& splats, const std::vector<KeyedSlot>& order,
  SplineFootprint& footprint, bool hasOpaque, TileImage& tile)
{
  hasOpaque ? compositeAll<true>(splats, order, footprint, tile)
            : compositeAll<false>(splats, order, footprint, tile);
}

/// One thread's memory, kept from tile to tile.
struct Workspace
{
  std::vector<Splat> splats;
  std::vector<KeyedSlot> order;
  std::vector<KeyedSlot> scratch;
  TileImage tile;
  GaussianFootprint gaussian;
  SplineFootprint spline;
  double seconds[3] = { 0, 0, 0 }; ///< gather, sort, composite
};

/// One rendering.
class Compositor
{
public:
  Compositor(const ParticleView& particles, const Camera& camera_, const RenderOptions& options_)
    : projection(particles, camera_)
    , camera(camera_)
    , options(options_)
    , grid(camera_.width, camera_.height)
  {
  }
  RenderedImage render();

private:
  void renderTiles(RenderedImage& image);
  void renderTile(int k, Workspace& work, RenderedImage& image) const;
  void gather(int k, Workspace& work) const;
  void loadOpaque(int k, TileImage& tile) const;
  void store(int k, const TileImage& tile, RenderedImage& image) const;
  void describe(RenderedImage& image) const;
  std::vector<int> busiestFirst() const;
  int left(int k) const { return k % this->grid.columns * tileWidth; }
  int bottom(int k) const { return k / this->grid.columns * tileHeight; }
  int columns(int k) const { return std::min(tileWidth, this->camera.width - this->left(k)); }
  int rows(int k) const { return std::min(tileHeight, this->camera.height - this->bottom(k)); }

  Projection projection;
  Camera camera;
  const RenderOptions& options;
  TileGrid grid;
  TileLists lists;
};

RenderedImage Compositor::render()
{
  RenderedImage image;
  image.width = this->camera.width;
  image.height = this->camera.height;
  const std::size_t values = 3 * std::size_t(image.width) * image.height;
  image.radiance.resize(values);
  image.transmittance.resize(values, 1.0f);
  image.aborted = this->options.progress && !this->options.progress(0);
  if (!image.aborted)
  {
    const double start = omp_get_wtime();
    this->lists = listByTile(this->projection, this->grid);
    image.statistics.seconds.emplace_back("list by tile", omp_get_wtime() - start);
    this->renderTiles(image);
  }
  this->describe(image);
  if (image.aborted)
  {
    std::fill(image.radiance.begin(), image.radiance.end(), 0.0f);
    std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0f);
  }
  return image;
}

std::vector<int> Compositor::busiestFirst() const
{
  std::vector<int> tiles(this->grid.size());
  std::iota(tiles.begin(), tiles.end(), 0);
  const auto& first = this->lists.first;
  std::stable_sort(tiles.begin(), tiles.end(),
    [&](int a, int b) { return first[a + 1] - first[a] > first[b + 1] - first[b]; });
  return tiles;
}

void Compositor::renderTiles(RenderedImage& image)
{
  const std::vector<int> tiles = this->busiestFirst();
  const double start = omp_get_wtime();
  double seconds[3] = { 0, 0, 0 };
  std::atomic<std::size_t> done{ 0 };
  std::atomic<bool> aborted{ false };
#pragma omp parallel
  {
    const std::unique_ptr<Workspace> work(new Workspace); // its tile is cleared when used
#pragma omp for schedule(dynamic, 1)
    for (int n = 0; n < this->grid.size(); ++n)
    {
      if (aborted)
      {
        continue;
      }
      const int k = tiles[n];
      this->renderTile(k, *work, image);
      done += this->lists.first[k + 1] - this->lists.first[k];
      if (omp_get_thread_num() == 0 && this->options.progress)
      {
        aborted =
          !this->options.progress(double(done) / std::max<double>(1, this->lists.first.back()));
      }
    }
#pragma omp critical
    for (int stage = 0; stage < 3; ++stage)
    {
      seconds[stage] += work->seconds[stage];
    }
  }
  image.aborted = aborted;
  // Threads' times are shared out so that the stages add up to what the clock on the wall says.
  const double sum = std::max(seconds[0] + seconds[1] + seconds[2], 1e-9);
  const double wall = omp_get_wtime() - start;
  const char* names[] = { "project", "sort", "composite" };
  for (int stage = 0; stage < 3; ++stage)
  {
    image.statistics.seconds.emplace_back(names[stage], seconds[stage] / sum * wall);
  }
}

void Compositor::renderTile(int k, Workspace& work, RenderedImage& image) const
{
  if (this->lists.first[k] == this->lists.first[k + 1])
  {
    return;
  }
  const double start = omp_get_wtime();
  this->gather(k, work);
  const double gathered = omp_get_wtime();
  if (this->lists.counts.absorbers > 0)
  {
    sortByKey(work.order, work.scratch);
  }
  const double sorted = omp_get_wtime();
  work.tile.clear();
  const bool hasOpaque = this->options.opaqueDepth != nullptr;
  if (hasOpaque)
  {
    this->loadOpaque(k, work.tile);
  }
  if (this->options.kernel == Kernel::Gaussian)
  {
    composite(work.splats, work.order, work.gaussian, hasOpaque, work.tile);
  }
  else
  {
    composite(work.splats, work.order, work.spline, hasOpaque, work.tile);
  }
  this->store(k, work.tile, image);
  work.seconds[0] += gathered - start;
  work.seconds[1] += sorted - gathered;
  work.seconds[2] += omp_get_wtime() - sorted;
}

void Compositor::gather(int k, Workspace& work) const
{
  const std::uint32_t* particles = this->lists.particles.data() + this->lists.first[k];
  const std::size_t count = this->lists.first[k + 1] - this->lists.first[k];
  work.splats.resize(count);
  work.order.resize(count);
  constexpr std::size_t ahead = 24; // particles of a tile lie far apart in memory
  for (std::size_t slot = 0; slot < count; ++slot)
  {
    this->projection.prefetch(particles[std::min(slot + ahead, count - 1)]);
    const Splat splat = this->projection.splat(particles[slot], this->left(k), this->bottom(k));
    work.splats[slot] = splat;
    work.order[slot] = keyedSlot(farFirstKey(splat.depth), static_cast<std::uint32_t>(slot));
  }
}

void Compositor::loadOpaque(int k, TileImage& tile) const
{
  for (int y = 0; y < this->rows(k); ++y)
  {
    const std::size_t row = std::size_t(this->bottom(k) + y) * this->camera.width + this->left(k);
    for (int x = 0; x < 3 * this->columns(k); ++x)
    {
      tile.opaque[y][x] = this->options.opaqueDepth[row + x / 3];
    }
  }
}

void Compositor::store(int k, const TileImage& tile, RenderedImage& image) const
{
  const bool absorbs = this->lists.counts.absorbers > 0;
  for (int y = 0; y < this->rows(k); ++y)
  {
    const std::size_t row = std::size_t(this->bottom(k) + y) * this->camera.width + this->left(k);
    for (int x = 0; x < 3 * this->columns(k); ++x)
    {
      image.radiance[3 * row + x] = static_cast<float>(tile.light[y][x]);
      if (absorbs)
      {
        image.transmittance[3 * row + x] = static_cast<float>(std::exp(-tile.tau[y][x]));
      }
    }
  }
}

void Compositor::describe(RenderedImage& image) const
{
  const ProjectionCounts& counts = this->lists.counts;
  image.statistics.drawn = counts.drawn;
  image.statistics.culled = counts.culled;
  image.statistics.invalid = counts.invalid;
  image.statistics.absorbers = counts.absorbers;
  image.statistics.activeEffects = activeEffects(counts);
}
} // namespace

RenderedImage renderSorted(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  return Compositor(particles, camera, options).render();
}
} // namespace galaxy
