#include "Filters/Splatting/Render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <omp.h>
#include <random>

namespace
{
using namespace galaxy;

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
Camera testCamera(bool parallel, int width = 200, int height = 150)
{
  const double halfHeight = 0.05 * height;
  return Camera::lookAt({ 0, 0, 100 }, {}, { 0, 1, 0 }, parallel, halfHeight,
    360 / M_PI * std::atan(halfHeight / 100), width, height);
}

/// A cloud wider than the view, with particles from far below a pixel to a tenth of the view.
Scene randomScene(int n, bool withAbsorption, unsigned seed = 1)
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

double total(const RenderedImage& image, int channel = 0)
{
  double sum = 0;
  for (std::size_t i = channel; i < image.radiance.size(); i += 3)
  {
    sum += image.radiance[i];
  }
  return sum;
}

double largest(const std::vector<float>& v)
{
  return *std::max_element(v.begin(), v.end());
}

double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
{
  double difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    difference = std::max(difference, std::abs(double(a[i]) - b[i]));
  }
  return difference;
}

std::size_t pixelAt(const RenderedImage& image, int x, int y)
{
  return 3 * (std::size_t(y) * image.width + x);
}

constexpr double pixelArea = 0.1 * 0.1;
const Kernel kernels[] = { Kernel::Gaussian, Kernel::CubicSpline };

TEST(Render, LightIsKeptForAnySizeAndPlace)
{
  for (const Kernel kernel : kernels)
  {
    for (const bool parallel : { true, false })
    {
      for (const double sigma : { 0.0, 0.001, 0.01, 0.3, 0.8, 1.3, 2.4, 2.6, 3.0, 30.0 })
      {
        for (const double offset : { 0.0, 0.05, 0.013, 0.0999 })
        {
          Scene scene;
          scene.add({ offset, offset / 2, 0 }, 3 * 0.1 * sigma, { 2, 1, 0 });
          RenderOptions options;
          options.kernel = kernel;
          const auto image = renderSorted(scene.view(), testCamera(parallel, 400, 400), options);
          EXPECT_NEAR(total(image) * pixelArea, 2, 2 * 1e-4) << sigma << ' ' << offset;
          EXPECT_NEAR(total(image, 1) * pixelArea, 1, 1e-4);
          EXPECT_EQ(total(image, 2), 0);
          EXPECT_EQ(image.statistics.drawn, 1u);
        }
      }
    }
  }
}

TEST(Render, AParticleBelowAPixelAtACornerIsShared)
{
  Scene scene;
  scene.add({ 0, 0, 0 }, 1e-4, { 4, 0, 0 });
  for (const Kernel kernel : kernels)
  {
    RenderOptions options;
    options.kernel = kernel;
    const auto image = renderSorted(scene.view(), testCamera(true), options);
    for (const auto& [x, y] : { std::pair(99, 74), { 100, 74 }, { 99, 75 }, { 100, 75 } })
    {
      EXPECT_NEAR(image.radiance[pixelAt(image, x, y)] * pixelArea, 1, 1e-3);
    }
  }
}

TEST(Render, WideGaussianIsTheFormula)
{
  const double sigma = 2; // kpc, 20 pixels
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 3 * sigma, { 1, 1, 1 });
  const auto image = renderSorted(scene.view(), testCamera(true));
  const double norm = 1 / (M_PI * sigma * sigma * (1 - std::exp(-9.0)));
  for (int x = 100; x < 200; x += 7)
  {
    const double b = 0.1 * (x - 100);
    const double G = b < 3 * sigma + 0.05 ? norm * std::exp(-b * b / (sigma * sigma)) : 0;
    EXPECT_NEAR(image.radiance[pixelAt(image, x, 75)], G, 6e-4 * norm) << x;
  }
}

