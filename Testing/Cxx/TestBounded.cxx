// Bounded pictures against the reference: never off by more than was allowed, whatever the scene.
#include "Filters/Splatting/ToneMap.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

/// The largest error over what the bound allows it to be; rounding, as Sorted has it, apart.
double excess(const RenderedImage& image, const RenderedImage& exact, const ErrorBound& bound)
{
  const double rounding = 1e-5 * largest(exact.radiance);
  double most = 0;
  for (std::size_t k = 0; k < image.radiance.size(); ++k)
  {
    const double light = std::abs(double(image.radiance[k]) - exact.radiance[k]);
    most = std::max(most, light / (bound.light + bound.share * exact.radiance[k] + rounding));
    const double through = std::abs(double(image.transmittance[k]) - exact.transmittance[k]);
    most = std::max(most, through / (bound.share + 1e-5));
  }
  return most;
}

/// Draws it with so much allowed; checks what was promised and what was reported.
RenderStatistics check(const Scene& scene, const Camera& camera, const ErrorBound& allowed)
{
  RenderOptions options;
  options.allowed = allowed;
  const auto image = renderBounded(scene.view(), camera, options);
  const auto exact = renderReference(scene.view(), camera);
  const ErrorBound& reported = image.statistics.bound;
  EXPECT_LE(excess(image, exact, reported), 1);
  EXPECT_LE(reported.light, allowed.light * (1 + 1e-9));
  EXPECT_LE(reported.share, allowed.share * (1 + 1e-9));
  return image.statistics;
}

/// Lights behind `count` sheets over the whole view, of optical depth `tau` together.
Scene lightsBehindSheets(int lights, int count, double tau)
{
  Scene scene;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int k = 0; k < lights; ++k)
  {
    scene.add({ 2 * uniform(random) - 1, 2 * uniform(random) - 1, -20 - 5 * uniform(random) }, 0.2,
      { uniform(random), 1, 0.5F });
  }
  for (int k = 0; k < count; ++k)
  {
    // In the middle of so wide a particle its weight is 9 / (pi h^2).
    const float K = static_cast<float>(tau / count * M_PI * 60 * 60 / 9);
    scene.add({ 0, 0, -10 + 0.01 * k }, 60, {}, { K, 0.9F * K, K });
  }
  return scene;
}

TEST(Bounded, IsWithinWhatIsAllowed)
{
  const double white =
    largest(renderReference(randomScene(4000, true).view(), testCamera(true)).radiance);
  for (const double tolerance : { 1e-4, 1.0 / 512, 0.02, 0.2 })
  {
    for (const bool parallel : { true, false })
    {
      for (const unsigned seed : { 1U, 2U })
      {
        check(randomScene(4000, true, seed), testCamera(parallel),
          { 0.5 * tolerance * white, 0.5 * tolerance });
      }
    }
  }
}

TEST(Bounded, LeavesOutWhatCannotBeSeen)
{
  // Faint lights by the thousand, which together are less than is allowed, and some bright ones.
  Scene scene;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-5, 5);
  for (int k = 0; k < 5000; ++k)
  {
    const float L = k < 100 ? 1 : 1e-9F;
    scene.add({ uniform(random), uniform(random), uniform(random) }, 0.3, { L, L, L });
  }
  EXPECT_GT(check(scene, testCamera(true), { 1e-3, 0 }).faint, 4900U);
  EXPECT_EQ(check(scene, testCamera(true), { 1e-30, 0 }).faint, 0U);
  EXPECT_GT(check(scene, testCamera(true), { 1e9, 0.5 }).faint, 5000U); // all of them
}

TEST(Bounded, ManyFaintLightsThatAddUpAreKept)
{
  // Each of them is far below what is allowed, in one place they are white.
  Scene scene;
  for (int k = 0; k < 20000; ++k)
  {
    scene.add({ 0.05, 0.05, 0.001 * k }, 0.3, { 1e-4F, 1e-4F, 1e-4F });
  }
  const auto exact = renderReference(scene.view(), testCamera(true, 20, 20));
  const auto done = check(scene, testCamera(true, 20, 20), { largest(exact.radiance) / 512, 0 });
  EXPECT_LT(done.faint, 20000U / 256);
}

