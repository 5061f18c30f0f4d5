// Pictures of a random part of the particles: right on average, and what they say they are.
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/SpreadAbsorbers.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace
{
using namespace galaxy;

TEST(Preview, ASampleHasEveryParticleOnceAndAsGivenInRandomOrder)
{
  const Scene scene = randomScene(1000, true);
  const PreviewSample sample(scene.view());
  ASSERT_EQ(sample.size(), 1000U);
  const ParticleView all = sample.first(2000, scene.view());
  EXPECT_EQ(all.size, 1000U);
  EXPECT_EQ(all.weight, 1);
  std::set<float> positions;
  double rising = 0;
  for (std::size_t k = 0; k < all.size; ++k)
  {
    positions.insert(all.position[3 * k]);
    const auto found = std::find(scene.position.begin(), scene.position.end(), all.position[3 * k]);
    const std::size_t i = (found - scene.position.begin()) / 3;
    EXPECT_EQ(all.smoothingLength[k], scene.h[i]);
    EXPECT_EQ(all.emission[3 * k + 1], scene.emission[3 * i + 1]);
    EXPECT_EQ(all.absorption[3 * k + 2], scene.absorption[3 * i + 2]);
    rising += (double(i) - 499.5) * (double(k) - 499.5);
  }
  EXPECT_EQ(positions.size(), 1000U);
  const double correlation = 12 * rising / 1e9;
  EXPECT_LT(std::abs(correlation), 0.15);
}

TEST(Preview, LightAndDepthAreRightOnAverage)
{
  // Every particle has the same chance, wherever it stands: quarters of the list shine in channels.
  Scene scene;
  for (int i = 0; i < 40000; ++i)
  {
    const int quarter = i / 10000;
    std::array<float, 3> L{ 0, 0, 0 }, K{ 0, 0, 0 };
    (quarter < 3 ? L[quarter] : K[0]) = quarter < 3 ? 1 : 5e-7F;
    scene.add({ quarter < 3 ? 0.05 : 2.05, 0.05, 0 }, 0.001, L, K);
  }
  const PreviewSample sample(scene.view(), 10000);
  for (const std::size_t count : { 10000U, 2500U })
  {
    const auto image = renderSorted(sample.first(count, scene.view()), testCamera(true));
    for (int c = 0; c < 3; ++c)
    {
      // Binomial: a quarter of the sample, three standard deviations.
      const double noise = 3 * std::sqrt(0.75 / (0.25 * double(count)));
      EXPECT_NEAR(total(image, c) * pixelArea / 1e4, 1, noise) << c;
    }
    const double tau = -std::log(image.transmittance[pixelAt(image, 120, 75)]);
    EXPECT_NEAR(tau / 0.5, 1, 3 * std::sqrt(0.75 / (0.25 * double(count))));
  }
}

TEST(Preview, ErrorFallsWithTheRootOfTheSample)
{
  const Scene scene = randomScene(20000, true);
  const auto exact = renderSorted(scene.view(), testCamera(true));
  const PreviewSample sample(scene.view());
  double last = 0;
  for (const std::size_t count : { 500U, 2000U, 8000U })
  {
    const auto image = renderSorted(sample.first(count, scene.view()), testCamera(true));
    double square = 0;
    for (std::size_t k = 0; k < image.radiance.size(); ++k)
    {
      square += std::pow(double(image.radiance[k]) - exact.radiance[k], 2);
    }
    const double error = std::sqrt(square);
    if (last > 0)
    {
      EXPECT_GT(last / error, 1.4) << count;
      EXPECT_LT(last / error, 3.5) << count;
    }
    last = error;
  }
}

TEST(Preview, IsTheWholePictureWhereTimeAllows)
{
  const Scene scene = randomScene(3000, true);
  RenderOptions options;
  options.accuracy = Accuracy::Preview;
  options.previewTime = 1000;
  const auto image = render(scene.view(), testCamera(true), options);
  const auto exact = renderSorted(scene.view(), testCamera(true));
  EXPECT_EQ(image.statistics.sampled, 3000U);
  EXPECT_LT(largestDifference(image.radiance, exact.radiance), 1e-5 * largest(exact.radiance));
}

/// Stars and dust by turns, each where its own function of three random numbers says. Half of the
/// dust is one-coloured.
Scene starsAndDust(int n, double depth, double area, double h,
  const std::function<Vec3(double, double, double)>& star,
  const std::function<Vec3(double, double, double)>& dust)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  Scene scene;
  for (int i = 0; i < n; ++i)
  {
    const double u = uniform(random), v = uniform(random), w = uniform(random);
    const float K = static_cast<float>(depth * area / (0.5 * n));
    const bool isStar = i % 2 == 0, isGrey = i % 4 == 1;
    isStar ? scene.add(star(u, v, w), 0.05, { 1, 0.5F, 2 })
           : scene.add(dust(u, v, w), h, {}, { K, isGrey ? K : 0.7F * K, isGrey ? K : 0.4F * K });
  }
  return scene;
}