TEST(Render, WideSplineIsTheFormula)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 6, { 1, 1, 1 });
  RenderOptions options;
  options.kernel = Kernel::CubicSpline;
  const auto image = renderSorted(scene.view(), testCamera(true), options);
  // c(b/h) of the spline with h half the support, at b/h = 0, 0.2, ... (quadrature).
  const double c[] = { .47746, .45194, .38357, .29030, .19308, .11104, .05438, .02108, .00538 };
  for (int k = 0; k < 9; ++k)
  {
    const double G = c[k] / 9;
    EXPECT_NEAR(image.radiance[pixelAt(image, 100 + 6 * k, 75)], G, 5e-4 * c[0] / 9) << k;
  }
}

TEST(Render, FootprintGrowsSmoothlyThroughEveryRegime)
{
  for (const Kernel kernel : kernels)
  {
    RenderOptions options;
    options.kernel = kernel;
    double last = 0;
    for (double h = 12; h > 0.05; h *= 0.997) // pixels
    {
      Scene scene;
      scene.add({ 0.05, 0.05, 0 }, 0.1 * h, { 1, 0, 0 });
      const auto image = renderSorted(scene.view(), testCamera(true, 40, 40), options);
      const double center = *std::max_element(image.radiance.begin(), image.radiance.end());
      EXPECT_TRUE(last == 0 || (center > 0.9995 * last && center < 1.008 * last)) << h;
      last = center;
    }
    EXPECT_NEAR(last * pixelArea, 1, 1e-4);
  }
}

/// Light behind a screen and before it, on the line of sight of one pixel.
TEST(Render, AbsorberDimsWhatIsBehindItOnly)
{
  const double h = 3;
  const double G = 1 / (M_PI * (1 - std::exp(-9.0))); // at the centre, sigma = 1 kpc
  for (const float K : { 1e-6f, 0.1f, 1.0f, 10.0f, 100.0f })
  {
    for (const bool parallel : { true, false })
    {
      Scene behind;
      behind.add({ 0.05, 0.05, -1 }, h, { 1, 1, 1 });
      behind.add({ 0.05, 0.05, 0 }, h, {}, { K, 2 * K, 0 });
      Scene before = behind;
      before.position[2] = 1;
      const auto image = renderSorted(behind.view(), testCamera(parallel));
      const std::size_t p = pixelAt(image, 100, 75);
      const double L = image.radiance[p + 2]; // the channel that nothing dims
      const double t = -std::log(image.transmittance[p]);
      EXPECT_NEAR(L, G, 0.03 * G);
      if (K <= 10)
      {
        EXPECT_NEAR(t, K * G, 0.003 * K * G + 1e-7);
      }
      EXPECT_NEAR(image.radiance[p], L * std::exp(-K * G), 0.003 * L);
      EXPECT_NEAR(image.radiance[p + 1], L * std::exp(-2 * K * G), 0.006 * L);
      EXPECT_EQ(image.transmittance[p + 2], 1.0f);
      const auto other = renderSorted(before.view(), testCamera(parallel));
      EXPECT_FLOAT_EQ(other.radiance[p], other.radiance[p + 2]);
      EXPECT_FLOAT_EQ(other.transmittance[p], image.transmittance[p]);
    }
  }
}

TEST(Render, AParticleThatGlowsAndAbsorbsEmitsPhi)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 3, { 1, 1, 1 }, { 0, 3, 1e-30f });
  const auto image = renderSorted(scene.view(), testCamera(true));
  const std::size_t p = pixelAt(image, 100, 75);
  const double e = image.radiance[p];
  const double t = 3 * e;
  EXPECT_NEAR(image.radiance[p + 1], e * (1 - std::exp(-t)) / t, 3e-7 * e);
  EXPECT_FLOAT_EQ(image.radiance[p + 2], e);
}

TEST(Render, CoincidentParticlesAreTakenInTheOrderOfTheirIndex)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 3, { 1, 1, 1 });
  scene.add({ 0.05, 0.05, 0 }, 3, {}, { 3, 3, 3 });
  const auto dimmed = renderSorted(scene.view(), testCamera(false));
  const auto free = renderSorted(scene.inOrder({ 1, 0 }).view(), testCamera(false));
  const std::size_t p = pixelAt(dimmed, 100, 75);
  EXPECT_NEAR(dimmed.radiance[p], free.radiance[p] * dimmed.transmittance[p], 1e-7);
  EXPECT_LT(dimmed.radiance[p], 0.5 * free.radiance[p]);
}