TEST(Bounded, DrawingEndsBehindDustOnlyWhereNothingMoreIsSeen)
{
  for (const double tau : { 1.0, 5.0, 8.0, 12.0, 30.0 })
  {
    const Scene scene = lightsBehindSheets(3000, 50, tau);
    const auto done = check(scene, testCamera(true, 24, 24), { 0.05, 1e-3 });
    EXPECT_EQ(done.untouched > 0, tau > 20) << tau;
  }
}

TEST(Bounded, OneBrightLightBehindManyFaintOnesAndDustIsSeen)
{
  // What is left behind the dust is bounded by the brightest, not by what came before.
  Scene scene = lightsBehindSheets(4000, 50, 9);
  scene.add({ 0.05, 0.05, -50 }, 0.3, { 1e6F, 1e6F, 1e6F });
  check(scene, testCamera(true, 24, 24), { 0.05, 1e-3 });
}

TEST(Bounded, ThinDustNeedsNoOrderThickDustDoes)
{
  for (const double tau : { 1e-4, 1e-3, 1e-2, 0.5 })
  {
    Scene scene = lightsBehindSheets(300, 20, tau);
    for (int k = 0; k < 300; ++k)
    {
      scene.add({ 0, 0, -9.9 + 0.001 * k }, 1, { 0.1F, 0, 0 }); // among the sheets
    }
    const auto done = check(scene, testCamera(true, 24, 24), { 0, 4e-3 });
    EXPECT_EQ(done.tiles.unordered() > 0, tau < 9e-4) << tau;
  }
}

TEST(Bounded, ThinAbsorbersThatAddUpAreKept)
{
  const Scene scene = lightsBehindSheets(100, 20000, 2);
  EXPECT_LT(check(scene, testCamera(true, 8, 8), { 0, 1.0 / 256 }).faint, 100U);
}

TEST(Bounded, NothingAllowedIsTheSortedPicture)
{
  const Scene scene = randomScene(3000, true);
  RenderOptions options;
  const auto a = renderBounded(scene.view(), testCamera(true), options);
  const auto b = renderSorted(scene.view(), testCamera(true));
  EXPECT_EQ(a.radiance, b.radiance);
  EXPECT_EQ(a.transmittance, b.transmittance);
  EXPECT_EQ(a.statistics.bound.light, 0);
}

ToneMap withLevels(ToneMap map, std::array<double, 3> black, std::array<double, 3> white)
{
  map.black = black;
  map.white = white;
  return map;
}

TEST(Bounded, OnTheDisplayNothingIsOffByMoreThanTheTolerance)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const ToneMap& map :
    { ToneMap{ 1, 10, 1 }, ToneMap{ 1, 0, 1 }, ToneMap{ 3, 1000, 2.2 }, ToneMap{ 1e-4, 0.1, 0.5 },
      ToneMap{ 20, 100, 1 }, withLevels({ 1, 10, 1 }, { 0.2, 0.1, 0 }, { 1, 0.5, 3 }),
      withLevels({ 3, 100, 2.2 }, { 0, 5, 0 }, { 10, 6, 20 }),
      withLevels({ 1, 0, 0.5 }, { -0.3, 0.01, 0.5 }, { 1, 0.02, 0.6 }) })
  {
    for (const double tolerance : { 1.0 / 512, 0.05 })
    {
      const ErrorBound allowed = allowedError(map, tolerance);
      double most = 0;
      for (int trial = 0; trial < 50000; ++trial)
      {
        float light[2][3], display[2][3];
        for (int c = 0; c < 3; ++c)
        {
          const double above =
            (map.white[c] - map.black[c]) * std::pow(10, 9 * uniform(random) - 7);
          const double l = std::max(0.0, map.black[c] + above) / map.exposure;
          const double worst = allowed.light + allowed.share * l;
          const double off = worst * (trial % 2 ? 2 * uniform(random) - 1 : trial & 2 ? 1 : -1);
          light[0][c] = static_cast<float>(l);
          light[1][c] = static_cast<float>(std::max(0.0, l + off));
        }
        applyToneMap(map, light[0], display[0], 1);
        applyToneMap(map, light[1], display[1], 1);
        for (int c = 0; c < 3; ++c)
        {
          most = std::max(most, std::abs(double(display[0][c]) - display[1][c]));
        }
      }
      EXPECT_LE(most, tolerance);
      EXPECT_GT(most, tolerance / 40) << "needlessly strict";
    }
  }
}
} // namespace
