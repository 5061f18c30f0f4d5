#include "Filters/Splatting/ActiveEffects.h"
#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/TileComposite.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
/// Beside the particles a picture takes so many bytes for each of them, and no less than for many.
constexpr std::size_t bytesPerParticle = 12;
constexpr std::size_t fewestBytes = std::size_t(64) << 20;

/// One thread's memory, kept from tile to tile.
struct Workspace
{
  std::vector<KeyedSlot> order;
  std::vector<KeyedSlot> scratch;
  TileSums sums;
  double seconds[2] = { 0, 0 }; ///< sort, composite
  float thickest = 0;
};

/// Through the middle of a Gaussian, or over the pixel that holds a small one.
float opticalDepth(const Splat& splat, const float* t)
{
  return std::max({ t[0], t[1], t[2] }) * std::min(1.0F, 2.865F / (splat.h * splat.h));
}

/// One rendering.
class Compositor
{
public:
  Compositor(const ParticleView& particles, const Camera& camera_, const RenderOptions& options_)
    : projection(particles, camera_)
    , camera(camera_)
    , options(options_)
  {
  }
  RenderedImage render();

private:
  void renderBands(RenderedImage& image);
  void renderBand(const TileDealer& dealer, RenderedImage& image);
  void renderTile(int tile, const TileGrid& grid, Workspace& work, RenderedImage& image);
  TileTask taskOf(int tile, Workspace& work);
  bool proceed(std::size_t more);
  void loadOpaque(int left, int bottom, const TileTask& task, TileSums& sums) const;
  void store(
    int left, int bottom, const TileTask& task, const TileSums& sums, RenderedImage& image) const;
  void describe(RenderedImage& image) const;

  Projection projection;
  Camera camera;
  const RenderOptions& options;
  TileBand band;
  ProjectionCounts counts;
  std::size_t splats = 0; ///< of all tiles
  std::atomic<std::size_t> done{ 0 };
  std::atomic<std::size_t> untouched{ 0 };
  float thickest = 0;
  std::atomic<bool> aborted{ false };
  double seconds[4] = { 0, 0, 0, 0 }; ///< count, project, sort, composite
};

RenderedImage Compositor::render()
{
  RenderedImage image;
  image.width = this->camera.width;
  image.height = this->camera.height;
  const std::size_t values = 3 * std::size_t(image.width) * image.height;
  image.radiance.resize(values);
  image.transmittance.resize(values, 1.0f);
  if (values > 0 && this->proceed(0))
  {
    this->renderBands(image);
  }
  image.aborted = this->aborted;
  this->describe(image);
  if (image.aborted)
  {
    std::fill(image.radiance.begin(), image.radiance.end(), 0.0f);
    std::fill(image.transmittance.begin(), image.transmittance.end(), 1.0f);
  }
  return image;
}

/// Says that so many more splats are drawn; false when the picture is not wanted any more.
bool Compositor::proceed(std::size_t more)
{
  const std::size_t sum = this->done += more;
  if (omp_get_thread_num() == 0 && this->options.progress)
  {
    const double fraction = double(sum) / double(std::max<std::size_t>(1, this->splats));
    this->aborted = !this->options.progress(fraction);
  }
  return !this->aborted;
}

void Compositor::renderBands(RenderedImage& image)
{
  const double start = omp_get_wtime();
  TileDealer dealer(this->projection, this->camera, this->options.kernel);
  this->seconds[0] = omp_get_wtime() - start;
  this->counts = dealer.missing();
  for (int tile = 0; tile < dealer.grid().size(); ++tile)
  {
    this->splats += dealer.splatsOf(tile);
  }
  const std::vector<int> bands =
    dealer.bands(std::max(fewestBytes, bytesPerParticle * this->projection.size()));
  for (std::size_t k = 0; k + 1 < bands.size() && !this->aborted; ++k)
  {
    const double before = omp_get_wtime();
    dealer.deal(bands[k], bands[k + 1], this->band);
    this->seconds[1] += omp_get_wtime() - before;
    this->counts += this->band.counts;
    this->renderBand(dealer, image);
  }
}

void Compositor::renderBand(const TileDealer& dealer, RenderedImage& image)
{
  const double start = omp_get_wtime();
  std::vector<int> tiles(this->band.lastTile - this->band.firstTile);
  std::iota(tiles.begin(), tiles.end(), this->band.firstTile);
  // Those with the most splats first, so that no thread is left with a large one at the end.
  std::stable_sort(tiles.begin(), tiles.end(),
    [&](int a, int b) { return dealer.splatsOf(a) > dealer.splatsOf(b); });
  double seconds[2] = { 0, 0 };
#pragma omp parallel
  {
    const std::unique_ptr<Workspace> work(new Workspace); // its sums are cleared when used
#pragma omp for schedule(dynamic, 1)
    for (std::size_t n = 0; n < tiles.size(); ++n)
    {
      if (!this->aborted && dealer.splatsOf(tiles[n]) > 0)
      {
        this->renderTile(tiles[n], dealer.grid(), *work, image);
        this->proceed(dealer.splatsOf(tiles[n]));
      }
    }
#pragma omp critical
    {
      for (int stage = 0; stage < 2; ++stage)
      {
        seconds[stage] += work->seconds[stage];
      }
      this->thickest = std::max(this->thickest, work->thickest);
    }
  }
  // Threads' times are shared out so that the stages add up to what the clock on the wall says.
  const double sum = std::max(seconds[0] + seconds[1], 1e-9);
  const double wall = omp_get_wtime() - start;
  this->seconds[2] += seconds[0] / sum * wall;
  this->seconds[3] += seconds[1] / sum * wall;
}

