#include "Filters/Model/HilbertOrder.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>

#include <set>

namespace galaxy
{
TEST(HilbertOrder, VisitsEveryCellOnceWithoutAJump)
{
  std::set<std::pair<int, int>> visited;
  int column = -1, row = 0, jumps = 0;
  HilbertOrder(16, 16, [&](int u, int v) {
    visited.insert({ u, v });
    jumps += column >= 0 && std::abs(u - column) + std::abs(v - row) != 1;
    column = u;
    row = v;
  });
  EXPECT_EQ(visited.size(), 256u);
  EXPECT_EQ(jumps, 0);
  visited.clear();
  HilbertOrder(5, 11, [&](int u, int v) { visited.insert({ u, v }); });
  EXPECT_EQ(visited.size(), 55u);
}

TEST(LightMap, HasTheImagesPixels)
{
  const double pixel = 10 * m83Kpc;
  const LightMap map = lightMap(
    101, [](double x, double y) { return 0.5 + 0.02 * x - 0.01 * y; }, 10);
  ASSERT_GE(map.width(), 101);
  EXPECT_NEAR(map.pixelSide(), pixel, 1e-6);
  double total = 0;
  for (double x = -50 * pixel; x < 50.1 * pixel; x += pixel)
  {
    for (double y = -50 * pixel; y < 50.1 * pixel; y += pixel)
    {
      const std::uint32_t at = map.pixelAt(x, y);
      ASSERT_NE(at, LightMap::nowhere);
      const double intensity = 0.5 + 0.02 * x - 0.01 * y;
      EXPECT_NEAR(map.intensity(at), intensity, 1e-5);
      EXPECT_NEAR(map.flux(at) / (intensity * pixel * pixel), 1, 1e-4);
      total += map.flux(at);
      const PixelPosition middle = map.pointIn(at, 0.5, 0.5);
      EXPECT_NEAR(middle.x, x, 0.01 * pixel);
      EXPECT_NEAR(middle.y, y, 0.01 * pixel);
      // And back, from anywhere in the pixel.
      const PixelPosition corner = map.pointIn(at, 0.01, 0.99);
      EXPECT_EQ(map.pixelAt(corner.x, corner.y), at);
    }
  }
  EXPECT_NEAR(map.totalFlux() / total, 1, 1e-6);
  EXPECT_EQ(map.pixelAt(1000, 0), LightMap::nowhere);
  EXPECT_EQ(map.pixelAt(std::nan(""), 0), LightMap::nowhere);
}

TEST(LightMap, LayersMixTheirColours)
{
  const SkyImage even = skyImage(
    60, [](double, double) { return 0.8; }, 30);
  const SkyImage west = skyImage(
    60, [](double x, double) { return x > 0 ? 0.4 : 0.1; }, 30);
  LayerDescription red = clippedLayer();
  red.color = { 1, 0, 0 };
  red.weight = 0.5;
  LayerDescription blue = clippedLayer();
  blue.color = { 0, 0, 1 };
  blue.weight = 2;
  blue.threshold = 0.2;
  const std::vector<SeedLayer> layers = { layerOf(even, red), layerOf(west, blue) };
  const LightMap map(layers, {}, 15, "");
  for (const double x : { -5.0, 5.0 })
  {
    const std::uint32_t pixel = map.pixelAt(x, 1);
    EXPECT_NEAR(map.intensity(pixel), x > 0 ? 0.8 : 0.4, 1e-6);
    EXPECT_EQ(map.color(pixel)[0], x > 0 ? 128 : 255);
    EXPECT_EQ(map.color(pixel)[1], 0);
    EXPECT_EQ(map.color(pixel)[2], x > 0 ? 255 : 0);
  }
  // Below its threshold a layer is dark.
  const LightMap half({ layers[1] }, {}, 15, "");
  EXPECT_EQ(half.flux(half.pixelAt(-5, 1)), 0);
  // An absorber counts optical depth, not colour.
  ComponentDescription dust;
  dust.role = ComponentRole::Absorbs;
  LayerDescription black = clippedLayer();
  black.color = { 0, 0, 0 };
  const LightMap absorbing({ layerOf(even, black) }, dust, 15, "");
  EXPECT_NEAR(absorbing.intensity(absorbing.pixelAt(1, 1)), 0.8, 1e-6);
  // A hook may change the colour, such as for dust in front.
  const LightMap dimmed({ layerOf(even, red) }, {}, 15, "", [](double, double, Color& color) {
    color = { 0.5 * color[0], 0.3, 0 };
  });
  EXPECT_NEAR(dimmed.intensity(dimmed.pixelAt(1, 1)), 0.3, 1e-6);
  EXPECT_EQ(dimmed.color(dimmed.pixelAt(1, 1))[0], 170);
}

TEST(LightMap, ReachesAsFarAsTheWidestAndIsAsFineAsTheFinest)
{
  const SkyImage sharp = skyImage(
    100, [](double, double) { return 0.5; }, 5); // 12 kpc
  const SkyImage wide = skyImage(
    60, [](double x, double) { return 0.5 + 0.01 * x; }, 25); // 36 kpc
  const LightMap map(
    { layerOf(sharp, clippedLayer()), layerOf(wide, clippedLayer()) }, {}, 100, "");
  EXPECT_NEAR(map.pixelSide(), 5 * m83Kpc, 1e-6);
  EXPECT_NEAR(map.width() * map.pixelSide(), 36, 3);
  EXPECT_NEAR(map.intensity(map.pixelAt(1, 0)), 0.5 + 0.51, 1e-3);
  // The coarse image is interpolated: no steps of 0.006.
  for (double x = 8; x < 15; x += 0.12)
  {
    EXPECT_NEAR(map.intensity(map.pixelAt(x, 3)), 0.5 + 0.01 * x, 0.0008) << x;
  }
  // Only what lies within the radius.
  const LightMap cut({ layerOf(wide, clippedLayer()) }, {}, 5, "");
  EXPECT_NEAR(cut.width() * cut.pixelSide(), 10, 1.3);
  EXPECT_EQ(cut.pixelAt(8, 0), LightMap::nowhere);
  const SkyImage tiny = skyImage(
    3, [](double, double) { return 0.5; }, 0.01);
  EXPECT_THROW(
    LightMap({ layerOf(tiny, clippedLayer()), layerOf(wide, clippedLayer()) }, {}, 100, "a.galaxy"),
    Error);
}

TEST(LightMap, HalvingKeepsTheFlux)
{
  LightMap map = lightMap(
    51, [](double x, double y) { return x * y > 0 ? 0.7 : 0.0; }, 20);
  const TiltedDisk face(flatDisk(100), m83Distance);
  const DiskInverse sky(face, 0, 100);
  const double flux = map.totalFlux(), side = map.pixelSide();
  const std::size_t lit = map.litPixels(sky);
  const std::uint32_t old = map.pixelAt(3, 3);
  const float before = map.flux(old);
  map.halve();
  EXPECT_EQ(map.bins(), 2);
  EXPECT_NEAR(map.totalFlux() / flux, 1, 1e-6);
  EXPECT_NEAR(map.pixelSide(), 2 * side, 1e-12);
  EXPECT_LT(map.litPixels(sky), lit / 3);
  const std::uint32_t pixel = map.pixelAt(3, 3);
  EXPECT_NEAR(map.flux(pixel) / before, 4, 1e-3);
  EXPECT_NEAR(map.intensity(pixel), 0.7, 1e-5);
  const PixelPosition at = map.pointIn(pixel, 0.3, 0.8);
  EXPECT_EQ(map.pixelAt(at.x, at.y), pixel);
  for (int k = 0; k < 7; ++k)
  {
    map.halve();
  }
  EXPECT_EQ(map.size(), 1u);
  EXPECT_NEAR(map.totalFlux() / flux, 1, 1e-6);
}
} // namespace galaxy
