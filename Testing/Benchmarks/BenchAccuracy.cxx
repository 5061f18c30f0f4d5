// What accuracy costs in time: every level with its knobs, on five scenes, against the reference.
// Use: galaxy_bench_accuracy PARTICLES SIZE REPEATS M83.galaxy GROUP.galaxygroup [SCENE.f32]
// Writes JSON to standard output. `accuracy_cost.py` runs it and draws what it says.
#include "BenchScenes.h"
#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/GroupBuilder.h"
#include "Filters/Model/RingGeometry.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/Tiles.h"
#include "Filters/Splatting/ToneMap.h"

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <omp.h>

namespace
{
using namespace galaxy;

struct Case
{
  std::string name;
  ParticleView view;
  Camera camera;
};

ParticleView viewOf(const Particles& particles)
{
  ParticleView view;
  view.size = particles.size();
  view.position = particles.position.data();
  view.smoothingLength = particles.smoothingLength.data();
  view.intensity = particles.intensity.data();
  view.color = particles.color.data();
  view.component = particles.component.data();
  view.components = &particles.components;
  return view;
}

/// Of sorted values: so large a share is below.
double percentile(std::vector<float> values, double share)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The light that a picture shows as white: 99.9 % of the lit pixels are fainter.
double whiteOf(const RenderedImage& image)
{
  std::vector<float> lit;
  for (std::size_t k = 0; k < image.radiance.size(); k += 3)
  {
    const float* rgb = &image.radiance[k];
    const float most = std::max({ rgb[0], rgb[1], rgb[2] });
    if (most > 0)
    {
      lit.push_back(most);
    }
  }
  return lit.empty() ? 1 : percentile(lit, 0.999);
}

/// How far two pictures are apart: of white, and as displayed.
struct Difference
{
  double light = 0, display = 0, rms = 0;
  Difference(const RenderedImage& a, const RenderedImage& b, const ToneMap& map)
  {
    std::vector<float> shown[2] = { std::vector<float>(a.radiance.size()),
      std::vector<float>(a.radiance.size()) };
    applyToneMap(map, a.radiance.data(), shown[0].data(), a.radiance.size() / 3);
    applyToneMap(map, b.radiance.data(), shown[1].data(), b.radiance.size() / 3);
    for (std::size_t k = 0; k < a.radiance.size(); ++k)
    {
      this->light =
        std::max(this->light, std::abs(double(a.radiance[k]) - b.radiance[k]) * map.exposure);
      const double off = std::abs(double(shown[0][k]) - shown[1][k]);
      this->display = std::max(this->display, off);
      this->rms += off * off;
    }
    this->rms = std::sqrt(this->rms / std::max<std::size_t>(1, a.radiance.size()));
  }
};

class Output
{
public:
  explicit Output(int repeats)
    : repeats(repeats)
  {
    std::printf("{\n \"threads\": %d,\n \"runs\": [", omp_get_max_threads());
  }
  ~Output() { std::printf("\n ]\n}\n"); }

