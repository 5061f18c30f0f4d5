// Only what the scene calls for is computed, and the picture is that of the whole computation.
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

/// A scene in which everything emits what it absorbs times `source`, channel by channel.
Scene oneSourceScene(const std::array<float, 3>& source)
{
  Scene scene = randomScene(3000, true);
  for (std::size_t i = 0; i < scene.h.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      scene.emission[3 * i + c] = source[c] * scene.absorption[3 * i + c];
    }
  }
  return scene;
}

/// Checks a picture against the reference; its statistics.
RenderStatistics check(const Scene& scene, Kernel kernel = Kernel::Gaussian)
{
  RenderOptions options;
  options.kernel = kernel;
  const auto image = renderSorted(scene.view(), testCamera(false), options);
  const auto exact = renderReference(scene.view(), testCamera(false), options);
  EXPECT_LE(largestDifference(image.radiance, exact.radiance), 1e-5 * largest(exact.radiance));
  EXPECT_LE(largestDifference(image.transmittance, exact.transmittance), 1e-5);
  return image.statistics;
}

TEST(ActiveEffects, OneSourceFunctionNeedsNoOrder)
{
  for (const Kernel kernel : kernels)
  {
    const auto statistics = check(oneSourceScene({ 3, 0.2F, 7 }), kernel);
    EXPECT_EQ(
      activeEffects(statistics), "emission; per-channel absorption; one source function, no sort");
    EXPECT_GT(statistics.tiles.unordered(), 10U);
  }
  // The light is S (1 - T).
  const auto image = renderSorted(oneSourceScene({ 3, 0, 1 }).view(), testCamera(true));
  for (std::size_t k = 0; k < image.radiance.size(); k += 3)
  {
    ASSERT_NEAR(image.radiance[k], 3 * (1 - image.transmittance[k]), 1e-6);
    ASSERT_EQ(image.radiance[k + 1], 0);
  }
}

TEST(ActiveEffects, AbsorbersAloneNeedNoOrder)
{
  const auto statistics = check(oneSourceScene({ 0, 0, 0 }));
  EXPECT_EQ(activeEffects(statistics), "per-channel absorption; one source function, no sort");
}

TEST(ActiveEffects, OneParticleOfAnotherSourceAsksForOrderWhereItIs)
{
  Scene scene = oneSourceScene({ 3, 0.2F, 7 });
  scene.add({ 0, 0, 0 }, 0.5, { 20, 20, 20 });
  const auto statistics = check(scene);
  EXPECT_GT(statistics.tiles.unordered(), 10U);
  EXPECT_NE(activeEffects(statistics).find("none in"), std::string::npos)
    << activeEffects(statistics);
  scene.emission[0] *= 1.01F;
  check(scene);
}

TEST(ActiveEffects, NoAbsorberNoSort)
{
  const auto statistics = check(randomScene(3000, false));
  EXPECT_EQ(activeEffects(statistics), "emission; no absorber, no sort");
}

TEST(ActiveEffects, EmittersAmongThemselvesHaveNoOrder)
{
  // The light of emitters in turned order is the same to the last digits that are rounded.
  const Scene scene = randomScene(3000, false);
  std::vector<int> turned(3000);
  for (int i = 0; i < 3000; ++i)
  {
    turned[i] = 2999 - i;
  }
  const auto a = renderSorted(scene.view(), testCamera(true));
  const auto b = renderSorted(scene.inOrder(turned).view(), testCamera(true));
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 1e-6 * largest(a.radiance));
}

TEST(ActiveEffects, GreyAbsorptionIsColouredAbsorptionOfEqualChannels)
{
  Scene grey = randomScene(3000, true), nearly = grey;
  for (std::size_t i = 0; i < grey.h.size(); ++i)
  {
    const float K = grey.absorption[3 * i];
    const float above = std::nextafter(K, 1.0F);
    for (int c = 0; c < 3; ++c)
    {
      grey.absorption[3 * i + c] = K;
      nearly.absorption[3 * i + c] = c == 2 ? above : K;
    }
  }
  EXPECT_NE(activeEffects(check(grey)).find("grey absorption"), std::string::npos);
  EXPECT_NE(activeEffects(check(nearly)).find("per-channel absorption"), std::string::npos);
  const auto a = renderSorted(grey.view(), testCamera(true));
  const auto b = renderSorted(nearly.view(), testCamera(true));
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 1e-6 * largest(a.radiance));
  EXPECT_LT(largestDifference(a.transmittance, b.transmittance), 1e-6);
}

TEST(ActiveEffects, WhatIsOutOfSightIsNotDrawn)
{
  Scene scene = randomScene(500, true);
  const auto without = renderSorted(scene.view(), testCamera(false));
  for (int k = 0; k < 100; ++k)
  {
    scene.add({ 1000.0 + k, 0, 0 }, 0.5, { 1, 1, 1 });     // beside
    scene.add({ 0, 0, 200.0 + k }, 0.5, { 1, 1, 1 });      // behind the eye
    scene.add({ 0, 0, 0 }, 0.5, { 0, 0, 0 }, { 0, 0, 0 }); // nothing
  }
  const auto with = renderSorted(scene.view(), testCamera(false));
  EXPECT_EQ(with.radiance, without.radiance);
  EXPECT_EQ(with.statistics.drawn, without.statistics.drawn);
  EXPECT_EQ(with.statistics.culled, without.statistics.culled + 300);
}
} // namespace