TEST(Render, TwoHalvesMakeOneParticle)
{
  Scene one, two;
  one.add({ 0.03, 0.02, 0 }, 2, { 1, 2, 3 }, { 1, 2, 30 });
  two.add({ 0.03, 0.02, 0 }, 2, { 0.5f, 1, 1.5f }, { 0.5f, 1, 15 });
  two.add({ 0.03, 0.02, 0 }, 2, { 0.5f, 1, 1.5f }, { 0.5f, 1, 15 });
  const auto a = renderSorted(one.view(), testCamera(true));
  const auto b = renderSorted(two.view(), testCamera(true));
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 5e-7 * largest(a.radiance));
  EXPECT_LT(largestDifference(a.transmittance, b.transmittance), 2e-7);
}

TEST(Render, ZeroCrossSectionIsAbsorptionAbsent)
{
  Scene scene = randomScene(3000, false);
  ParticleView without = scene.view();
  without.absorption = nullptr;
  const auto a = renderSorted(scene.view(), testCamera(false));
  const auto b = renderSorted(without, testCamera(false));
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.transmittance, b.transmittance);
  EXPECT_EQ(a.statistics.activeEffects, "emission; no absorber, no sort");
  EXPECT_EQ(largest(a.transmittance), 1.0f);
  EXPECT_EQ(*std::min_element(a.transmittance.begin(), a.transmittance.end()), 1.0f);
}

TEST(Render, ManyFaintParticlesAddUp)
{
  // In float alone the emitters drift by 1e-4 and the absorbers vanish altogether.
  const int n = 2000000;
  Scene scene;
  scene.add({ 0.01, 0.01, -5 }, 0.3, { 1, 1, 1 });
  for (int i = 0; i < n; ++i)
  {
    scene.add({ 0.01, 0.01, 1e-4 * (i % 1000) }, 0.3, { 0.1f, 0, 0 }, { 0, 5e-9f, 0 });
  }
  const auto image = renderSorted(scene.view(), testCamera(true, 16, 16));
  Scene single;
  single.add({ 0.01, 0.01, -5 }, 0.3, { 1, 0, 0 });
  const auto one = renderSorted(single.view(), testCamera(true, 16, 16));
  const std::size_t p = pixelAt(image, 8, 8);
  const double w = one.radiance[p];
  EXPECT_NEAR(image.radiance[p] / (w * (1 + 0.1f * double(n))), 1, 1e-6);
  const double tau = double(n) * 5e-9f * w;
  EXPECT_NEAR(-std::log(double(image.transmittance[p + 1])), tau, 2e-5 * tau + 1e-7);
  EXPECT_NEAR(image.radiance[p + 1] / (w * std::exp(-tau)), 1, 1e-6);
}

TEST(Render, MatchesTheReference)
{
  for (const bool absorption : { false, true })
  {
    const Scene scene = randomScene(5000, absorption);
    for (const Kernel kernel : kernels)
    {
      for (const bool parallel : { true, false })
      {
        RenderOptions options;
        options.kernel = kernel;
        const auto fast = renderSorted(scene.view(), testCamera(parallel), options);
        const auto slow = renderReference(scene.view(), testCamera(parallel), options);
        EXPECT_LT(largestDifference(fast.radiance, slow.radiance), 1e-5 * largest(slow.radiance));
        EXPECT_LT(largestDifference(fast.transmittance, slow.transmittance), 1e-5);
        EXPECT_EQ(fast.statistics.drawn, slow.statistics.drawn);
        EXPECT_GT(fast.statistics.drawn, 3000u);
        EXPECT_GT(fast.statistics.culled, 0u);
        const float darkest =
          *std::min_element(slow.transmittance.begin(), slow.transmittance.end());
        EXPECT_TRUE(absorption ? darkest < 0.5f : darkest == 1.0f);
      }
    }
  }
}

