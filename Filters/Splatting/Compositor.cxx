#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/WorkProgress.h"
#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/SpreadAbsorbers.h"
#include "Filters/Splatting/TileComposite.h"
#include "Filters/Splatting/TileOrder.h"
#include "Filters/Splatting/TilePieces.h"
#include "Filters/Splatting/TileSummary.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
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
  std::size_t untouched = 0, faint = 0, tooBright = 0;
  OrderNeeds tiles;
  ErrorBound bound;
};

/// How a tile is drawn.
struct TilePlan
{
  TileTask task; ///< of all splats
  Omission omission;
  bool isOrdered = false;
};

/// One rendering.
class Compositor
{
public:
  Compositor(const ParticleView& particles, const Camera& camera_, const RenderOptions& options_,
    const ErrorBound& allowed)
    : projection(particles, { camera_, options_.kernel })
    , camera(camera_)
    , grid(camera_.width, camera_.height)
    , options(options_)
    , allowed(allowed)
    , progress(options_.progress)
  {
  }
  RenderedImage render();

private:
  void renderBands(RenderedImage& image);
  void renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image);
  void renderTile(const TileBand& band, int tile, Workspace& work, RenderedImage& image);
  void renderInPieces(const TileBand& band, int tile,
    std::vector<std::unique_ptr<Workspace>>& works, RenderedImage& image);
  TilePlan planOf(const TileBand& band, int tile, Workspace& work) const;
  void list(TileTask& task, const Omission& omission, Workspace& work) const;
  void draw(int tile, const TileTask& task, Workspace& work) const;
  void add(const std::vector<std::unique_ptr<Workspace>>& works);
  void loadOpaque(int tile, const PixelBox& box, TileSums& sums) const;
  void store(int tile, const TileTask& task, const TileLight& sums, Workspace& work,
    RenderedImage& image) const;

  Projection projection;
  Camera camera;
  TileGrid grid;
  const RenderOptions& options;
  ErrorBound allowed;
  ParticleCounts counts;
  std::size_t untouched = 0, faint = 0, tooBright = 0;
  OrderNeeds tiles;
  ErrorBound bound;
  float thickest = 0;
  WorkProgress progress;
  double seconds[4] = { 0, 0, 0, 0 }; ///< count, project, sort, composite
};

RenderedImage Compositor::render()
{
  RenderedImage image = emptyPicture(this->camera);
  if (!image.radiance.empty() && !this->progress.isAborted())
  {
    this->renderBands(image);
  }
  finishPicture(this->counts, this->tiles, this->progress.isAborted(), image);
  image.statistics.untouched = this->untouched;
  image.statistics.thickest = this->thickest;
  image.statistics.faint = this->faint;
  image.statistics.tooBright = this->tooBright;
  image.statistics.bound = this->bound;
  const char* names[] = { "count", "project", "sort", "composite" };
  for (int stage = 0; stage < 4; ++stage)
  {
    image.statistics.seconds.emplace_back(names[stage], this->seconds[stage]);
  }
  return image;
}

