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
          // In perspective the image plane has d/z^3 of a ball's light, on average over the ball;
          // the kernels' variances are h^2/18 and 3 h^2/40.
          const double s2 =
            (kernel == Kernel::Gaussian ? 1 / 18.0 : 3 / 40.0) * std::pow(0.3 * sigma / 100, 2);
          const double ball = parallel ? 1 : 1 + 4 * s2;
          EXPECT_NEAR(total(image) * pixelArea, 2 * ball, 2 * 1e-4) << sigma << ' ' << offset;
          EXPECT_NEAR(total(image, 1) * pixelArea, ball, 1e-4);
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

TEST(Render, DepthsThatSinglePrecisionCannotTellApartKeepTheirOrder)
{
  // From 100 kpc away, 1e-7 kpc behind each other, and something else far behind in the same tile.
  for (const bool parallel : { true, false })
  {
    for (const float gap : { 1e-7F, -1e-7F })
    {
      Scene scene;
      scene.add({ 0.05, 0.05, gap }, 0.3, { 1, 1, 1 });
      scene.add({ 0.05, 0.05, 0 }, 0.3, {}, { 0.1F, 0.1F, 0.1F });
      scene.add({ 1, 1, -30 }, 0.1, { 1, 1, 1 });
      const auto image = renderSorted(scene.view(), testCamera(parallel));
      const auto exact = renderReference(scene.view(), testCamera(parallel));
      EXPECT_LT(largestDifference(image.radiance, exact.radiance), 1e-6 * largest(exact.radiance));
    }
  }
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
  EXPECT_EQ(activeEffects(a.statistics), "emission; no absorber, no sort");
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

TEST(Render, RaysMayPassParticlesInAnotherOrderThanThatOfTheCentres)
{
  const Scene scene = randomScene(400, true);
  for (const Kernel kernel : kernels)
  {
    RenderOptions options;
    options.kernel = kernel;
    const auto centres = renderReference(scene.view(), testCamera(true, 60, 60), options);
    const auto rays = renderInOrderOfRays(scene.view(), testCamera(true, 60, 60), options);
    EXPECT_EQ(centres.radiance, rays.radiance);
    EXPECT_EQ(centres.transmittance, rays.transmittance);
  }
  // The centre of the dust, aside, is farther from the eye than the star is; on the ray
  // through the star it lies before it.
  Scene pair;
  pair.add({ 0.05, 0.05, 98.05 }, 0.05, { 1, 1, 1 });
  pair.add({ 0.6, 0.05, 98.1 }, 0.9, { 0, 0, 0 }, { 3, 3, 3 });
  const Camera camera = testCamera(false, 10, 10);
  const auto centres = renderReference(pair.view(), camera);
  const auto rays = renderInOrderOfRays(pair.view(), camera);
  EXPECT_LT(total(rays), 0.9 * total(centres));
  EXPECT_EQ(centres.transmittance, rays.transmittance);
}
}
