// How far drawing is from what the machine could do: the bytes and floating-point operations that
// each stage of a picture cannot do without, against the bandwidth of memory and the peak of the
// vector units, both measured here.
// Use: galaxy_bench_limits [N | SCENE.f32]
#include "BenchScenes.h"
#include "Filters/Splatting/Projection.h"
#include "Filters/Splatting/TileGrid.h"
#include "Filters/Splatting/Tiles.h"
#include "VectorPeak.h"

#include <cstdio>
#include <memory>
#include <omp.h>

namespace
{
using namespace galaxy;

/// Bytes a second that all threads together read and write, adding one array to another.
double bandwidth()
{
  constexpr std::size_t n = std::size_t(1) << 27;
  std::unique_ptr<float[]> a(new float[n]), b(new float[n]);
  // Its own part of memory for each thread.
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i)
  {
    a[i] = b[i] = 1;
  }
  double best = 0;
  for (int round = 0; round < 5; ++round)
  {
    const double start = omp_get_wtime();
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i)
    {
      a[i] += b[i];
    }
    best = std::max(best, 3.0 * n * sizeof(float) / (omp_get_wtime() - start));
  }
  return a[n / 2] > 0 ? best : 0;
}

/// What a view makes of a scene.
struct Amounts
{
  double particles = 0, splats = 0, emitted = 0, absorbed = 0, edges = 0;

  Amounts(const ParticleView& particles, const Camera& camera)
    : particles(double(particles.size))
  {
    const TileGrid grid(camera.width, camera.height);
    const Projection projection(particles, Lens(camera, Kernel::Gaussian));
    double sums[4] = { 0, 0, 0, 0 };
#pragma omp parallel for schedule(static) reduction(+ : sums[:4])
    for (std::size_t i = 0; i < particles.size; ++i)
    {
      ParticleCounts counts;
      const PixelBox box = projection.classify(i, counts);
      if (box.empty())
      {
        continue;
      }
      const int x0 = box.x0, y0 = box.y0, x1 = box.x1 - 1, y1 = box.y1 - 1;
      const int columns = (x1 + grid.left) / tileSide - (x0 + grid.left) / tileSide + 1;
      const int rows = (y1 + grid.bottom) / tileSide - (y0 + grid.bottom) / tileSide + 1;
      const double pixels = double(x1 - x0 + 1) * (y1 - y0 + 1);
      sums[0] += columns * rows;
      sums[particles.absorption[3 * i + 1] > 0 ? 2 : 1] += pixels;
      sums[3] += rows * (x1 - x0 + 1) + columns * (y1 - y0 + 1);
    }
    this->splats = sums[0];
    this->emitted = sums[1];
    this->absorbed = sums[2];
    this->edges = sums[3];
  }
};

/// What a stage cannot do without.
struct Stage
{
  const char* name;
  double bytes, flops;
};

std::vector<Stage> stagesOf(const Amounts& a)
{
  // Positions and sizes are read and homes written; then all arrays are read and the splats
  // written; they are read to be ordered, and again to be drawn. Projecting takes 40 operations, a
  // weight 24 along each axis, a pixel 7 where light is added and 45 where it is absorbed.
  return { { "count", a.particles * (16 + 4), a.particles * 40 },
    { "project", a.particles * 40 + a.splats * 32, a.particles * 60 }, { "sort", a.splats * 32, 0 },
    { "composite", a.splats * 32, a.edges * 24 + a.emitted * 7 + a.absorbed * 45 } };
}
} // namespace

int main(int argc, char** argv)
{
  const BenchScene scene = benchScene(argc > 1 ? argv[1] : "1000000");
  if (scene.size == 0)
  {
    std::fprintf(stderr, "%s: no particles\n", argv[1]);
    return 2;
  }
  const double bytesPerSecond = bandwidth(), flopsPerSecond = vectorPeak();
  std::printf("%d threads: memory %.1f GB/s, vectors %.1f GFLOP/s\n\n", omp_get_max_threads(),
    bytesPerSecond * 1e-9, flopsPerSecond * 1e-9);
  std::printf(
    "| view | stage | GB | GFLOP | limit, s | took, s | times |\n|---|---|---|---|---|---|---|\n");
  RenderMemory memory;
  RenderOptions options;
  options.memory = &memory;
  for (const BenchView& view : benchViews)
  {
    const ParticleView particles = scene.view(view.hasGas);
    const Amounts amounts(particles, view.camera());
    renderSorted(particles, view.camera(), options);
    const RenderStatistics took = renderSorted(particles, view.camera(), options).statistics;
    double limits = 0, seconds = 0;
    for (const Stage& stage : stagesOf(amounts))
    {
      const double limit = std::max(stage.bytes / bytesPerSecond, stage.flops / flopsPerSecond);
      const auto isIt = [&](const auto& named) { return named.first == stage.name; };
      const double was = std::find_if(took.seconds.begin(), took.seconds.end(), isIt)->second;
      std::printf("| %s | %s | %.2f | %.2f | %.3f | %.3f | %.1f |\n", view.name, stage.name,
        stage.bytes * 1e-9, stage.flops * 1e-9, limit, was, was / limit);
      limits += limit;
      seconds += was;
    }
    std::printf(
      "| %s | all | | | %.3f | %.3f | %.1f |\n", view.name, limits, seconds, seconds / limits);
  }
  return 0;
}