TEST(Render, ShuffledParticlesMakeTheSamePicture)
{
  Scene scene = randomScene(4000, true);
  for (int i = 0; i < 4000; ++i)
  {
    scene.position[3 * i + 2] = 0.004f * i - 8; // no two depths alike
  }
  std::vector<int> order(4000);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const auto a = renderSorted(scene.view(), testCamera(true));
  const auto b = renderSorted(scene.inOrder(order).view(), testCamera(true));
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.transmittance, b.transmittance);
}

TEST(Render, AnyNumberOfThreadsMakesTheSamePicture)
{
  Scene scene = randomScene(6000, true);
  for (std::size_t i = 0; i < scene.h.size(); i += 2)
  {
    scene.position[3 * i + 2] = 1; // equal depths: the index must decide
  }
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = renderSorted(scene.view(), testCamera(true));
  for (const int n : { 2, 5 })
  {
    omp_set_num_threads(n);
    const auto other = renderSorted(scene.view(), testCamera(true));
    EXPECT_EQ(one.radiance, other.radiance);
    EXPECT_EQ(one.transmittance, other.transmittance);
    EXPECT_EQ(one.statistics.drawn, other.statistics.drawn);
  }
  omp_set_num_threads(threads);
}

TEST(Render, OpaqueGeometryHidesWhatIsBehindIt)
{
  Scene scene;
  scene.add({ 0.05, 0.05, -3 }, 2, { 1, 1, 1 });
  scene.add({ 0.05, 0.05, 3 }, 2, { 0, 1, 0 }, { 1, 1, 1 });
  Scene front = scene.inOrder({ 1 });
  for (const Kernel kernel : kernels)
  {
    for (const bool parallel : { true, false })
    {
      const Camera camera = testCamera(parallel);
      std::vector<float> depth(200 * 150, 1e30f);
      for (std::size_t i = 0; i < depth.size(); ++i)
      {
        depth[i] = i % 200 < 100 ? 1e30f : 100.0f; // the right half stands at the origin
      }
      RenderOptions options;
      options.kernel = kernel;
      options.opaqueDepth = depth.data();
      const auto image = renderSorted(scene.view(), camera, options);
      const auto slow = renderReference(scene.view(), camera, options);
      EXPECT_LT(largestDifference(image.radiance, slow.radiance), 1e-6 * largest(slow.radiance));
      options.opaqueDepth = nullptr;
      const auto all = renderSorted(scene.view(), camera, options);
      const auto near = renderSorted(front.view(), camera, options);
      const std::size_t left = pixelAt(image, 98, 75);
      const std::size_t right = pixelAt(image, 102, 75);
      EXPECT_EQ(image.radiance[left], all.radiance[left]);
      EXPECT_EQ(image.radiance[right + 1], near.radiance[right + 1]);
      EXPECT_EQ(image.radiance[right], 0);
    }
  }
}

TEST(Render, TranslationByMegaparsecsChangesNothing)
{
  // Positions are whole multiples of the spacing of floats at 5 Mpc, so that only the rendering
  // could lose digits.
  Scene near = randomScene(2000, true);
  for (float& x : near.position)
  {
    x = std::round(x * 1024) / 1024;
  }
  Scene far = near;
  for (std::size_t i = 0; i < far.h.size(); ++i)
  {
    far.position[3 * i] += 5000;
  }
  Camera camera = testCamera(false);
  const auto a = renderSorted(near.view(), camera);
  camera.eye.x += 5000;
  const auto b = renderSorted(far.view(), camera);
  EXPECT_LE(largestDifference(a.radiance, b.radiance), 1e-6 * largest(a.radiance));
}

TEST(Render, AFullTurnChangesNothing)
{
  const Scene scene = randomScene(2000, true);
  const auto turned = [&](double angle) {
    const Vec3 eye{ 100 * std::sin(angle), 0, 100 * std::cos(angle) };
    return renderSorted(
      scene.view(), Camera::lookAt(eye, {}, { 0, 1, 0 }, false, 1, 8.5, 200, 150));
  };
  const auto a = turned(0.3);
  const auto b = turned(0.3 + 2 * M_PI);
  const auto other = turned(0.3 + M_PI);
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 1e-5 * largest(a.radiance));
  EXPECT_GT(largestDifference(a.radiance, other.radiance), 1e-2 * largest(a.radiance));
}

