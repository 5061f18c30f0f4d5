#include "Filters/Model/ParallelFor.h"
#include "Filters/Splatting/Picture.h"
#include "Filters/Splatting/TileSlicer.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <atomic>
#include <numeric>
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
  TileSlicer slicerOf(const TileDealer& dealer, const TileBand& band, int tile) const;

  const Camera& camera;
  const RenderOptions& options;
  Projection projection;
  WorkProgress progress;
  double work = 0;
  std::atomic<std::size_t> coarse{ 0 }, tooBright{ 0 };
};

TileSlicer SlicedPicture::slicerOf(const TileDealer& dealer, const TileBand& band, int tile) const
{
  const std::size_t first = band.first[tile - band.firstTile];
  TileSlicer slicer(this->camera, this->options, dealer.grid(), tile);
  slicer.set(
    band.splats.data() + first, dealer.splatsOf(tile), dealer.depthsOf(tile), this->projection);
  return slicer;
}

void SlicedPicture::renderBand(const TileDealer& dealer, const TileBand& band, RenderedImage& image)
{
  std::vector<double> works(band.lastTile - band.firstTile);
  parallelForDynamic<int>(band.firstTile, band.lastTile, 1, [&](int tile) {
    works[tile - band.firstTile] =
      dealer.splatsOf(tile) > 0 ? this->slicerOf(dealer, band, tile).work() : 0;
  });
  const double all = std::accumulate(works.begin(), works.end(), 0.0);
  this->work += all;
  // Those with the most work first, so that no thread is left with a large one at the end.
  std::vector<int> tiles(works.size());
  std::iota(tiles.begin(), tiles.end(), 0);
  std::stable_sort(tiles.begin(), tiles.end(), [&](int a, int b) { return works[a] > works[b]; });
  parallelForDynamic<std::size_t>(0, tiles.size(), 1, [&](std::size_t k) {
    const int tile = band.firstTile + tiles[k];
    if (dealer.splatsOf(tile) == 0 || this->progress.isAborted())
    {
      return;
    }
    TileSlicer slicer = this->slicerOf(dealer, band, tile);
    this->coarse += slicer.isCoarse();
    // Progress counts the band's splats; a row is as many as its work is of all.
    const int rows = slicer.lastRow() - slicer.firstRow();
    const double splats = double(band.first.back()) * works[tiles[k]] / all;
    for (int row = 0; row < rows && !this->progress.isAborted(); ++row)
    {
      this->tooBright += slicer.drawRow(slicer.firstRow() + row, dealer.splatUnit(), image);
      const auto doneBefore = [&](int r) { return static_cast<std::size_t>(splats * r / rows); };
      this->progress.advance(doneBefore(row + 1) - doneBefore(row));
    }
  });
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
