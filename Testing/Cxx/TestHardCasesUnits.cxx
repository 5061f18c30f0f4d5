// Light and cross-sections in any unit, absorbers of any depth: letters of TestHardCasesLight.
#include "HardCaseTable.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using namespace galaxy;

constexpr double pi = 3.14159265358979323846;

RenderedImage drawn(const Scene& scene, int size = 8)
{
  return renderSorted(scene.view(), testCamera(true, size, size));
}

/// Of the pixel in the middle.
double light(const RenderedImage& image, int channel = 0)
{
  return image.radiance[pixelAt(image, image.width / 2, image.height / 2) + channel];
}
double through(const RenderedImage& image)
{
  return image.transmittance[pixelAt(image, image.width / 2, image.height / 2)];
}

/// The picture, and the same of light and cross-sections in other units; both in the first one's.
RenderedImage inUnits(const Scene& scene, const Camera& camera, Accuracy accuracy, int exponent)
{
  Scene other = scene;
  for (float& L : other.emission)
  {
    L = std::ldexp(L, exponent);
  }
  RenderOptions options;
  options.accuracy = accuracy;
  options.allowed = { std::ldexp(1e-4, exponent), 1e-4 };
  auto image = render(other.view(), camera, options);
  for (float& I : image.radiance)
  {
    I = std::ldexp(I, -exponent);
  }
  return image;
}

TEST(HardCasesUnits, AnyUnitOfLuminosity)
{
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Overlapping })
  {
    const Scene scene = randomScene(accuracy == Accuracy::Overlapping ? 300 : 1500, true);
    for (const bool parallel : { true, false })
    {
      const Camera camera = testCamera(parallel, 48, 48);
      const auto once = inUnits(scene, camera, accuracy, 0);
      EXPECT_GT(largest(once.radiance), 0);
      // Up to 3e38 in the picture, and to 3e37 a particle.
      for (const int exponent : { -90, -60, 60, 90, 116 })
      {
        const auto image = inUnits(scene, camera, accuracy, exponent);
        const bool isBounded = accuracy == Accuracy::Bounded;
        checkSame("D", "the same in other units of light", once, image, isBounded ? 2e-4 : 1e-6);
        EXPECT_EQ(image.statistics.drawn, once.statistics.drawn);
        EXPECT_EQ(image.statistics.tooBright, 0U);
      }
    }
  }
}

TEST(HardCasesUnits, PhysicalUnitsThroughAFineCamera)
{
  // 1e35 erg/s a particle, at 10 to 1e6 pixels a kpc: what a pixel has is at most 1e38 per kpc^2.
  for (const double scale : { 10.0, 1e3, 1e6 })
  {
    Camera camera = testCamera(true, 16, 16);
    camera.scale = scale;
    const double h = scale > 10 ? 0.3 : 3;
    Scene scene;
    scene.add({ 0, 0, 0 }, h, { 1e35F, 1e35F, 1 });
    scene.add({ 0, 0, 0 }, h, { 1, 0, 0 });
    scene.add({ 0, 0, -1 }, h, { 0, 1e35F, 0 }, { 0, 1e-3F, 0 });
    const auto image = renderSorted(scene.view(), camera);
    const auto exact = renderReference(scene.view(), camera);
    EXPECT_EQ(image.statistics.drawn, 3U);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_GT(light(exact, c), 0);
    }
    check("D", "1e35 a particle", light(exact, 0), light(image, 0), 1e-6);
    check("D", "1e35 a particle, dimmed", light(exact, 1), light(image, 1), 1e-6);
    check("D", "the middle of a kernel", 9 / (pi * h * h) * 1e35, light(image, 0), 0.05);
  }
}

TEST(HardCasesUnits, OnlyWhatThePictureCannotHoldIsTooMuch)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 0 }, 1e-3, { 1e38F, 1e36F, 1 });
  const auto image = drawn(scene);
  EXPECT_EQ(light(image, 0), std::numeric_limits<float>::max());
  check("D", "1e36 in one pixel", 1e38, light(image, 1), 1e-6);
  check("D", "beside 1", 100, light(image, 2), 1e-6);
  EXPECT_EQ(image.statistics.tooBright, 1U);
  EXPECT_EQ(renderReference(scene.view(), testCamera(true, 8, 8)).statistics.tooBright, 1U);
}