TEST(Render, WhatHasNoMeaningIsDroppedAndCounted)
{
  Scene good = randomScene(100, true);
  Scene bad = good;
  const float inf = INFINITY;
  bad.add({ NAN, 0, 0 }, 1, { 1, 1, 1 });
  bad.add({ 0, inf, 0 }, 1, { 1, 1, 1 });
  bad.add({ 0, 0, 0 }, NAN, { 1, 1, 1 });
  bad.add({ 0, 0, 0 }, inf, { 1, 1, 1 });
  bad.add({ 0, 0, 0 }, -1, { 1, 1, 1 });
  bad.add({ 0, 0, 0 }, 1, { 1, NAN, 1 });
  bad.add({ 0, 0, 0 }, 1, { 1, 1, -1 });
  bad.add({ 0, 0, 0 }, 1, { 1, 1, inf });
  bad.add({ 0, 0, 0 }, 1, { 1, 1, 1 }, { NAN, 0, 0 });
  const auto a = renderSorted(good.view(), testCamera(false));
  const auto b = renderSorted(bad.view(), testCamera(false));
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(b.statistics.invalid, 9u);
  EXPECT_EQ(a.statistics.invalid, 0u);
  EXPECT_EQ(b.statistics.drawn + b.statistics.culled + b.statistics.invalid, 109u);
}

TEST(Render, BehindTheEyeAndExtremeLightStayHarmless)
{
  Scene scene;
  scene.add({ 0, 0, 100 }, 1, { 1, 1, 1 });
  scene.add({ 0, 0, 101 }, 1, { 1, 1, 1 });
  scene.add({ 0, 0, 100 - 1e-6 }, 1e-3, { 1e38f, 1e38f, 1e38f });
  scene.add({ 0, 0, 0 }, 0, { 0, 0, 0 });
  scene.add({ 0, 0, 0 }, 1e30, { 1e30f, 1, 1 }, { 1, 1, 1e30f });
  for (const Kernel kernel : kernels)
  {
    RenderOptions options;
    options.kernel = kernel;
    const auto image = renderSorted(scene.view(), testCamera(false), options);
    for (std::size_t i = 0; i < image.radiance.size(); ++i)
    {
      ASSERT_TRUE(std::isfinite(image.radiance[i]));
      ASSERT_TRUE(image.transmittance[i] >= 0 && image.transmittance[i] <= 1);
    }
  }
}

TEST(Render, AbortLeavesAnEmptyPicture)
{
  const Scene scene = randomScene(3000, true);
  for (const int allowed : { 0, 1, 3 })
  {
    int calls = 0;
    double last = -1;
    RenderOptions options;
    options.progress = [&](double done) {
      EXPECT_GE(done, last);
      last = done;
      return calls++ < allowed;
    };
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const auto image = renderSorted(scene.view(), testCamera(false), options);
    omp_set_num_threads(threads);
    EXPECT_TRUE(image.aborted);
    EXPECT_EQ(calls, allowed + 1);
    EXPECT_EQ(largest(image.radiance), 0);
    EXPECT_EQ(*std::min_element(image.transmittance.begin(), image.transmittance.end()), 1.0f);
  }
}

TEST(Render, AParticleWiderThanTheScreenIsFlat)
{
  Scene scene;
  scene.add({ 3000, 0, 0 }, 3e4, { 1, 2, 4 });
  scene.add({ 0, 0, 0 }, 1e6, { 0, 0, 1e6f });
  for (const Kernel kernel : kernels)
  {
    RenderOptions options;
    options.kernel = kernel;
    const auto image = renderSorted(scene.view(), testCamera(true), options);
    const auto slow = renderReference(scene.view(), testCamera(true), options);
    EXPECT_LT(largestDifference(image.radiance, slow.radiance), 1e-5 * largest(slow.radiance));
    const auto [least, most] = std::pair(image.radiance[0], image.radiance[3 * 29999]);
    EXPECT_NEAR(least / most, 1, 0.01);
    EXPECT_GT(least, 0);
  }
}

