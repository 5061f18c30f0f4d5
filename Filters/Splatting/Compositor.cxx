#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/Picture.h"
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
/// One thread's memory, kept from tile to tile.
struct Workspace
{
  std::vector<KeyedSlot> order;
  std::vector<KeyedSlot> scratch;
  TileSums sums;
  double seconds[2] = { 0, 0 }; ///< sort, composite
  float thickest = 0;
};

/// What the splats of a tile are in sum.
struct TileSummary
{
  TileAbsorption absorption = TileAbsorption::None;
  float brightest = 0; ///< the largest luminosity of one over a pixel's area
  float thickest = 0;  ///< the largest optical depth of one

  void add(const Splat& splat, const SlabLight& light)
  {
    const auto [e, t] = std::pair(light.e, light.t);
    this->brightest = std::max({ this->brightest, e[0], e[1], e[2] });
    if (splat.kind() == SplatKind::Emits)
    {
      return;
    }
    const bool isGrey = t[0] == t[1] && t[1] == t[2];
    this->absorption =
      std::max(this->absorption, isGrey ? TileAbsorption::Grey : TileAbsorption::Color);
    // Through the middle of a Gaussian, or over the pixel that holds a small one.
    const float inPixel = std::min(1.0F, 2.865F / (splat.h * splat.h));
    this->thickest = std::max(this->thickest, std::max({ t[0], t[1], t[2] }) * inPixel);
  }
};

/// One rendering.
class Compositor
{
public:
  Compositor(const ParticleView& particles, const Camera& camera_, const RenderOptions& options_)
    : projection(particles, camera_)
    , camera(camera_)
    , grid(camera_.width, camera_.height)
    , options(options_)
  {
  }
  RenderedImage render();

private:
  void renderBands(RenderedImage& image);
  void renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image);
  void renderTile(const TileBand& band, int tile, Workspace& work, RenderedImage& image);
  TileTask taskOf(const TileBand& band, int tile, Workspace& work) const;
  bool proceed(std::size_t more);
  void loadOpaque(int tile, const TileTask& task, TileSums& sums) const;
  void store(int tile, const TileTask& task, const TileSums& sums, RenderedImage& image) const;

  Projection projection;
  Camera camera;
  TileGrid grid;
  const RenderOptions& options;
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
  RenderedImage image = emptyPicture(this->camera);
  if (!image.radiance.empty() && this->proceed(0))
  {
    this->renderBands(image);
  }
  finishPicture(this->counts, this->aborted, image);
  image.statistics.untouched = this->untouched;
  image.statistics.thickest = this->thickest;
  const char* names[] = { "count", "project", "sort", "composite" };
  for (int stage = 0; stage < 4; ++stage)
  {
    image.statistics.seconds.emplace_back(names[stage], this->seconds[stage]);
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
  RenderMemory own;
  const TileDealer dealer(
    this->projection, this->camera, this->options.memory ? *this->options.memory : own);
  this->seconds[0] = omp_get_wtime() - start;
  this->counts = dealer.missing();
  this->splats = dealer.splats();
  for (int k = 0; k < dealer.bands() && !this->aborted; ++k)
  {
    const double before = omp_get_wtime();
    const TileBand& band = dealer.deal(k);
    this->seconds[1] += omp_get_wtime() - before;
    this->counts += band.counts;
    this->renderBand(dealer, band, image);
  }
}

void Compositor::renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image)
{
  const double start = omp_get_wtime();
  std::vector<int> tiles(band.lastTile - band.firstTile);
  std::iota(tiles.begin(), tiles.end(), band.firstTile);
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
        this->renderTile(band, tiles[n], *work, image);
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

TileTask Compositor::taskOf(const TileBand& band, int tile, Workspace& work) const
{
  const int k = tile - band.firstTile;
  TileTask task;
  task.splats = band.splats.data() + band.first[k];
  task.count = band.first[k + 1] - band.first[k];
  task.kernel = this->options.kernel;
  task.hasOpaque = this->options.opaqueDepth != nullptr;
  task.negligible = static_cast<float>(this->options.negligible);
  task.projection = &this->projection;
  TileSummary summary;
  for (std::size_t slot = 0; slot < task.count; ++slot)
  {
    summary.add(task.splats[slot], this->projection.lightOf(task.splats[slot]));
  }
  task.absorption = summary.absorption;
  task.brightest = summary.brightest;
  work.thickest = std::max(work.thickest, summary.thickest);
  if (task.absorption != TileAbsorption::None)
  {
    work.order.resize(task.count);
    // Of equal depths the particle that comes first lies behind.
    for (std::size_t k = 0; k < task.count; ++k)
    {
      const std::size_t slot = task.count - 1 - k;
      work.order[k] =
        keyedSlot(nearFirstKey(task.splats[slot].depth), static_cast<std::uint32_t>(slot));
    }
    sortByKey(work.order.data(), work.order.data() + task.count, work.scratch);
    task.order = work.order.data();
  }
  return task;
}

void Compositor::renderTile(const TileBand& band, int tile, Workspace& work, RenderedImage& image)
{
  const double start = omp_get_wtime();
  TileTask task = this->taskOf(band, tile, work);
  task.pixels = this->grid.pixelsOf(tile);
  const double sorted = omp_get_wtime();
  work.sums.clear(task.absorption);
  if (task.hasOpaque)
  {
    this->loadOpaque(tile, task, work.sums);
  }
  this->untouched += task.count - compositeTile(task, work.sums);
  this->store(tile, task, work.sums, image);
  work.seconds[0] += sorted - start;
  work.seconds[1] += omp_get_wtime() - sorted;
}

void Compositor::loadOpaque(int tile, const TileTask& task, TileSums& sums) const
{
  const PixelBox& box = task.pixels;
  for (int y = box.y0; y < box.y1; ++y)
  {
    const std::size_t first = std::size_t(this->grid.bottomOf(tile) + y) * this->camera.width +
      (this->grid.leftOf(tile) + box.x0);
    std::copy_n(this->options.opaqueDepth + first, box.x1 - box.x0, sums.opaque[y] + box.x0);
  }
}

void Compositor::store(
  int tile, const TileTask& task, const TileSums& sums, RenderedImage& image) const
{
  const PixelBox& box = task.pixels;
  for (int y = box.y0; y < box.y1; ++y)
  {
    const std::size_t first = std::size_t(this->grid.bottomOf(tile) + y) * this->camera.width +
      (this->grid.leftOf(tile) + box.x0);
    for (int x = box.x0; x < box.x1; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t k = 3 * (first + x - box.x0) + c;
        const double light = sums.light.values[c][y][x];
        if (task.absorption == TileAbsorption::None)
        {
          image.radiance[k] = static_cast<float>(light);
          continue;
        }
        const int plane = task.absorption == TileAbsorption::Grey ? 0 : c;
        const double T = std::exp(-sums.tau.values[plane][y][x]);
        image.radiance[k] = static_cast<float>(sums.kept.values[c][y][x] + T * light);
        image.transmittance[k] = static_cast<float>(T);
      }
    }
  }
}
} // namespace

RenderedImage renderSorted(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  return Compositor(particles, camera, options).render();
}
} // namespace galaxy
