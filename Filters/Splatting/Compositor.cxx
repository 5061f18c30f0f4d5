#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/TileComposite.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
/// What splats are in sum, by the binary exponent of their numbers: so that the smallest of them
/// are found whose sum is small.
class SumsBySize
{
public:
  void add(float x)
  {
    this->sums[exponentOf(x)] += x;
    this->all += x;
  }
  double total() const { return this->all; }
  /// The smallest numbers whose sum is no more than this: all below the threshold returned. `sum`
  /// becomes theirs.
  float smallest(double most, double& sum) const
  {
    sum = 0;
    int exponent = 0;
    for (; exponent < exponents && sum + this->sums[exponent] <= most; ++exponent)
    {
      sum += this->sums[exponent];
    }
    return exponent == 0 ? 0 : exponent < exponents ? std::ldexp(1.0F, exponent - 127) : infinity;
  }

private:
  static constexpr int exponents = 255;
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  static int exponentOf(float x)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &x, sizeof(bits));
    return std::min<int>(bits >> 23 & 0xff, exponents - 1);
  }

  std::array<double, exponents> sums = {};
  double all = 0;
};

/// The most of a splat's light, or optical depth, that a pixel can have.
float mostOfAPixel(Kernel kernel, float h)
{
  return std::min(1.0F, (kernel == Kernel::Gaussian ? 2.869F : 2.0F) / (h * h));
}

/// Whether all splats emit in proportion to their absorption, channel by channel, as absorbers
/// alone do: their light is then S (1 - e^-tau), whatever their order.
class OneSource
{
public:
  bool holds() const { return this->isOne; }
  double source(int channel) const { return std::max(0.0, this->S[channel]); }

  void add(const SlabLight& slab)
  {
    for (int c = 0; c < 3 && this->isOne; ++c)
    {
      if (slab.t[c] > 0 && this->S[c] < 0)
      {
        this->S[c] = double(slab.e[c]) / slab.t[c];
      }
      // Products that were rounded to float.
      this->isOne = std::abs(slab.e[c] - this->source(c) * slab.t[c]) <= 5e-7 * slab.e[c];
    }
  }

private:
  bool isOne = true;
  double S[3] = { -1, -1, -1 }; ///< negative: not known yet
};

/// What the splats of a tile are in sum.
struct TileSummary
{
  TileAbsorption absorption = TileAbsorption::None;
  OneSource source;
  float brightest = 0;   ///< the largest luminosity of one over a pixel's area
  float thickest = 0;    ///< the largest optical depth of one in a pixel
  SumsBySize light, tau; ///< over a pixel that all of them have in their middle

  template <bool sums>
  void add(const Splat& splat, const SlabLight& slab, Kernel kernel)
  {
    const float* e = slab.e;
    const float* t = slab.t;
    const float most = std::max({ e[0], e[1], e[2] });
    this->brightest = std::max(this->brightest, most);
    if (this->source.holds())
    {
      this->source.add(slab);
    }
    if (sums)
    {
      this->light.add(most * mostOfAPixel(kernel, splat.h));
    }
    if (splat.kind() != SplatKind::Emits)
    {
      const bool isGrey = t[0] == t[1] && t[1] == t[2];
      this->absorption =
        std::max(this->absorption, isGrey ? TileAbsorption::Grey : TileAbsorption::Color);
      const float depth = std::max({ t[0], t[1], t[2] }) * mostOfAPixel(kernel, splat.h);
      this->thickest = std::max(this->thickest, depth);
      if (sums)
      {
        this->tau.add(depth);
      }
    }
  }
};

/// What a picture leaves out of a tile.
struct Omission
{
  float light = 0;       ///< emitters fainter than this
  float tau = 0;         ///< absorbers thinner than this
  bool isOrdered = true; ///< whether the others' order matters
  ErrorBound bound;      ///< on the error
  std::size_t splats = 0;
};

/// One thread's memory, kept from tile to tile.
struct Workspace
{
  std::vector<KeyedSlot> order;
  std::vector<KeyedSlot> scratch;
  TileSums sums;
  double seconds[2] = { 0, 0 }; ///< sort, composite
  float thickest = 0;
  std::size_t untouched = 0, faint = 0;
  OrderNeeds tiles;
  ErrorBound bound;
};