TileTask Compositor::taskOf(int tile, Workspace& work)
{
  const int k = tile - this->band.firstTile;
  TileTask task;
  task.negligible = static_cast<float>(this->options.negligible);
  task.splats = this->band.splats.data() + this->band.first[k];
  task.count = this->band.first[k + 1] - this->band.first[k];
  task.kernel = this->options.kernel;
  task.hasOpaque = this->options.opaqueDepth != nullptr;
  task.slabLight = [this](const Splat& splat) {
    const SlabName name = SlabName::of(splat);
    const ParticleLight light = this->projection.light(name.particle);
    SlabLight slab;
    for (int c = 0; c < 3; ++c)
    {
      slab.e[c] = light.L[c] * name.perArea;
      slab.t[c] = light.K[c] * name.perArea;
    }
    return slab;
  };
  work.order.resize(task.count);
  bool absorbs = false, isColored = false;
  for (std::size_t slot = 0; slot < task.count; ++slot)
  {
    const Splat& splat = task.splats[slot];
    work.order[slot] = keyedSlot(farFirstKey(splat.depth), static_cast<std::uint32_t>(slot));
    if (splat.kind() == SplatKind::Absorbs)
    {
      absorbs = true;
      work.thickest = std::max(work.thickest, opticalDepth(splat, splat.light));
      isColored |= splat.light[0] != splat.light[1] || splat.light[1] != splat.light[2];
    }
    else if (splat.kind() == SplatKind::Emits)
    {
      task.brightest = std::max({ task.brightest, splat.light[0], splat.light[1], splat.light[2] });
    }
    else
    {
      const SlabLight slab = task.slabLight(splat);
      absorbs = true;
      work.thickest = std::max(work.thickest, opticalDepth(splat, slab.t));
      isColored |= slab.t[0] != slab.t[1] || slab.t[1] != slab.t[2];
      task.brightest = std::max({ task.brightest, slab.e[0], slab.e[1], slab.e[2] });
    }
  }
  task.absorption = !absorbs ? TileAbsorption::None
    : isColored              ? TileAbsorption::Color
                             : TileAbsorption::Grey;
  if (absorbs)
  {
    sortByKey(work.order, work.scratch);
    task.order = work.order.data();
  }
  return task;
}

void Compositor::renderTile(int tile, const TileGrid& grid, Workspace& work, RenderedImage& image)
{
  const int left = tile % grid.columns * tileSide, bottom = tile / grid.columns * tileSide;
  const double start = omp_get_wtime();
  TileTask task = this->taskOf(tile, work);
  task.columns = std::min(tileSide, this->camera.width - left);
  task.rows = std::min(tileSide, this->camera.height - bottom);
  const double sorted = omp_get_wtime();
  work.sums.clear(task.absorption);
  if (task.hasOpaque)
  {
    this->loadOpaque(left, bottom, task, work.sums);
  }
  this->untouched += task.count - compositeTile(task, work.sums);
  this->store(left, bottom, task, work.sums, image);
  work.seconds[0] += sorted - start;
  work.seconds[1] += omp_get_wtime() - sorted;
}

void Compositor::loadOpaque(int left, int bottom, const TileTask& task, TileSums& sums) const
{
  for (int y = 0; y < task.rows; ++y)
  {
    const std::size_t row = std::size_t(bottom + y) * this->camera.width + left;
    std::copy_n(this->options.opaqueDepth + row, task.columns, sums.opaque[y]);
  }
}

void Compositor::store(
  int left, int bottom, const TileTask& task, const TileSums& sums, RenderedImage& image) const
{
  for (int y = 0; y < task.rows; ++y)
  {
    const std::size_t row = std::size_t(bottom + y) * this->camera.width + left;
    for (int x = 0; x < task.columns; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t k = 3 * (row + x) + c;
        image.radiance[k] = static_cast<float>(sums.light.values[c][y][x]);
        if (task.absorption != TileAbsorption::None)
        {
          const int plane = task.absorption == TileAbsorption::Grey ? 0 : c;
          image.transmittance[k] = static_cast<float>(std::exp(-sums.tau.values[plane][y][x]));
        }
      }
    }
  }
}

void Compositor::describe(RenderedImage& image) const
{
  RenderStatistics& statistics = image.statistics;
  statistics.drawn = this->counts.drawn;
  statistics.culled = this->counts.culled;
  statistics.invalid = this->counts.invalid;
  statistics.absorbers = this->counts.absorbers;
  statistics.untouched = this->untouched;
  statistics.thickest = this->thickest;
  statistics.activeEffects = activeEffects(this->counts);
  const char* names[] = { "count", "project", "sort", "composite" };
  for (int stage = 0; stage < 4; ++stage)
  {
    statistics.seconds.emplace_back(names[stage], this->seconds[stage]);
  }
}
} // namespace

RenderedImage renderSorted(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  return Compositor(particles, camera, options).render();
}
} // namespace galaxy
