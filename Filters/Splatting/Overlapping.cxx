#include "Filters/Model/ParallelFor.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/TileSlicer.h"
#include "Filters/Splatting/Tiles.h"

#include <atomic>
#include <memory>
#include <omp.h>

namespace galaxy
{
namespace
{
/// One rendering.
class SlicedPicture
{
public:
  SlicedPicture(const ParticleView& particles, const Camera& camera, const RenderOptions& options)
    : camera(camera)
    , options(options)
    , projection(particles, { camera, options.kernel })
    , progress(options.progress)
  {
  }
  RenderedImage render();

private:
  void renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image);
  std::unique_ptr<TileSlicer> slicerOf(
    const TileDealer& dealer, const TileBand& band, int tile) const;

  /// A row of a tile's pixels, with its share of the tile's work.
  struct TileRow
  {
    int tile, y;
    double work;
  };
  std::vector<TileRow> rowsOf(const TileDealer& dealer, const TileBand& band);

  const Camera& camera;
  const RenderOptions& options;
  Projection projection;
  WorkProgress progress;
  double work = 0;
  std::atomic<std::size_t> coarse{ 0 }, tooBright{ 0 };
};

std::unique_ptr<TileSlicer> SlicedPicture::slicerOf(
  const TileDealer& dealer, const TileBand& band, int tile) const
{
  const std::size_t first = band.first[tile - band.firstTile];
  auto slicer = std::make_unique<TileSlicer>(this->camera, this->options, dealer.grid(), tile);
  slicer->set(
    band.splats.data() + first, dealer.splatsOf(tile), dealer.depthsOf(tile), this->projection);
  return slicer;
}

/// All threads draw rows of one tile, then of the next: whichever of them calls back for progress
/// has work until the end, however much of it one tile has.
void SlicedPicture::renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image)
{
  const std::vector<TileRow> rows = this->rowsOf(dealer, band);
  std::vector<double> workTo(1, 0.0);
  for (const TileRow& row : rows)
  {
    workTo.push_back(workTo.back() + row.work);
  }
  this->work += workTo.back();
  // Progress counts the band's splats; a row is as many as its work is of all.
  const auto splatsTo = [&](std::size_t k) {
    return static_cast<std::size_t>(double(band.first.back()) * workTo[k] / workTo.back());
  };
  std::vector<std::unique_ptr<TileSlicer>> slicers(omp_get_max_threads());
  parallelForDynamic<std::size_t>(0, rows.size(), 1, [&](std::size_t k) {
    if (this->progress.isAborted())
    {
      return;
    }
    const TileRow& row = rows[k];
    std::unique_ptr<TileSlicer>& slicer = slicers[omp_get_thread_num()];
    if (!slicer || slicer->tile() != row.tile)
    {
      slicer = this->slicerOf(dealer, band, row.tile);
    }
    this->tooBright += slicer->drawRow(row.y, dealer.splatUnit(), image);
    this->progress.advance(splatsTo(k + 1) - splatsTo(k));
  });
}

std::vector<SlicedPicture::TileRow> SlicedPicture::rowsOf(
  const TileDealer& dealer, const TileBand& band)
{
  std::vector<std::vector<TileRow>> ofTiles(band.lastTile - band.firstTile);
  parallelForDynamic<int>(band.firstTile, band.lastTile, 1, [&](int tile) {
    if (dealer.splatsOf(tile) == 0 || this->progress.isAborted())
    {
      return;
    }
    const std::unique_ptr<TileSlicer> slicer = this->slicerOf(dealer, band, tile);
    this->coarse += slicer->isCoarse();
    const double work = slicer->work() / (slicer->lastRow() - slicer->firstRow());
    for (int y = slicer->firstRow(); y < slicer->lastRow(); ++y)
    {
      ofTiles[tile - band.firstTile].push_back({ tile, y, work });
    }
  });
  std::vector<TileRow> rows;
  for (const std::vector<TileRow>& ofTile : ofTiles)
  {
    rows.insert(rows.end(), ofTile.begin(), ofTile.end());
  }
  return rows;
}

RenderedImage SlicedPicture::render()
{
  RenderedImage image = emptyPicture(this->camera);
  const double start = omp_get_wtime();
  RenderMemory own;
  const TileDealer dealer(
    this->projection, this->options.memory ? *this->options.memory : own, this->progress);
  ParticleCounts counts = dealer.missing();
  for (int k = 0; k < dealer.bands() && !this->progress.isAborted(); ++k)
  {
    const TileBand& band = dealer.deal(k);
    counts += band.counts;
    if (!this->progress.isAborted())
    {
      this->renderBand(dealer, band, image);
    }
  }
  finishPicture(counts, { 1, 0, 0 }, this->progress.isAborted(), image);
  image.statistics.coarse = this->coarse;
  image.statistics.tooBright = this->tooBright;
  image.statistics.raySums = this->work;
  image.statistics.bySlices = true;
  image.statistics.seconds.emplace_back("overlap", omp_get_wtime() - start);
  return image;
}
} // namespace

RenderedImage renderOverlapping(
  const ParticleView& particles, const Camera& camera, const RenderOptions& options)
{
  return SlicedPicture(particles, camera, options).render();
}
} // namespace galaxy