TEST(HardCasesUnits, BrightnessFactorsThatUndoUnits)
{
  // Physical units by a factor, and the other way round; of what shines and of what dims.
  for (const double factor : { 1e-40, 1e-30, 1e30, 1e40 })
  {
    const auto given = static_cast<float>(1 / std::sqrt(factor) / std::sqrt(factor));
    const float L = std::isfinite(given) && given > 0 ? given : factor > 1 ? 1e-38F : 1e38F;
    std::vector<ComponentInfo> components(2);
    components[0].brightness = components[1].brightness = factor;
    components[1].absorbs = true;
    const std::vector<float> position = { 0.05F, 0.05F, 0, 0.05F, 0.05F, 1 }, h = { 1, 1 },
                             intensity = { L, 0.1F * L };
    const std::vector<std::uint8_t> component = { 0, 1 };
    ParticleView view;
    view.size = 2;
    view.position = position.data();
    view.smoothingLength = h.data();
    view.intensity = intensity.data();
    view.component = component.data();
    view.components = &components;
    const auto image = renderSorted(view, testCamera(true, 8, 8));
    const double drawnAs = factor * L;
    Scene plain;
    plain.add({ 0.05, 0.05, 0 }, 1, { 1, 1, 1 });
    const double peak = light(drawn(plain));
    EXPECT_EQ(image.statistics.drawn, 2U);
    check(
      "D", "brightness undoes the unit, T", std::exp(-0.1 * drawnAs * peak), through(image), 1e-5);
    check("D", "brightness undoes the unit", drawnAs * peak * std::exp(-0.1 * drawnAs * peak),
      light(image), 1e-5);
  }
}

TEST(HardCasesUnits, AnyCrossSection)
{
  // A slab of any cross-section has its source's light where it is opaque, and dims what is behind.
  for (const float K : { 1e4F, 1e10F, 1e30F, 3.4e38F })
  {
    Scene scene;
    scene.add({ 0.05, 0.05, -1 }, 3, { 1, 1, 1 });
    scene.add({ 0.05, 0.05, 0 }, 3, { 0.25F * K, 1e-10F * K, 0 }, { K, K, K });
    const auto image = drawn(scene);
    EXPECT_EQ(image.statistics.drawn, 2U);
    check("E", "source of an opaque slab", 0.25, light(image, 0), 1e-6);
    check("E", "and of a dark one", 1e-10, light(image, 1), 1e-6);
    check("E", "and behind it", 0, light(image, 2), 0);
    check("E", "nothing comes through", 0, through(image), 0);
  }
}

TEST(HardCasesUnits, VeryThickAbsorbersLetThroughWhatTheirEdgesDo)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const Kernel kernel : kernels)
  {
    for (const double h : { 0.002, 0.03, 0.2, 0.45, 1.0, 5.0 })
    {
      for (const double depth : { 1e3, 1e4, 1e6, 1e9 })
      {
        Scene dark;
        for (int k = 0; k < 3; ++k)
        {
          const auto K = static_cast<float>(depth * std::max(h * h, 0.01));
          dark.add({ 1.5 * uniform(random), 1.5 * uniform(random), k - 1.0 }, h, {},
            { K, 0.1F * K, 0.01F * K });
        }
        Scene lit = dark;
        lit.add({ 0, 0, -9 }, 4, { 1, 1, 1 });
        RenderOptions options;
        options.kernel = kernel;
        for (const bool parallel : { true, false })
        {
          const Camera camera = testCamera(parallel, 40, 40);
          for (const Scene* scene : { &dark, &lit })
          {
            const auto image = renderSorted(scene->view(), camera, options);
            const auto exact = renderReference(scene->view(), camera, options);
            const double most = std::max(largest(exact.radiance), 1e-30);
            EXPECT_LT(largestDifference(image.transmittance, exact.transmittance), 2e-5)
              << h << ' ' << depth << ' ' << parallel;
            EXPECT_LT(largestDifference(image.radiance, exact.radiance), 2e-5 * most)
              << h << ' ' << depth << ' ' << parallel;
          }
        }
      }
    }
  }
}

TEST(HardCasesUnits, NothingIsNegativeAndNothingShinesThroughMoreThanAll)
{
  for (const bool parallel : { true, false })
  {
    for (const Kernel kernel : kernels)
    {
      for (const unsigned seed : { 1U, 2U, 3U })
      {
        Scene scene = randomScene(3000, seed != 3, seed);
        Camera camera = testCamera(parallel, 96, 96);
        camera.eye.z = seed == 2 ? 2 : 100; // among them
        RenderOptions options;
        options.kernel = kernel;
        options.allowed = { 1e-4, 1e-4 };
        for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Preview })
        {
          options.accuracy = accuracy;
          const auto image = render(scene.view(), camera, options);
          EXPECT_GE(*std::min_element(image.radiance.begin(), image.radiance.end()), 0);
          EXPECT_GE(*std::min_element(image.transmittance.begin(), image.transmittance.end()), 0);
          EXPECT_LE(largest(image.transmittance), 1);
        }
      }
    }
  }
}
} // namespace
