#ifndef galaxy_RenderFixtures_h
#define galaxy_RenderFixtures_h

#include "Filters/Splatting/Render.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace galaxy
{
struct Scene
{
  std::vector<float> position, h, emission, absorption;

  void add(const Vec3& p, double radius, std::array<float, 3> L, std::array<float, 3> K = {})
  {
    for (const double x : { p.x, p.y, p.z })
    {
      this->position.push_back(static_cast<float>(x));
    }
    this->h.push_back(static_cast<float>(radius));
    this->emission.insert(this->emission.end(), L.begin(), L.end());
    this->absorption.insert(this->absorption.end(), K.begin(), K.end());
  }
  ParticleView view() const
  {
    ParticleView view;
    view.size = this->h.size();
    view.position = this->position.data();
    view.smoothingLength = this->h.data();
    view.emission = this->emission.data();
    view.absorption = this->absorption.data();
    return view;
  }
  Scene inOrder(const std::vector<int>& order) const
  {
    Scene scene;
    for (const int i : order)
    {
      const auto triple = [i](const std::vector<float>& v) {
        return std::array<float, 3>{ v[3 * i], v[3 * i + 1], v[3 * i + 2] };
      };
      const auto p = triple(this->position);
      scene.add({ p[0], p[1], p[2] }, this->h[i], triple(this->emission), triple(this->absorption));
    }
    return scene;
  }
};

/// Seen from z = 100 kpc, 200 x 150 pixels of 0.1 kpc in the plane z = 0.
inline Camera testCamera(bool parallel, int width = 200, int height = 150)
{
  const double halfHeight = 0.05 * height;
  return Camera::lookAt({ 0, 0, 100 }, {}, { 0, 1, 0 }, parallel, halfHeight,
    360 / M_PI * std::atan(halfHeight / 100), width, height);
}

/// A cloud wider than the view, with particles from far below a pixel to a tenth of the view.
inline Scene randomScene(int n, bool withAbsorption, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Scene scene;
  for (int i = 0; i < n; ++i)
  {
    const Vec3 p{ 24 * uniform(random) - 12, 18 * uniform(random) - 9, 16 * uniform(random) - 8 };
    const double radius = 0.003 * std::pow(600, uniform(random));
    const bool dust = withAbsorption && i % 3 == 0;
    const float K = dust ? static_cast<float>(2 * radius * radius * uniform(random)) : 0;
    const float L = i % 9 == 0 && dust ? 0 : uniform(random);
    scene.add(p, radius, { L, L * uniform(random), 0.5f * L }, { 0.8f * K, K, 1.3f * K });
  }
  return scene;
}

inline double total(const RenderedImage& image, int channel = 0)
{
  double sum = 0;
  for (std::size_t i = channel; i < image.radiance.size(); i += 3)
  {
    sum += image.radiance[i];
  }
  return sum;
}

inline double largest(const std::vector<float>& v)
{
  return *std::max_element(v.begin(), v.end());
}

inline double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    difference = std::max(difference, std::abs(double(a[i]) - b[i]));
  }
  return difference;
}

inline std::size_t pixelAt(const RenderedImage& image, int x, int y)
{
  return 3 * (std::size_t(y) * image.width + x);
}

constexpr double pixelArea = 0.1 * 0.1;
const Kernel kernels[] = { Kernel::Gaussian, Kernel::CubicSpline };
}

#endif