  /// Runs it, and says how far its picture is from `exact` if there is one.
  RenderedImage run(const std::string& scene, const std::string& level, const std::string& knob,
    double bound, const RenderedImage* exact, const ToneMap& map,
    const std::function<RenderedImage()>& draw)
  {
    RenderedImage image;
    double least = 1e30;
    for (int k = 0; k < this->repeats; ++k)
    {
      const double start = omp_get_wtime();
      image = draw();
      least = std::min(least, omp_get_wtime() - start);
    }
    std::printf("%s\n  {\"scene\": \"%s\", \"level\": \"%s\", \"knob\": \"%s\", \"seconds\": %.5f",
      this->isFirst ? "" : ",", scene.c_str(), level.c_str(), knob.c_str(), least);
    this->isFirst = false;
    if (exact)
    {
      const Difference off(image, *exact, map);
      std::printf(
        ", \"error\": %.4g, \"displayed\": %.4g, \"rms\": %.4g", off.light, off.display, off.rms);
    }
    if (bound >= 0)
    {
      std::printf(", \"bound\": %.6g", bound);
    }
    std::printf(", \"effects\": \"%s\"}", activeEffects(image.statistics).c_str());
    std::fflush(stdout);
    return image;
  }

private:
  int repeats;
  bool isFirst = true;
};

std::string numbered(const char* name, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%s %.3g", name, value);
  return text;
}

void benchLevels(const Case& c, Output& output)
{
  RenderMemory memory;
  RenderOptions options;
  options.memory = &memory;
  const double start = omp_get_wtime();
  const RenderedImage exact = renderReference(c.view, c.camera, options);
  const double seconds = omp_get_wtime() - start;
  const ToneMap map{ 1 / whiteOf(exact), 10, 1 };
  std::fprintf(
    stderr, "%s: %zu particles, reference in %.1f s\n", c.name.c_str(), c.view.size, seconds);
  output.run(
    c.name, "Sorted", "", -1, &exact, map, [&] { return renderSorted(c.view, c.camera, options); });
  for (const double tolerance : { 1.0 / 4096, 1.0 / 1024, 1.0 / 512, 1.0 / 128, 1.0 / 32, 0.125 })
  {
    options.allowed = allowedError(map, tolerance);
    output.run(c.name, "Bounded", numbered("tolerance", tolerance), tolerance, &exact, map,
      [&] { return renderBounded(c.view, c.camera, options); });
  }
  const PreviewSample sample(c.view);
  for (const double share : { 0.5, 0.2, 0.1, 0.03, 0.01, 0.003 })
  {
    const auto count = static_cast<std::size_t>(share * double(c.view.size));
    output.run(c.name, "Preview", numbered("share", share), -1, &exact, map,
      [&] { return renderSorted(sample.first(count, c.view), c.camera, options); });
  }
}

/// Particles that overlap share their path only in Overlapping: what it costs, and how far Sorted
/// is from that, on a part of the scene and few pixels.
void benchOverlap(const Case& c, std::size_t count, Output& output)
{
  const PreviewSample sample(c.view, count);
  const ParticleView view = sample.first(count, c.view);
  Camera camera = c.camera;
  const double smaller = 96.0 / camera.width;
  camera.scale *= smaller;
  camera.centerX *= smaller;
  camera.centerY *= smaller;
  camera.width = camera.height = 96;
  RenderOptions options;
  options.slices = 8;
  const RenderedImage exact = renderOverlapping(view, camera, options);
  const ToneMap map{ 1 / whiteOf(exact), 10, 1 };
  const std::string name = c.name + ", " + std::to_string(count) + " particles";
  output.run(
    name, "Sorted", "", -1, &exact, map, [&] { return renderSorted(view, camera, options); });
  RenderOptions spline;
  spline.kernel = Kernel::CubicSpline;
  const RenderedImage exactSpline = renderReference(view, camera, spline);
  output.run(name, "Spline", "Sorted, of its reference", -1, &exactSpline, map,
    [&] { return renderSorted(view, camera, spline); });
  // What the order of centres costs: the same picture with every ray's own.
  const RenderedImage ordered = renderReference(view, camera, options);
  output.run(name, "Order", "of each ray, by Sorted's", -1, &ordered, map,
    [&] { return renderInOrderOfRays(view, camera, options); });
  for (const double slices : { 0.25, 0.5, 1.0, 2.0, 4.0 })
  {
    options.slices = slices;
    output.run(name, "Overlapping", numbered("slices", slices), -1, &exact, map,
      [&] { return renderOverlapping(view, camera, options); });
  }
}

/// Pairs of scenes with nearly the same picture, of which the first calls for less.
void benchEffects(std::size_t n, int size, Output& output)
{
  const Camera camera = benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, 10, size);
  const auto run = [&](const char* effect, const char* state, const BenchScene& scene) {
    RenderOptions options;
    output.run(effect, "Sorted", state, -1, nullptr, {},
      [&] { return renderSorted(scene.view(), camera, options); });
  };
  BenchScene scene = makeDisc(n);
  run("absorption", "of all dust", scene);
  for (float& K : scene.absorption)
  {
    K = 0;
  }
  run("absorption", "none", scene);

  scene = makeDisc(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    scene.absorption[3 * i] = scene.absorption[3 * i + 2] = scene.absorption[3 * i + 1];
  }
  run("colour of absorption", "grey", scene);
  for (std::size_t i = 0; i < n; ++i)
  {
    scene.absorption[3 * i] = std::nextafter(scene.absorption[3 * i], 1.0F);
  }
  run("colour of absorption", "per channel", scene);

  scene = makeNebula(n);
  for (std::size_t i = 0; i < 3 * n; ++i)
  {
    scene.emission[i] = 2 * scene.absorption[i];
  }
  run("source function", "one", scene);
  for (std::size_t i = 0; i < 3 * n; i += 30)
  {
    scene.emission[i] *= 1.00001F;
  }
  run("source function", "several", scene);

