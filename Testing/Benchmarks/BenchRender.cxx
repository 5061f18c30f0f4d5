// Seconds a frame, by stage, for six views of one galaxy.
// Use: galaxy_bench_render [N | SCENE.f32] [repeats] [Gaussian | spline] [VIEW], where VIEW is a
// part of a view's name, such as stars. N synthetic particles, or a scene file of nine float32
// arrays x y z h I R G B type one after the other (kpc; type 0 gas, 2 dust, others stars).
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Tiles.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>

namespace
{
using namespace galaxy;

/// Gas first, then the rest, so that a view without gas is a range of the arrays.
struct Scene
{
  std::size_t size = 0;
  std::size_t gas = 0;
  std::vector<float> position, h, emission, absorption;

  void add(const float* p, float radius, const float* light, bool dust)
  {
    static const float extinction[3] = { 0.8f, 1.0f, 1.3f };
    this->position.insert(this->position.end(), p, p + 3);
    this->h.push_back(radius);
    for (int c = 0; c < 3; ++c)
    {
      this->emission.push_back(dust ? 0 : light[c]);
      this->absorption.push_back(dust ? light[3] * extinction[c] : 0);
    }
    ++this->size;
  }
  ParticleView view(bool withGas) const
  {
    const std::size_t skip = withGas ? 0 : this->gas;
    ParticleView view;
    view.size = this->size - skip;
    view.position = this->position.data() + 3 * skip;
    view.smoothingLength = this->h.data() + skip;
    view.emission = this->emission.data() + 3 * skip;
    view.absorption = this->absorption.data() + 3 * skip;
    return view;
  }
  void reserve(std::size_t n)
  {
    this->h.reserve(n);
    for (auto* array : { &this->position, &this->emission, &this->absorption })
    {
      array->reserve(3 * n);
    }
  }
};

/// The kernel's support is 1.5 times the file's h, and light is shared out among all particles.
Scene readScene(const std::string& file)
{
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::size_t n = in ? static_cast<std::size_t>(in.tellg()) / 36 : 0;
  std::vector<float> fields(9 * n);
  in.seekg(0);
  in.read(reinterpret_cast<char*>(fields.data()), 36 * n);
  Scene scene;
  scene.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto field = [&](int k) { return fields[k * n + i]; };
    const float I = field(4) / n;
    const float p[3] = { field(0), field(1), field(2) };
    const float light[4] = { I * field(5), I * field(6), I * field(7), I * 1.9e3f };
    scene.gas += field(8) == 0;
    scene.add(p, 1.5f * field(3), light, field(8) == 2);
  }
  return scene;
}

/// An exponential disc of wide gas, small stars and a thin layer of dust.
Scene makeScene(std::size_t n)
{
  std::mt19937_64 random(1);
  std::normal_distribution<float> normal;
  std::gamma_distribution<float> gamma(2, 1);
  Scene scene;
  scene.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool gas = i < n / 5;
    const bool dust = !gas && i < n / 3;
    const float R = gamma(random) * (gas ? 6.0f : 2.2f);
    const float phi = 2 * 3.14159265f * (random() % 1000000) * 1e-6f;
    const float p[3] = { R * std::cos(phi), R * std::sin(phi),
      normal(random) *
        (gas       ? 0.15f
            : dust ? 0.05f
                   : 0.1f) };
    const float I = 0.4f / n;
    const float light[4] = { I, 0.9f * I, 0.8f * I, 1.9e3f * I };
    scene.add(p, gas ? 0.38f * (1 + R / 20) : dust ? 0.07f : 0.03f, light, dust);
  }
  scene.gas = n / 5;
  return scene;
}

Camera benchCamera(bool edgeOn, double halfWidth)
{
  const double angle = 360 / M_PI * std::atan(halfWidth / 100);
  const Vec3 eye = edgeOn ? Vec3{ 100, 0, 0 } : Vec3{ 0, 0, 100 };
  const Vec3 up = edgeOn ? Vec3{ 0, 0, 1 } : Vec3{ 0, 1, 0 };
  return Camera::lookAt(eye, {}, up, false, 1, angle, 1024, 1024);
}

/// The views whose names have this in them are drawn.
std::string wantedViews;

void benchView(const Scene& scene, const char* name, bool edgeOn, double halfWidth, bool gas,
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
    RenderedImage image = renderSorted(scene.view(gas), benchCamera(edgeOn, halfWidth), options);
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
  const Scene scene = isNumber ? makeScene(std::stoull(source)) : readScene(source);
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