TEST(Render, NothingToDrawIsAnEmptyPicture)
{
  const auto image = renderSorted({}, testCamera(false));
  EXPECT_EQ(image.radiance.size(), 3u * 200 * 150);
  EXPECT_EQ(largest(image.radiance), 0);
  EXPECT_EQ(image.transmittance[17], 1.0f);
  EXPECT_EQ(image.statistics.activeEffects, "nothing in view");
  EXPECT_TRUE(renderSorted({}, testCamera(false, 0, 0)).radiance.empty());
}

/// Intensity and colour with a component table, as the galaxy model makes them.
struct ComponentScene
{
  std::vector<float> position{ 0.05f, 0.05f, 0, 0.05f, 0.05f, 1, 0.05f, 0.05f, 2 };
  std::vector<float> h{ 1, 1, 1 };
  std::vector<float> intensity{ 6, 2, 1 };
  std::vector<std::uint8_t> color{ 255, 51, 0, 255, 255, 255, 0, 0, 255 };
  std::vector<std::uint8_t> component{ 0, 1, 2 };
  std::vector<ComponentInfo> components{ 3 };

  ParticleView view() const
  {
    ParticleView view;
    view.size = 3;
    view.position = this->position.data();
    view.smoothingLength = this->h.data();
    view.intensity = this->intensity.data();
    view.color = this->color.data();
    view.component = this->component.data();
    view.components = &this->components;
    return view;
  }
};

TEST(Render, ComponentsEmitOrAbsorbAndHaveTheirFactors)
{
  ComponentScene scene;
  scene.components[1].absorbs = true;
  scene.components[1].absorption = { 0, 1, 2 };
  scene.components[2].brightness = 3;
  scene.components[2].size = 0.5;
  Scene same;
  same.add({ 0.05f, 0.05f, 0 }, 1, { 6, 6 * 0.2f, 0 });
  same.add({ 0.05f, 0.05f, 1 }, 1, {}, { 0, 2, 4 });
  same.add({ 0.05f, 0.05f, 2 }, 0.5, { 0, 0, 3 });
  const auto a = renderSorted(scene.view(), testCamera(true));
  const auto b = renderSorted(same.view(), testCamera(true));
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 2e-7 * largest(b.radiance));
  EXPECT_LT(largestDifference(a.transmittance, b.transmittance), 2e-7);
  EXPECT_EQ(a.statistics.activeEffects,
    "emission; per-channel absorption; depth order among 1 absorbers and 2 emitters");
}

TEST(Render, HiddenComponentsAreCulled)
{
  const ComponentScene scene;
  const std::vector<bool> visible{ false, true, false };
  ParticleView view = scene.view();
  view.visible = &visible;
  const auto image = renderSorted(view, testCamera(true));
  EXPECT_EQ(image.statistics.drawn, 1u);
  EXPECT_EQ(image.statistics.culled, 2u);
  EXPECT_NEAR(total(image) * pixelArea, 2, 2e-4);
}

TEST(Render, EmissionAndAbsorptionReplaceIntensityAndColor)
{
  const ComponentScene scene;
  const std::vector<float> L{ 1, 2, 3 };
  ParticleView view = scene.view();
  view.emission = L.data();
  view.emissionChannels = 1;
  const auto image = renderSorted(view, testCamera(true));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(total(image, c) * pixelArea, 6, 6e-4);
  }
  const std::vector<float> K{ 0, 0, 1e-3f };
  view.absorption = K.data();
  view.absorptionChannels = 1;
  EXPECT_EQ(renderSorted(view, testCamera(true)).statistics.activeEffects,
    "emission; grey absorption; depth order among 1 absorbers and 2 emitters");
}
} // namespace
