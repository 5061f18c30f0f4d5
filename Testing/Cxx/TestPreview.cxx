// Pictures of a random part of the particles: right on average, and what they say they are.
#include "Filters/Splatting/Preview.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

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

TEST(Preview, NoParticlesAreNoTrouble)
{
  Preview preview;
  const auto image = preview.render({}, 1, testCamera(true), {}, 0.1);
  EXPECT_EQ(largest(image.radiance), 0);
}
} // namespace