/// One rendering.
class Compositor
{
public:
  Compositor(const ParticleView& particles, const Camera& camera_, const RenderOptions& options_,
    const ErrorBound& allowed)
    : projection(particles, camera_)
    , camera(camera_)
    , grid(camera_.width, camera_.height)
    , options(options_)
    , allowed(allowed)
  {
  }
  RenderedImage render();

private:
  void renderBands(RenderedImage& image);
  void renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image);
  void renderTile(const TileDealer& dealer, const TileBand& band, int tile, Workspace& work,
    RenderedImage& image);
  TileTask taskOf(const TileBand& band, int tile, Workspace& work) const;
  template <bool sums>
  TileSummary summaryOf(const TileTask& task) const;
  Omission omissionOf(const TileSummary& summary) const;
  bool omits(const Omission& omission, const Splat& splat) const;
  void order(TileTask& task, const Omission& omission, Workspace& work) const;
  bool proceed(std::size_t more);
  void loadOpaque(int tile, const TileTask& task, TileSums& sums) const;
  void store(int tile, const TileTask& task, const TileSums& sums, RenderedImage& image) const;

  Projection projection;
  Camera camera;
  TileGrid grid;
  const RenderOptions& options;
  ErrorBound allowed;
  ProjectionCounts counts;
  std::size_t splats = 0; ///< of all tiles
  std::atomic<std::size_t> done{ 0 };
  std::size_t untouched = 0, faint = 0;
  OrderNeeds tiles;
  ErrorBound bound;
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
  finishPicture(this->counts, this->tiles, this->aborted, image);
  image.statistics.untouched = this->untouched;
  image.statistics.thickest = this->thickest;
  image.statistics.faint = this->faint;
  image.statistics.unordered = this->tiles.thin + this->tiles.oneSource;
  image.statistics.bound = this->bound;
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
        this->renderTile(dealer, band, tiles[n], *work, image);
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
      this->untouched += work->untouched;
      this->faint += work->faint;
      this->tiles += work->tiles;
      this->bound.light = std::max(this->bound.light, work->bound.light);
      this->bound.share = std::max(this->bound.share, work->bound.share);
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
  task.projection = &this->projection;
  const bool isBounded = this->allowed.light > 0 || this->allowed.share > 0;
  const TileSummary summary =
    isBounded ? this->summaryOf<true>(task) : this->summaryOf<false>(task);
  task.absorption = summary.absorption;
  task.brightest = summary.brightest;
  task.negligible = static_cast<float>(this->allowed.light / 2);
  task.opaque = static_cast<float>(this->allowed.share / 2);
  work.thickest = std::max(work.thickest, summary.thickest);
  const Omission omission = isBounded ? this->omissionOf(summary) : Omission();
  const bool absorbs = summary.absorption != TileAbsorption::None;
  task.isOneSource = absorbs && summary.source.holds();
  const bool isOrdered = absorbs && omission.isOrdered && !task.isOneSource;
  if (isOrdered || omission.light > 0 || omission.tau > 0)
  {
    this->order(task, omission, work);
  }
  if (isOrdered)
  {
    sortByKey(work.order.data(), work.order.data() + task.count, work.scratch);
  }
  for (int c = 0; c < 3; ++c)
  {
    task.source[c] = summary.source.source(c);
  }
  work.tiles.ordered += isOrdered;
  work.tiles.oneSource += task.isOneSource;
  work.tiles.thin += absorbs && !isOrdered && !task.isOneSource;
  work.bound.light = std::max(work.bound.light, omission.bound.light);
  work.bound.share = std::max(work.bound.share, omission.bound.share);
  return task;
}

template <bool sums>
TileSummary Compositor::summaryOf(const TileTask& task) const
{
  TileSummary summary;
  for (std::size_t slot = 0; slot < task.count; ++slot)
  {
    const Splat& splat = task.splats[slot];
    summary.add<sums>(splat, this->projection.lightOf(splat), this->options.kernel);
  }
  return summary;
}

/// Half of what is allowed is for the faintest splats, half for what their order, or what lies
/// behind them, would change.
Omission Compositor::omissionOf(const TileSummary& summary) const
{
  Omission omission;
  omission.light = summary.light.smallest(this->allowed.light / 2, omission.bound.light);
  // Dimmed by e^-tau too little, light is too much by the share e^tau - 1.
  const double mostTau = std::log1p(this->allowed.share / 2) / 2;
  double thin = 0;
  omission.tau = summary.tau.smallest(mostTau, thin);
  const double rest = summary.tau.total() - thin;
  omission.isOrdered = rest > mostTau;
  omission.bound.share = std::expm1(thin + (omission.isOrdered ? 0 : rest));
  if (rest > 0)
  {
    // Where drawing may end behind dust.
    omission.bound.light += this->allowed.light / 2;
    omission.bound.share += this->allowed.share / 2;
  }
  return omission;
}

/// Lists the splats that are not left out, ready to be sorted.
void Compositor::order(TileTask& task, const Omission& omission, Workspace& work) const
{
  work.order.resize(task.count);
  std::size_t listed = 0;
  const bool omits = omission.light > 0 || omission.tau > 0;
  // Of equal depths the particle that comes first lies behind.
  for (std::size_t slot = task.count; slot-- > 0;)
  {
    const Splat& splat = task.splats[slot];
    work.order[listed] = keyedSlot(splat.depth, static_cast<std::uint32_t>(slot));
    listed += !omits || !this->omits(omission, splat);
  }
  work.faint += task.count - listed;
  task.count = listed;
  task.order = work.order.data();
}

bool Compositor::omits(const Omission& omission, const Splat& splat) const
{
  const SlabLight slab = this->projection.lightOf(splat);
  const float most = mostOfAPixel(this->options.kernel, splat.h);
  return std::max({ slab.e[0], slab.e[1], slab.e[2] }) * most < omission.light &&
    (splat.kind() == SplatKind::Emits ||
      std::max({ slab.t[0], slab.t[1], slab.t[2] }) * most < omission.tau);
}

void Compositor::renderTile(
  const TileDealer& dealer, const TileBand& band, int tile, Workspace& work, RenderedImage& image)
{
  const double start = omp_get_wtime();
  TileTask task = this->taskOf(band, tile, work);
  task.pixels = this->grid.pixelsOf(tile);
  task.depths = dealer.depthsOf(tile);
  const double sorted = omp_get_wtime();
  work.sums.clear(task.isOneSource ? TileAbsorption::None : task.absorption);
  if (task.hasOpaque)
  {
    this->loadOpaque(tile, task, work.sums);
  }
  work.untouched += task.count - compositeTile(task, work.sums);
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
        if (task.isOneSource)
        {
          // What was added up are the optical depths.
          image.radiance[k] = static_cast<float>(-task.source[c] * std::expm1(-light));
          image.transmittance[k] = static_cast<float>(std::exp(-light));
          continue;
        }
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
  return Compositor(particles, camera, options, {}).render();
}

RenderedImage renderBounded(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  return Compositor(particles, camera, options, options.allowed).render();
}
} // namespace galaxy
