#ifndef galaxy_BenchScenes_h
#define galaxy_BenchScenes_h

#include "Filters/Splatting/Render.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace galaxy
{
/// Particles with emission and absorption of their own. The first `gas` of them can be left out.
struct BenchScene
{
  std::size_t size = 0;
  std::size_t gas = 0;
  std::vector<float> position, h, emission, absorption;

  void reserve(std::size_t n)
  {
    this->h.reserve(n);
    for (auto* array : { &this->position, &this->emission, &this->absorption })
    {
      array->reserve(3 * n);
    }
  }
  void add(const float* p, float radius, const float* L, const float* K)
  {
    this->position.insert(this->position.end(), p, p + 3);
    this->h.push_back(radius);
    this->emission.insert(this->emission.end(), L, L + 3);
    this->absorption.insert(this->absorption.end(), K, K + 3);
    ++this->size;
  }
  ParticleView view(bool withGas = true) const
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
};

/// Emits, or, being dust, absorbs `light` in the ratio 0.8 : 1 : 1.3.
inline void addStarOrDust(
  BenchScene& scene, const float* p, float radius, const float* light, float depth, bool isDust)
{
  const float nothing[3] = {};
  const float K[3] = { 0.8F * depth, depth, 1.3F * depth };
  scene.add(p, radius, isDust ? nothing : light, isDust ? K : nothing);
}

/// A scene file: nine float32 arrays x y z h I R G B type, one after the other (kpc; type 0 gas, 2
/// dust, others stars; gas first). The kernel's support is 1.5 times the file's h, and light is
/// shared out among all particles.
inline BenchScene readScene(const std::string& file)
{
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::size_t n = in ? static_cast<std::size_t>(in.tellg()) / 36 : 0;
  std::vector<float> fields(9 * n);
  in.seekg(0);
  in.read(reinterpret_cast<char*>(fields.data()), static_cast<std::streamsize>(36 * n));
  BenchScene scene;
  scene.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto field = [&](int k) { return fields[k * n + i]; };
    const float I = field(4) / n;
    const float p[3] = { field(0), field(1), field(2) };
    const float light[3] = { I * field(5), I * field(6), I * field(7) };
    scene.gas += field(8) == 0;
    addStarOrDust(scene, p, 1.5F * field(3), light, I * 1.9e3F, field(8) == 2);
  }
  return scene;
}

/// An exponential disc of wide gas, small stars and a thin layer of dust.
inline BenchScene makeDisc(std::size_t n)
{
  std::mt19937_64 random(1);
  std::normal_distribution<float> normal;
  std::gamma_distribution<float> gamma(2, 1);
  BenchScene scene;
  scene.reserve(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool isGas = i < n / 5;
    const bool isDust = !isGas && i < n / 3;
    const float R = gamma(random) * (isGas ? 6.0F : 2.2F);
    const float phi = 2 * 3.14159265F * (random() % 1000000) * 1e-6F;
    const float height = isGas ? 0.15F : isDust ? 0.05F : 0.1F;
    const float p[3] = { R * std::cos(phi), R * std::sin(phi), normal(random) * height };
    const float I = 0.4F / n;
    const float light[3] = { I, 0.9F * I, 0.8F * I };
    const float radius = isGas ? 0.38F * (1 + R / 20) : isDust ? 0.07F : 0.03F;
    addStarOrDust(scene, p, radius, light, I * 1.9e3F, isDust);
  }
  scene.gas = n / 5;
  return scene;
}

/// Clouds of optical depth 5, each of many particles, which glow in one colour and dim in another.
inline BenchScene makeNebula(std::size_t n)
{
  constexpr int clouds = 40;
  std::mt19937_64 random(2);
  std::normal_distribution<float> normal;
  std::uniform_real_distribution<float> uniform(-6, 6);
  float middle[clouds][3];
  for (auto& cloud : middle)
  {
    std::generate_n(cloud, 3, [&] { return uniform(random); });
  }
  BenchScene scene;
  scene.reserve(n);
  // Through the middle of a cloud, exp(-r^2 / 2), of cross-section K there is K / (2 pi).
  const float K = 5 * 2 * 3.14159265F * clouds / n;
  for (std::size_t i = 0; i < n; ++i)
  {
    const float* cloud = middle[i % clouds];
    const float p[3] = { cloud[0] + normal(random), cloud[1] + normal(random),
      cloud[2] + normal(random) };
    const float L[3] = { K * (i % 3 ? 1.0F : 0.2F), 0.6F * K, K * (i % 5 ? 0.5F : 1.5F) };
    const float dims[3] = { 0.7F * K, K, 1.4F * K };
    scene.add(p, 0.3F, L, dims);
  }
  return scene;
}

/// Looks at the origin from 100 kpc away, so far that half the picture is `halfWidth` kpc.
inline Camera benchCamera(const Vec3& from, const Vec3& up, double halfWidth, int size)
{
  const double angle = 360 / M_PI * std::atan(halfWidth / 100);
  return Camera::lookAt(100 * from, {}, up, false, 1, angle, size, size);
}

/// A scene file, or so many particles of makeDisc.
inline BenchScene benchScene(const std::string& source)
{
  const bool isNumber = source.find_first_not_of("0123456789") == std::string::npos;
  return isNumber ? makeDisc(std::stoull(source)) : readScene(source);
}

/// What the drawing of a disc is measured with, 1024 x 1024.
struct BenchView
{
  const char* name;
  Vec3 eye, up;     ///< the eye looks at the origin
  double halfWidth; ///< of the picture there, kpc
  bool hasGas;

  Camera camera() const
  {
    const double angle = 360 / M_PI * std::atan(this->halfWidth / length(this->eye));
    return Camera::lookAt(this->eye, {}, this->up, false, 1, angle, 1024, 1024);
  }
};
inline const Vec3 faceOn = { 0, 0, 100 }, edgeOn = { 100, 0, 0 }, north = { 0, 1, 0 },
                  axis = { 0, 0, 1 };
inline const BenchView benchViews[] = { { "wide/face-on", faceOn, north, 42, true },
  { "wide/edge-on", edgeOn, axis, 42, true }, { "close/face-on", faceOn, north, 10, true },
  { "close/edge-on", edgeOn, axis, 10, true }, { "stars/face-on", faceOn, north, 10, false },
  { "stars/edge-on", edgeOn, axis, 10, false } };
/// From the middle of the disc's plane, among its particles, with 90 degrees from side to side.
inline const BenchView insideView = { "inside", { 8, 0, 0 }, axis, 8, true };
} // namespace galaxy

#endif
