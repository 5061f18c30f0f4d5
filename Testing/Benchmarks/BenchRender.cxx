// Seconds a frame, by stage, for six views of one galaxy.
// Use: galaxy_bench_render [N | SCENE.f32] [repeats] [Gaussian | spline] [VIEW], where VIEW is a
// part of a view's name, such as stars. N synthetic particles, or a scene file of nine float32
// arrays x y z h I R G B type one after the other (kpc; type 0 gas, 2 dust, others stars).
#include "BenchScenes.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

namespace
{
using namespace galaxy;

/// The views whose names have this in them are drawn.
std::string wantedViews;

void benchView(const BenchScene& scene, const char* name, bool edgeOn, double halfWidth, bool gas,
  int repeats, const RenderOptions& options)
{
  if (std::string(name).find(wantedViews) == std::string::npos)
  {
    return;
  }
  RenderedImage best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < repeats; ++k)
  {
    const Vec3 from = edgeOn ? Vec3{ 1, 0, 0 } : Vec3{ 0, 0, 1 };
    const Vec3 up = edgeOn ? Vec3{ 0, 0, 1 } : Vec3{ 0, 1, 0 };
    RenderedImage image = render(scene.view(gas), benchCamera(from, up, halfWidth, 1024), options);
    double total = 0;
    for (const auto& stage : image.statistics.seconds)
    {
      total += stage.second;
    }
    if (total < least)
    {
      least = total;
      best = std::move(image);
    }
  }
  std::printf("%-22s %7.3f s ", name, least);
  for (const auto& stage : best.statistics.seconds)
  {
    std::printf(" %s %.3f", stage.first.c_str(), stage.second);
  }
  double light = 0;
  for (const float x : best.radiance)
  {
    light += x;
  }
  std::printf("  [%s; sum %.8g]\n", best.statistics.activeEffects.c_str(), light);
  std::fflush(stdout);
}
} // namespace

int main(int argc, char** argv)
{
  const std::string source = argc > 1 ? argv[1] : "1000000";
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 3;
  const bool isNumber = source.find_first_not_of("0123456789") == std::string::npos;
  const BenchScene scene = isNumber ? makeDisc(std::stoull(source)) : readScene(source);
  RenderMemory memory;
  RenderOptions options;
  options.memory = &memory;
  options.kernel =
    argc > 3 && std::string(argv[3]) == "spline" ? Kernel::CubicSpline : Kernel::Gaussian;
  wantedViews = argc > 4 ? argv[4] : "";
  std::printf("%zu particles, 1024 x 1024, least of %d\n", scene.size, repeats);
  benchView(scene, "face-on, 84 kpc", false, 42, true, repeats, options);
  benchView(scene, "edge-on, 84 kpc", true, 42, true, repeats, options);
  benchView(scene, "face-on, 20 kpc", false, 10, true, repeats, options);
  benchView(scene, "edge-on, 20 kpc", true, 10, true, repeats, options);
  benchView(scene, "face-on, stars, 20 kpc", false, 10, false, repeats, options);
  benchView(scene, "edge-on, stars, 20 kpc", true, 10, false, repeats, options);
  return 0;
}