void Compositor::renderBands(RenderedImage& image)
{
  const double start = omp_get_wtime();
  RenderMemory own;
  const TileDealer dealer(
    this->projection, this->options.memory ? *this->options.memory : own, this->progress);
  this->seconds[0] = omp_get_wtime() - start;
  this->counts = dealer.missing();
  for (int k = 0; k < dealer.bands(); ++k)
  {
    const double before = omp_get_wtime();
    const TileBand& band = dealer.deal(k);
    this->seconds[1] += omp_get_wtime() - before;
    this->counts += band.counts;
    if (this->progress.isAborted())
    {
      return;
    }
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
  const auto isLarge = [&](int tile) { return dealer.splatsOf(tile) >= TilePieces::fewestSplats; };
  const auto small = std::find_if_not(tiles.begin(), tiles.end(), isLarge);
  std::vector<std::unique_ptr<Workspace>> works(omp_get_max_threads());
  for (auto& work : works)
  {
    work.reset(new Workspace); // its sums are cleared when used
  }
  for (auto tile = tiles.begin(); tile != small && !this->progress.isAborted(); ++tile)
  {
    this->renderInPieces(band, *tile, works, image);
  }
  parallelForDynamic(small, tiles.end(), 1, [&](auto tile) {
    if (!this->progress.isAborted() && dealer.splatsOf(*tile) > 0)
    {
      this->renderTile(band, *tile, *works[omp_get_thread_num()], image);
      this->progress.advance(dealer.splatsOf(*tile));
    }
  });
  // Threads' times are shared out so that the stages add up to what the clock on the wall says.
  double seconds[2] = { 0, 0 };
  for (const auto& work : works)
  {
    seconds[0] += work->seconds[0];
    seconds[1] += work->seconds[1];
  }
  const double sum = std::max(seconds[0] + seconds[1], 1e-9);
  const double wall = omp_get_wtime() - start;
  this->seconds[2] += seconds[0] / sum * wall;
  this->seconds[3] += seconds[1] / sum * wall;
  this->add(works);
}

void Compositor::add(const std::vector<std::unique_ptr<Workspace>>& works)
{
  for (const auto& work : works)
  {
    this->thickest = std::max(this->thickest, work->thickest);
    this->untouched += work->untouched;
    this->faint += work->faint;
    this->tooBright += work->tooBright;
    this->tiles += work->tiles;
    this->bound.light = std::max(this->bound.light, work->bound.light);
    this->bound.share = std::max(this->bound.share, work->bound.share);
  }
}

TilePlan Compositor::planOf(const TileBand& band, int tile, Workspace& work) const
{
  const int k = tile - band.firstTile;
  TilePlan plan;
  TileTask& task = plan.task;
  task.splats = band.splats.data() + band.first[k];
  task.particles = band.splats.particles() + band.first[k];
  task.count = band.first[k + 1] - band.first[k];
  task.pixels = this->grid.pixelsOf(tile);
  task.left = this->grid.leftOf(tile);
  task.bottom = this->grid.bottomOf(tile);
  task.kernel = this->options.kernel;
  task.hasOpaque = this->options.opaqueDepth != nullptr;
  task.projection = &this->projection;
  const bool isBounded = this->allowed.light > 0 || this->allowed.share > 0;
  const TileSummary summary(task, isBounded);
  task.absorption = summary.absorption;
  task.brightest = summary.brightest;
  // As splats' light is counted.
  const ErrorBound allowed = { this->allowed.light / this->projection.splatUnit(),
    this->allowed.share };
  task.negligible =
    static_cast<float>(std::min<double>(allowed.light / 2, std::numeric_limits<float>::max()));
  task.opaque = static_cast<float>(this->allowed.share / 2);
  plan.omission = summary.omission(allowed);
  plan.omission.bound.light *= this->projection.splatUnit();
  const bool absorbs = summary.absorption != TileAbsorption::None;
  task.isOneSource = absorbs && summary.source.holds();
  plan.isOrdered = absorbs && plan.omission.isOrdered && !task.isOneSource;
  for (int c = 0; c < 3; ++c)
  {
    task.source[c] = summary.source.source(c);
  }
  work.thickest = std::max(work.thickest, summary.thickest);
  work.tiles.ordered += plan.isOrdered;
  work.tiles.oneSource += task.isOneSource;
  work.tiles.thin += absorbs && !plan.isOrdered && !task.isOneSource;
  work.bound.light = std::max(work.bound.light, plan.omission.bound.light);
  work.bound.share = std::max(work.bound.share, plan.omission.bound.share);
  return plan;
}

/// Lists the splats that are not left out, ready to be sorted.
void Compositor::list(TileTask& task, const Omission& omission, Workspace& work) const
{
  work.order.resize(task.count);
  std::size_t listed = 0;
  // Of equal depths the particle that comes first lies behind.
  for (std::size_t slot = task.count; slot-- > 0;)
  {
    const Splat& splat = task.splats[slot];
    work.order[listed] = keyedSlot(splat.depth, static_cast<std::uint32_t>(slot));
    listed += !omission.omits() || !omission.omits(splat, task);
  }
  work.faint += task.count - listed;
  task.count = listed;
  task.order = work.order.data();
}

void Compositor::renderTile(const TileBand& band, int tile, Workspace& work, RenderedImage& image)
{
  const double start = omp_get_wtime();
  TilePlan plan = this->planOf(band, tile, work);
  TileTask& task = plan.task;
  if (plan.isOrdered || plan.omission.omits())
  {
    this->list(task, plan.omission, work);
  }
  if (plan.isOrdered)
  {
    sortByKey(work.order.data(), work.order.data() + task.count, work.scratch);
    orderTies(work.order.data(), work.order.data() + task.count, task);
  }
  work.seconds[0] += omp_get_wtime() - start;
  this->draw(tile, task, work);
  this->store(tile, task, work.sums.all, work, image);
}

/// Draws to the sums.
void Compositor::draw(int tile, const TileTask& task, Workspace& work) const
{
  const double start = omp_get_wtime();
  work.sums.clear(task.isOneSource ? TileAbsorption::None : task.absorption);
  if (task.hasOpaque)
  {
    this->loadOpaque(tile, task.pixels, work.sums);
  }
  work.untouched += task.count - compositeTile(task, work.sums);
  work.seconds[1] += omp_get_wtime() - start;
}

/// The same by all threads together, one piece each.
void Compositor::renderInPieces(const TileBand& band, int tile,
  std::vector<std::unique_ptr<Workspace>>& works, RenderedImage& image)
{
  const double start = omp_get_wtime();
  const TilePlan plan = this->planOf(band, tile, *works[0]);
  TilePieces pieces(plan.task, plan.omission, plan.isOrdered);
  works[0]->faint += pieces.omitted();
  works[0]->seconds[0] += (omp_get_wtime() - start) * double(works.size());
  std::vector<std::unique_ptr<TileLight>> lights(pieces.size());
  parallelForDynamic<int>(0, pieces.size(), 1, [&](int k) {
    if (this->progress.isAborted())
    {
      return;
    }
    Workspace& work = *works[omp_get_thread_num()];
    const double before = omp_get_wtime();
    if (plan.isOrdered)
    {
      sortByKey(pieces.begin(k), pieces.end(k), work.scratch);
      orderTies(pieces.begin(k), pieces.end(k), plan.task);
    }
    work.seconds[0] += omp_get_wtime() - before;
    TileTask task = plan.task;
    task.order = pieces.begin(k);
    task.count = pieces.end(k) - pieces.begin(k);
    // What all of them leave out is what one tile may.
    task.negligible /= static_cast<float>(pieces.size());
    task.opaque /= static_cast<float>(pieces.size());
    this->draw(tile, task, work);
    lights[k].reset(new TileLight(work.sums.all));
    this->progress.advance(pieces.end(k) - pieces.begin(k));
  });
  if (!this->progress.isAborted())
  {
    for (int k = 1; k < pieces.size(); ++k)
    {
      lights[0]->add(
        *lights[k], plan.task.isOneSource ? TileAbsorption::None : plan.task.absorption);
    }
    this->store(tile, plan.task, *lights[0], *works[0], image);
  }
}

void Compositor::loadOpaque(int tile, const PixelBox& box, TileSums& sums) const
{
  for (int y = box.y0; y < box.y1; ++y)
  {
    const std::size_t row = std::size_t(this->grid.bottomOf(tile) + y) * this->camera.width;
    for (int x = box.x0; x < box.x1; ++x)
    {
      sums.opaque[y][x] = this->options.opaqueDepth[row + this->grid.leftOf(tile) + x];
    }
  }
}

void Compositor::store(int tile, const TileTask& task, const TileLight& sums, Workspace& work,
  RenderedImage& image) const
{
  const PixelBox& box = task.pixels;
  const double unit = this->projection.splatUnit();
  for (int y = box.y0; y < box.y1; ++y)
  {
    const std::size_t first = std::size_t(this->grid.bottomOf(tile) + y) * this->camera.width +
      (this->grid.leftOf(tile) + box.x0);
    for (int x = box.x0; x < box.x1; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::size_t k = 3 * (first + x - box.x0) + c;
        // Where there is one source, what was added up are the optical depths.
        const double sum = sums.light.values[c][y][x];
        const double light = task.isOneSource ? -task.source[c] * std::expm1(-sum) : sum;
        image.radiance[k] = toSingle(unit * light, work.tooBright);
        if (task.absorption != TileAbsorption::None)
        {
          const int plane = task.absorption == TileAbsorption::Grey ? 0 : c;
          const double tau = task.isOneSource ? sum : sums.tau.values[plane][y][x];
          image.transmittance[k] = static_cast<float>(std::exp(-tau));
        }
      }
    }
  }
}
} // namespace

RenderedImage renderSorted(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  SpreadAbsorbers spread;
  return Compositor(spread.of(particles, camera, options.kernel), camera, options, {}).render();
}

RenderedImage renderBounded(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  SpreadAbsorbers spread;
  const ParticleView all = spread.of(particles, camera, options.kernel);
  return Compositor(all, camera, options, options.allowed).render();
}
} // namespace galaxy
