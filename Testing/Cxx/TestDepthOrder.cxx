// Particles in the order of their true depths, however far apart the nearest and the farthest are.
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

/// A dense clump of light and dust, of depths that differ by what float can tell apart there.
Scene clump(unsigned seed, double extent)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Scene scene;
  for (int i = 0; i < 400; ++i)
  {
    const float L = i % 2 ? 1.0F : 0.0F, K = i % 2 ? 0.0F : 0.005F;
    scene.add({ 0.8 * uniform(random), 0.8 * uniform(random), extent * uniform(random) }, 0.3,
      { L, 0.5F * L, L }, { K, K, 2 * K });
  }
  return scene;
}

TEST(DepthOrder, NearPairsKeepTheirOrderHoweverFarTheFarthestIs)
{
  for (const bool parallel : { true, false })
  {
    for (const double extent : { 1e-2, 1e-5, 1e-9 })
    {
      for (const double far : { 0.0, 1e3, 1e6, 1e12, 1e25 })
      {
        Scene scene = clump(3, extent);
        if (far > 0)
        {
          // Behind the same tile, as large as it is far.
          scene.add({ 0, 0, -far }, parallel ? 1 : 0.01 * far, { 1, 1, 1 });
        }
        const Camera camera = testCamera(parallel, 32, 32);
        const auto image = renderSorted(scene.view(), camera);
        const auto exact = renderReference(scene.view(), camera);
        EXPECT_LT(largestDifference(image.radiance, exact.radiance), 1e-5 * largest(exact.radiance))
          << parallel << ' ' << extent << ' ' << far;
      }
    }
  }
}

TEST(DepthOrder, ManyDecadesOfDepthInOneTileAreOrdered)
{
  // By pairs that are ever closer to each other, ever nearer to the eye.
  Scene scene;
  for (int k = 0; k < 60; ++k)
  {
    const double distance = std::pow(10.0, 6 - 0.2 * k), gap = 1e-6 * distance;
    const double h = 0.02 * distance;
    const auto L = static_cast<float>(distance * distance), K = static_cast<float>(0.1 * h * h);
    scene.add({ 0, 0, -distance }, h, { L, L, L });
    scene.add({ 0, 0, -distance + (k % 2 ? gap : -gap) }, h, {}, { K, 2 * K, K });
  }
  Camera camera = testCamera(false, 32, 32);
  camera.eye = {};
  const auto image = renderSorted(scene.view(), camera);
  const auto exact = renderReference(scene.view(), camera);
  EXPECT_GT(largest(exact.radiance), 0);
  EXPECT_LT(largestDifference(image.radiance, exact.radiance), 1e-5 * largest(exact.radiance));
}

TEST(DepthOrder, ShuffledParticlesOfTheSameDepthsGiveTheSamePicture)
{
  Scene scene = clump(5, 1);
  for (std::size_t i = 0; i < scene.h.size(); ++i)
  {
    scene.position[3 * i + 2] = 0.25F * static_cast<float>(i % 5);
  }
  scene.add({ 0, 0, -1e9 }, 1, { 1, 1, 1 });
  std::vector<int> order(scene.h.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<int>(i * 97 % order.size());
  }
  const Scene shuffled = scene.inOrder(order);
  for (const bool parallel : { true, false })
  {
    const auto a = renderSorted(scene.view(), testCamera(parallel, 32, 32));
    const auto b = renderSorted(shuffled.view(), testCamera(parallel, 32, 32));
    EXPECT_LT(largestDifference(a.radiance, b.radiance), 2e-6 * largest(a.radiance));
    EXPECT_LT(largestDifference(a.transmittance, b.transmittance), 2e-6);
  }
}

TEST(DepthOrder, OpaqueGeometryHidesByTrueDistanceHoweverFarTheFarthestIs)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 1, { 1, 1, 1 });
  scene.add({ 0, 0, -1e12 }, 1, { 1, 1, 1 });
  const Camera camera = testCamera(true, 8, 8);
  for (const float behind : { -0.01F, 0.01F })
  {
    const std::vector<float> depth(64, 100 + behind);
    RenderOptions options;
    options.opaqueDepth = depth.data();
    const auto image = renderSorted(scene.view(), camera, options);
    EXPECT_EQ(largest(image.radiance) > 0, behind > 0);
  }
}
} // namespace
