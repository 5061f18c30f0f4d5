// Seconds a picture, by stage, for six views of one galaxy and one from within it, at three levels
// of accuracy. Use: galaxy_bench_render [--scene=N | --scene=SCENE.f32] [--spline] [Google
// Benchmark's options] N particles of makeDisc, or a file as readScene has it;
// --benchmark_filter=stars/Sorted picks views and levels by their names, --benchmark_repetitions=5
// repeats them.
#include "BenchScenes.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/Tiles.h"
#include "Filters/Splatting/ToneMap.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <memory>
#include <omp.h>

namespace
{
using namespace galaxy;

/// What all pictures share.
struct Bench
{
  BenchScene scene;
  RenderOptions options;
  RenderMemory memory;
  Preview preview;
  std::uint64_t version = 0;

  RenderedImage draw(const BenchView& view, Accuracy accuracy)
  {
    const Camera camera = view.camera();
    RenderOptions with = this->options;
    with.memory = &this->memory;
    with.accuracy = accuracy;
    // Of the disc's light, of which all is 1 or so, white is what a thousandth on a square kpc is.
    with.allowed = allowedError({ 1e3, 10, 1 }, 1.0 / 512);
    const ParticleView particles = this->scene.view(view.hasGas);
    return accuracy == Accuracy::Preview
      ? this->preview.render(particles, view.hasGas ? 1 : 2, camera, with, 0.1)
      : render(particles, camera, with);
  }
};

void run(benchmark::State& state, Bench& bench, const BenchView& view, Accuracy accuracy)
{
  bench.draw(view, accuracy); // memory and the sample, which later pictures have
  RenderStatistics last;
  for (auto _ : state)
  {
    const double start = omp_get_wtime();
    const RenderedImage image = bench.draw(view, accuracy);
    state.SetIterationTime(omp_get_wtime() - start);
    last = image.statistics;
  }
  for (const auto& stage : last.seconds)
  {
    state.counters[stage.first] = stage.second;
  }
  state.counters["drawn"] = static_cast<double>(last.drawn);
  state.SetLabel(activeEffects(last));
}
} // namespace

int main(int argc, char** argv)
{
  benchmark::Initialize(&argc, argv);
  auto bench = std::make_unique<Bench>();
  std::string source = "1000000";
  for (int k = 1; k < argc; ++k)
  {
    if (std::strncmp(argv[k], "--scene=", 8) == 0)
    {
      source = argv[k] + 8;
    }
    else if (std::strcmp(argv[k], "--spline") == 0)
    {
      bench->options.kernel = Kernel::CubicSpline;
    }
    else
    {
      std::fprintf(stderr, "%s: unknown option\n", argv[k]);
      return 2;
    }
  }
  bench->scene = benchScene(source);
  if (bench->scene.size == 0)
  {
    std::fprintf(stderr, "%s: no particles\n", source.c_str());
    return 2;
  }
  const std::pair<const char*, Accuracy> levels[] = { { "Sorted", Accuracy::Sorted },
    { "Bounded", Accuracy::Bounded }, { "Preview", Accuracy::Preview } };
  const auto measure = [&](const BenchView& view) {
    for (const auto& level : levels)
    {
      benchmark::RegisterBenchmark((std::string(view.name) + "/" + level.first).c_str(),
        [&bench, &view, accuracy = level.second](
          benchmark::State& state) { run(state, *bench, view, accuracy); })
        ->UseManualTime()
        ->Iterations(2)
        ->Unit(benchmark::kMillisecond);
    }
  };
  for (const BenchView& view : benchViews)
  {
    measure(view);
  }
  measure(insideView);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
