// The same picture from every instruction set that the machine has, and right for every slab.
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <hwy/targets.h>

#include <cmath>

namespace
{
using namespace galaxy;

/// Calls test(name) with the engine held to each of the sets in turn.
template <typename Test>
void forEachInstructionSet(Test test)
{
  for (const int64_t target : { HWY_SCALAR, HWY_SSE4, HWY_AVX2, HWY_AVX3 })
  {
    if (target == HWY_SCALAR || (hwy::SupportedTargets() & target))
    {
      hwy::SetSupportedTargetsForTest(target);
      test(hwy::TargetName(target));
      hwy::SetSupportedTargetsForTest(0);
    }
  }
}

TEST(InstructionSets, AllMakeTheSamePicture)
{
  for (const bool absorption : { false, true })
  {
    const Scene scene = randomScene(5000, absorption);
    for (const bool parallel : { true, false })
    {
      const auto best = renderSorted(scene.view(), testCamera(parallel));
      int sets = 0;
      forEachInstructionSet([&](const char* name) {
        const auto image = renderSorted(scene.view(), testCamera(parallel));
        EXPECT_LT(largestDifference(image.radiance, best.radiance), 1e-6 * largest(best.radiance))
          << name;
        // Where one particle alone has an optical depth of 6, float's erf, rounded near 1, shows.
        EXPECT_LT(largestDifference(image.transmittance, best.transmittance), 4e-6) << name;
        EXPECT_EQ(image.statistics.drawn, best.statistics.drawn);
        ++sets;
      });
      EXPECT_GE(sets, 2);
    }
  }
}

TEST(InstructionSets, EverySlabKeepsAndEmitsWhatItShould)
{
  // One slab before a light, t from far below a float's digits to opaque, through both formulas.
  const double sigma = 0.5;
  Scene light;
  light.add({ 0.05, 0.05, -3 }, 3 * sigma, { 1, 0, 0 });
  const auto alone = renderSorted(light.view(), testCamera(true, 8, 8));
  const std::size_t p = pixelAt(alone, 4, 4);
  const double w = alone.radiance[p];
  forEachInstructionSet([&](const char* name) {
    for (double t = 1e-12; t<300; t *= t> 0.05 && t < 1 ? 1.02 : 1.7)
    {
      Scene scene = light;
      scene.add({ 0.05, 0.05, 0 }, 3 * sigma, { 0, 1, 0 },
        { static_cast<float>(t / w), static_cast<float>(t / w), 0 });
      const auto image = renderSorted(scene.view(), testCamera(true, 8, 8));
      // Below 2^-20 the transmittance may be as much behind.
      ASSERT_NEAR(image.radiance[p], w * std::exp(-t), w * 1.3e-6) << name << ' ' << t;
      ASSERT_NEAR(image.radiance[p + 1] / (w * -std::expm1(-t) / t), 1, 1e-6) << name << ' ' << t;
      ASSERT_NEAR(image.transmittance[p], std::exp(-t), 3e-7) << name << ' ' << t;
    }
  });
}
}