double meanOf(const std::vector<float>& values, int channel)
{
  double sum = 0;
  for (std::size_t k = channel; k < values.size(); k += 3)
  {
    sum += values[k];
  }
  return sum / (double(values.size()) / 3);
}

/// The mean light of samples of any size, over that of all.
void expectMeanLight(const std::string& name, const ParticleView& all, double mostTau = 3.1,
  Kernel kernel = Kernel::Gaussian)
{
  RenderOptions options;
  options.kernel = kernel;
  const PreviewSample sample(all);
  for (const bool parallel : { true, false })
  {
    const Camera camera = testCamera(parallel);
    const auto exact = renderSorted(all, camera, options);
    EXPECT_LT(-std::log(meanOf(exact.transmittance, 0)), mostTau) << name;
    for (const double part : { 0.3, 0.1, 0.05 })
    {
      const auto count = static_cast<std::size_t>(part * double(all.size));
      const auto image = renderSorted(sample.first(count, all), camera, options);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(meanOf(image.radiance, c) / meanOf(exact.radiance, c), 1, 0.05)
          << name << ", " << part << " of the particles, channel " << c;
      }
    }
  }
}

Vec3 inSlab(double u, double v, double w)
{
  return { 16 * u - 8, 11 * v - 5.5, 16 * w - 8 };
}
/// Beyond the stars on all sides, so that they lie behind as much when its edge is blurred.
Vec3 inWiderSlab(double u, double v, double w)
{
  return { 20 * u - 10, 15 * v - 7.5, 16 * w - 8 };
}
constexpr double slabArea = 20 * 15;

TEST(Preview, MeanLightIsThatOfAllWhereDustIsAmongTheStars)
{
  // From a fifth of a pixel to a tenth of the view; the smallest are opaque one by one.
  for (const double h : { 0.02, 0.06, 0.2, 1.0 })
  {
    for (const double tau : { 1.0, 3.0 })
    {
      const Scene scene = starsAndDust(150000, tau, slabArea, h, inSlab, inWiderSlab);
      expectMeanLight(std::to_string(h) + " kpc, tau " + std::to_string(tau), scene.view());
    }
  }
}

TEST(Preview, MeanLightIsThatOfAllBehindAScreen)
{
  const auto before = [](double u, double v, double w) {
    return Vec3{ 20 * u - 10, 15 * v - 7.5, 9 + w };
  };
  const Scene scene = starsAndDust(200000, 1, slabArea, 0.1, inSlab, before);
  expectMeanLight("screen", scene.view());
  expectMeanLight("screen of splines", scene.view(), 3, Kernel::CubicSpline);
}

TEST(Preview, MeanLightIsThatOfAllOfADiscFromAboveAndFromTheSide)
{
  // Exponential, of scale length 2; the dust lies half as high as the stars.
  const auto disc = [](double height, double u, double v, double w) {
    const double r = -2 * std::log(std::max(1e-6, 1 - u) * (0.5 + 0.5 * v)), angle = 40 * v + 2 * u;
    const double z = height * std::log(w < 0.5 ? 2 * w + 1e-6 : 2 - 2 * w + 1e-6);
    return Vec3{ r * std::cos(angle), r * std::sin(angle), w < 0.5 ? z : -z };
  };
  using std::placeholders::_1, std::placeholders::_2, std::placeholders::_3;
  const Scene face = starsAndDust(
    60000, 1, 100, 0.1, std::bind(disc, 0.6, _1, _2, _3), std::bind(disc, 0.3, _1, _2, _3));
  expectMeanLight("face-on", face.view());
  Scene edge = face;
  for (std::size_t i = 0; i < edge.h.size(); ++i)
  {
    std::swap(edge.position[3 * i + 1], edge.position[3 * i + 2]);
  }
  expectMeanLight("edge-on", edge.view());
}