  scene = makeDisc(n);
  const float wall[3] = { 1e9F, 1e9F, 1e9F }, black[3] = {};
  const float place[3] = { 0, 0, 20 };
  run("light behind a wall", "no wall", scene);
  for (int k = 0; k < 10; ++k)
  {
    scene.add(place, 900, black, wall);
  }
  run("light behind a wall", "not touched", scene);
}

/// As this program was built, see Knobs.h.
std::string knobsOfBuild()
{
  return "tiles of " + std::to_string(tileSide) + ", depths of " + std::to_string(depthBits) +
    " bits, sums in " + (sizeof(SpanSum) == sizeof(double) ? "double" : "float") +
    (kernelCut < 1 ? ", kernels cut at " + std::to_string(kernelCut).substr(0, 3) : "");
}

/// What is built into the program: drawn as it is, and nothing else.
void benchBuild(const Case& c, Output& output)
{
  RenderMemory memory;
  RenderOptions options;
  options.memory = &memory;
  const RenderedImage exact = renderReference(c.view, c.camera, options);
  output.run(c.name, "Build", knobsOfBuild(), -1, &exact, { 1 / whiteOf(exact), 10, 1 },
    [&] { return renderSorted(c.view, c.camera, options); });
}
} // namespace

int main(int argc, char** argv)
{
  if (argc == 4)
  {
    const auto n = static_cast<std::size_t>(std::atof(argv[1]));
    const int size = std::atoi(argv[2]);
    Output output(std::max(1, std::atoi(argv[3])));
    const BenchScene disc = makeDisc(n), nebula = makeNebula(n);
    benchBuild({ "disc", disc.view(), benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, 10, size) }, output);
    benchBuild(
      { "disc, edge-on", disc.view(), benchCamera({ 1, 0, 0 }, { 0, 0, 1 }, 10, size) }, output);
    benchBuild({ "nebula", nebula.view(), benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, 9, size) }, output);
    return 0;
  }
  if (argc < 6)
  {
    std::fprintf(stderr,
      "usage: galaxy_bench_accuracy PARTICLES SIZE REPEATS M83.galaxy GROUP.galaxygroup "
      "[SCENE.f32]\n"
      "or, for what it is built with: galaxy_bench_accuracy PARTICLES SIZE REPEATS\n");
    return 2;
  }
  const auto n = static_cast<std::size_t>(std::atof(argv[1]));
  const int size = std::atoi(argv[2]);
  Output output(std::max(1, std::atoi(argv[3])));

  const Galaxy m83 = readGalaxy(argv[4]);
  BuildOptions build;
  build.particleScale = double(n) / 9e6;
  const Particles disc = buildGalaxy(m83, build);
  const RingFrame inner =
    TiltedDisk(m83.rings, m83.description.distance, m83.description.spin).frame(1);
  const Vec3 towards = inner.n.z < 0 ? -1 * inner.n : inner.n;
  benchLevels({ "M83 face-on", viewOf(disc), benchCamera(towards, inner.b, 9, size) }, output);
  const Case edgeOn{ "M83 edge-on", viewOf(disc), benchCamera(inner.a, towards, 9, size) };
  benchLevels(edgeOn, output);

  const BenchScene nebula = makeNebula(n);
  const Case clouds{ "nebula", nebula.view(), benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, 9, size) };
  benchLevels(clouds, output);

  build.particleScale /= 2;
  const Particles group = buildGroup(readGroupDescription(argv[5]), build);
  std::vector<float> aside;
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    aside.push_back(std::hypot(group.position[3 * i], group.position[3 * i + 1]));
  }
  const double far = percentile(aside, 0.9999);
  Camera sky = benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, far, size);
  sky.parallel = true;
  sky.scale = 0.5 * size / far;
  benchLevels({ "group", viewOf(group), sky }, output);

  const BenchScene peer = argc > 6 ? readScene(argv[6]) : makeDisc(n);
  benchLevels({ argc > 6 ? "benchmark scene" : "disc", peer.view(),
                benchCamera({ 0, 0, 1 }, { 0, 1, 0 }, 10, size) },
    output);

  benchOverlap(edgeOn, 5000, output);
  benchOverlap(clouds, 5000, output);
  benchEffects(n, size, output);
  return 0;
}
