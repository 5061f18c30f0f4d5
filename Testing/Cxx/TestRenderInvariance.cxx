#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <omp.h>
#include <random>

namespace
{
using namespace galaxy;

TEST(RenderInvariance, ShuffledParticlesMakeTheSamePicture)
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

TEST(RenderInvariance, AnyNumberOfThreadsMakesTheSamePicture)
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

TEST(RenderInvariance, OpaqueGeometryHidesWhatIsBehindIt)
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
      EXPECT_NEAR(image.radiance[left], all.radiance[left], 1e-6 * all.radiance[left]);
      EXPECT_NEAR(image.radiance[right + 1], near.radiance[right + 1], 1e-6);
      EXPECT_EQ(image.radiance[right], 0);
    }
  }
}

TEST(RenderInvariance, TranslationByMegaparsecsChangesNothing)
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

TEST(RenderInvariance, AFullTurnChangesNothing)
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

TEST(RenderInvariance, WhatHasNoMeaningIsDroppedAndCounted)
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

TEST(RenderInvariance, BehindTheEyeAndExtremeLightStayHarmless)
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

TEST(RenderInvariance, AbortLeavesAnEmptyPicture)
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

TEST(RenderInvariance, AParticleWiderThanTheScreenIsFlat)
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

TEST(RenderInvariance, NothingToDrawIsAnEmptyPicture)
{
  const auto image = renderSorted({}, testCamera(false));
  EXPECT_EQ(image.radiance.size(), 3u * 200 * 150);
  EXPECT_EQ(largest(image.radiance), 0);
  EXPECT_EQ(image.transmittance[17], 1.0f);
  EXPECT_EQ(activeEffects(image.statistics), "nothing in view");
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

TEST(RenderInvariance, ComponentsEmitOrAbsorbAndHaveTheirFactors)
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
  EXPECT_EQ(activeEffects(a.statistics),
    "emission; per-channel absorption; depth order among 1 absorbers and 2 emitters");
}

TEST(RenderInvariance, HiddenComponentsAreCulled)
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

TEST(RenderInvariance, EmissionAndAbsorptionReplaceIntensityAndColor)
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
  EXPECT_EQ(activeEffects(renderSorted(view, testCamera(true)).statistics),
    "emission; grey absorption; depth order among 1 absorbers and 2 emitters");
}
TEST(RenderInvariance, BehindWhatLetsNothingThroughNothingIsDrawn)
{
  // A wall over the whole view, tau of some hundred, and ten thousand lights behind it.
  Scene scene = randomScene(10000, false);
  for (std::size_t i = 0; i < scene.h.size(); ++i)
  {
    scene.position[3 * i] *= 0.1f;
    scene.position[3 * i + 1] *= 0.1f;
    scene.position[3 * i + 2] -= 30;
  }
  for (int k = 0; k < 20; ++k)
  {
    scene.add({ 0, 0, -10.0 + 0.1 * k }, 60, {}, { 2e4f, 2e4f, 2e4f });
  }
  scene.add({ 0, 0, 5 }, 3, { 1, 2, 3 });
  const auto image = renderSorted(scene.view(), testCamera(true, 24, 24));
  const auto slow = renderReference(scene.view(), testCamera(true, 24, 24));
  EXPECT_GT(image.statistics.untouched, 5000u);
  EXPECT_LT(largestDifference(image.radiance, slow.radiance), 1e-6 * largest(slow.radiance));
  EXPECT_EQ(largest(image.transmittance), 0);
  // Where more than nothing would come through, all is drawn unless it is said to be negligible.
  for (std::size_t i = 0; i < scene.absorption.size(); ++i)
  {
    scene.absorption[i] *= 0.1f;
  }
  RenderOptions options;
  EXPECT_EQ(renderSorted(scene.view(), testCamera(true, 24, 24), options).statistics.untouched, 0u);
  options.allowed = { 1e-3, 1e-3 };
  const auto less = renderBounded(scene.view(), testCamera(true, 24, 24), options);
  const auto all = renderReference(scene.view(), testCamera(true, 24, 24));
  EXPECT_GT(less.statistics.untouched, 5000u);
  EXPECT_LT(largestDifference(less.radiance, all.radiance), options.allowed.light);
}
} // namespace