TEST(Preview, MeanLightIsThatOfAllAcrossADustLane)
{
  const auto lane = [](double u, double v, double w) { return Vec3{ 18 * u - 9, v - 0.5, 8 + w }; };
  const Scene scene = starsAndDust(120000, 3, 18, 0.1, inSlab, lane);
  expectMeanLight("lane", scene.view());
}

TEST(Preview, MeanLightIsThatOfAllByComponents)
{
  // The same by intensity and component, whose factors count.
  Scene scene = starsAndDust(120000, 1.5, slabArea, 0.1, inSlab, inWiderSlab);
  std::vector<float> intensity;
  std::vector<std::uint8_t> component;
  for (std::size_t i = 0; i < scene.h.size(); ++i)
  {
    component.push_back(i % 2);
    intensity.push_back(i % 2 ? scene.absorption[3 * i] / 2 : 1);
  }
  std::vector<ComponentInfo> components(2);
  components[0].brightness = 7;
  components[1].absorbs = true;
  components[1].brightness = 2;
  components[1].size = 1.5;
  components[1].absorption = { 1, 0.5, 0.2 };
  ParticleView view;
  view.size = scene.h.size();
  view.position = scene.position.data();
  view.smoothingLength = scene.h.data();
  view.intensity = intensity.data();
  view.component = component.data();
  view.components = &components;
  std::vector<bool> visible = { true, true };
  view.visible = &visible;
  expectMeanLight("components", view);
  visible[1] = false;
  expectMeanLight("without dust", view);
}

TEST(Preview, WhatShinesAndDimsKeepsItsSource)
{
  // Each channel as bright as its source where it is opaque, whatever the sample.
  Scene scene;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 120000; ++i)
  {
    const auto K = static_cast<float>(2 * slabArea / 120000);
    scene.add(inSlab(uniform(random), uniform(random), uniform(random)), 0.1,
      { 3 * K, K, 0.2F * K }, { K, K, 0.5F * K });
  }
  expectMeanLight("slabs", scene.view());
}

TEST(Preview, OnlyAbsorbersAreSpreadAndOnlyWhereTheyStandForMany)
{
  Scene scene = randomScene(1000, true);
  PreviewSample sample(scene.view());
  SpreadAbsorbers absorbers;
  const ParticleView all = sample.first(1000, scene.view());
  EXPECT_EQ(
    absorbers.of(all, testCamera(true), Kernel::Gaussian).smoothingLength, all.smoothingLength);
  const ParticleView some = sample.first(100, scene.view());
  const ParticleView spread = absorbers.of(some, testCamera(true), Kernel::Gaussian);
  int wider = 0;
  for (std::size_t i = 0; i < 100; ++i)
  {
    const bool absorbs = some.absorption[3 * i] > 0;
    wider += spread.smoothingLength[i] > some.smoothingLength[i];
    EXPECT_TRUE(absorbs || spread.smoothingLength[i] == some.smoothingLength[i]);
    EXPECT_TRUE(absorbs || spread.emission[3 * i] == some.emission[3 * i]);
  }
  EXPECT_GT(wider, 10);
  EXPECT_EQ(spread.weight, 10);
}

TEST(Preview, AnyBeginningOfTheSampleHasSomeOfEveryPart)
{
  Scene scene;
  for (int i = 0; i < 1000; ++i)
  {
    scene.add({ double(i), 0, 0 }, 1, { 1, 1, 1 });
  }
  const PreviewSample sample(scene.view());
  const ParticleView some = sample.first(64, scene.view());
  int parts[4] = {};
  for (std::size_t k = 0; k < 64; ++k)
  {
    ++parts[static_cast<int>(some.position[3 * k]) / 250];
  }
  for (const int part : parts)
  {
    EXPECT_NEAR(part, 16, 3);
  }
}

TEST(Preview, NoParticlesAreNoTrouble)
{
  Preview preview;
  const auto image = preview.render({}, 1, testCamera(true), {}, 0.1);
  EXPECT_EQ(largest(image.radiance), 0);
}
} // namespace
