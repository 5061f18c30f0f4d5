// Particles that share their path: against the transfer integral along a ray, by quadrature.
#include "Filters/Splatting/GaussianKernel.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using namespace galaxy;

/// A Gaussian on the ray through the middle pixel: column emission e, optical depth t, centre x
/// (kpc, toward the observer) and sigma.
struct Gauss
{
  double e, t, x, sigma;
};

/// The integral of E exp(-tau) over the ray, tau to the observer at +infinity, by Simpson's rule.
double exactLight(const std::vector<Gauss>& balls)
{
  const double from = -20, to = 20;
  const int steps = 400000;
  const auto integrand = [&balls](double x) {
    double E = 0, tau = 0;
    for (const Gauss& b : balls)
    {
      const double q = (x - b.x) / b.sigma;
      E += b.e * std::exp(-q * q) / (std::sqrt(M_PI) * b.sigma);
      tau += 0.5 * b.t * std::erfc(q);
    }
    return E * std::exp(-tau);
  };
  const double dx = (to - from) / steps;
  double sum = integrand(from) + integrand(to);
  for (int k = 1; k < steps; ++k)
  {
    sum += (k % 2 ? 4 : 2) * integrand(from + k * dx);
  }
  return sum * dx / 3;
}

constexpr double pixelMiddle = 0.05;

/// The scene of such balls, seen so that the middle pixel's share of each is its centre's.
Scene sceneOf(const std::vector<Gauss>& balls, double G(double sigma))
{
  Scene scene;
  for (const Gauss& b : balls)
  {
    const float L = static_cast<float>(b.e / G(b.sigma)), K = static_cast<float>(b.t / G(b.sigma));
    scene.add({ pixelMiddle, pixelMiddle, b.x }, 3 * b.sigma, { L, L, L }, { K, 0, K });
  }
  return scene;
}

/// The mean over the middle pixel of 0.1 kpc.
double middleShare(double sigma)
{
  const double part = 2 * gaussianCumulative(0.05 / sigma) / 0.1;
  return part * part;
}

double lightOf(const std::vector<Gauss>& balls, Accuracy accuracy, double slices, bool parallel)
{
  const Scene scene = sceneOf(balls, middleShare);
  RenderOptions options;
  options.accuracy = accuracy;
  options.slices = slices;
  const auto image = render(scene.view(), testCamera(parallel, 4, 4), options);
  return image.radiance[pixelAt(image, 2, 2)];
}

/// An emitter, and an absorber at d sigma before it.
std::vector<Gauss> pair(double t, double d)
{
  return { { 1, 0, 0, 1 }, { 0, t, d, 1 } };
}

TEST(Overlapping, ConvergesToThePairsIntegral)
{
  for (const double t : { 0.1, 1.0, 3.0, 30.0 })
  {
    for (const double d : { -2.0, -0.5, 0.0, 0.3, 1.0, 2.0 })
    {
      const double exact = exactLight(pair(t, d));
      const double light = lightOf(pair(t, d), Accuracy::Overlapping, 64, true);
      EXPECT_NEAR(light, exact, 2e-4 * exact + 1e-6) << t << ' ' << d;
    }
  }
}

TEST(Overlapping, ErrorFallsWithTheSquareOfTheSlices)
{
  const std::vector<Gauss> balls = { { 1, 0, 0, 1 }, { 0, 3, 0.4, 0.6 }, { 0.5, 1, -0.7, 1.3 },
    { 2, 0.3, 1.1, 0.8 } };
  const double exact = exactLight(balls);
  double last = 0;
  for (const double slices : { 1.0, 2.0, 4.0, 8.0, 16.0 })
  {
    const double error = std::abs(lightOf(balls, Accuracy::Overlapping, slices, true) / exact - 1);
    if (last > 0)
    {
      EXPECT_GT(last / error, 3.2) << slices;
      EXPECT_LT(last / error, 4.8) << slices;
    }
    last = error;
  }
  EXPECT_LT(last, 3e-4);
}

TEST(Overlapping, SortedIsOffWhereParticlesOverlapAndRightWhereTheyDoNot)
{
  // physics: an absorber of t = 1 just before its emitter is taken as wholly before it: -0.42.
  const double exact = exactLight(pair(1, 1e-3));
  EXPECT_NEAR(lightOf(pair(1, 1e-3), Accuracy::Sorted, 0, true) / exact - 1, -0.42, 0.01);
  EXPECT_NEAR(lightOf(pair(1, -1e-3), Accuracy::Sorted, 0, true) / exact - 1, 0.58, 0.01);
  for (const double d : { -5.0, 5.0 })
  {
    const double apart = exactLight(pair(1, d));
    EXPECT_NEAR(lightOf(pair(1, d), Accuracy::Sorted, 0, true) / apart, 1, 2e-3);
    EXPECT_NEAR(lightOf(pair(1, d), Accuracy::Overlapping, 16, true) / apart, 1, 2e-3);
  }
}

TEST(Overlapping, OneSourceFunctionNeedsNoOrder)
{
  // Where E/A is the same everywhere the light is (E/A) (1 - exp(-tau)), however particles overlap.
  std::vector<Gauss> balls;
  double tau = 0;
  for (int k = 0; k < 12; ++k)
  {
    const double t = 0.1 + 0.07 * k;
    balls.push_back({ 2 * t, t, 0.3 * k - 2, 0.5 + 0.05 * k });
    tau += t;
  }
  EXPECT_NEAR(lightOf(balls, Accuracy::Overlapping, 4, true) / (2 * (1 - std::exp(-tau))), 1, 1e-5);
  EXPECT_NEAR(lightOf(balls, Accuracy::Sorted, 4, true) / (2 * (1 - std::exp(-tau))), 1, 1e-5);
}

TEST(Overlapping, IsTheSortedPictureWithoutAbsorbers)
{
  const Scene scene = randomScene(1000, false);
  RenderOptions options;
  options.accuracy = Accuracy::Overlapping;
  for (const bool parallel : { true, false })
  {
    for (const Kernel kernel : kernels)
    {
      options.kernel = kernel;
      const auto slices = render(scene.view(), testCamera(parallel), options);
      const auto sorted = renderSorted(scene.view(), testCamera(parallel), options);
      EXPECT_LT(
        largestDifference(slices.radiance, sorted.radiance), 2e-5 * largest(sorted.radiance));
      EXPECT_EQ(slices.statistics.drawn, sorted.statistics.drawn);
    }
  }
}

TEST(Overlapping, TheObserverInsideAParticleSeesHalfOfIt)
{
  Scene scene;
  scene.add({ 0.05, 0.05, 100 - 1e-3 }, 30, { 1, 1, 1 }, { 0.0f, 1e-3f, 0 });
  Scene before = scene;
  before.position[2] = 0;
  RenderOptions options;
  options.accuracy = Accuracy::Overlapping;
  const auto half = render(scene.view(), testCamera(false, 20, 20), options);
  const double inside = half.radiance[pixelAt(half, 10, 10)];
  // Its own sigma is 10 kpc: in the middle the whole column is 1 / (pi sigma^2).
  EXPECT_NEAR(inside, 0.5 / (M_PI * 100), 0.01 * inside);
}

TEST(Overlapping, HalvesMakeTheWhole)
{
  Scene one, two;
  one.add({ 0.03, 0.02, 0 }, 2, { 1, 2, 3 }, { 1, 2, 30 });
  two.add({ 0.03, 0.02, 0 }, 2, { 0.5f, 1, 1.5f }, { 0.5f, 1, 15 });
  two.add({ 0.03, 0.02, 0 }, 2, { 0.5f, 1, 1.5f }, { 0.5f, 1, 15 });
  const auto a = renderOverlapping(one.view(), testCamera(true));
  const auto b = renderOverlapping(two.view(), testCamera(true));
  EXPECT_LT(largestDifference(a.radiance, b.radiance), 1e-6 * largest(a.radiance));
  EXPECT_LT(largestDifference(a.transmittance, b.transmittance), 1e-6);
}

/// Particles as large as the picture, among them one so small that there are many slices.
Scene closeUp()
{
  Scene scene;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 40; ++i)
  {
    scene.add({ uniform(random), uniform(random), uniform(random) }, 2, { 1, 0.5F, 1 },
      { 0.1F, 0.2F, 0.1F });
  }
  scene.add({ 0, 0, 0 }, 0.02, {}, { 1e-4F, 0, 0 });
  return scene;
}

TEST(Overlapping, ProgressIsEvenAndEndsThePictureWhereverItIsAborted)
{
  const Scene scene = closeUp();
  const Camera camera = testCamera(true, 8, 60);
  RenderOptions options;
  options.accuracy = Accuracy::Overlapping;
  options.slices = 1;
  std::vector<double> told;
  options.progress = [&told](double done) {
    told.push_back(done);
    return true;
  };
  EXPECT_FALSE(render(scene.view(), camera, options).aborted);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1);
  // Within tiles too; how often hangs on how the threads share the rows.
  const auto late = std::count_if(told.begin(), told.end(), [](double t) { return t > 0.5; });
  EXPECT_GT(late, 2);
  for (std::size_t last = 0; last < told.size(); last += 1 + told.size() / 5)
  {
    std::size_t asked = 0;
    options.progress = [&asked, last](double) { return asked++ < last; };
    const auto image = render(scene.view(), camera, options);
    EXPECT_EQ(image.aborted, asked > last);
    EXPECT_LE(asked, last + 1) << "asked again after the answer";
    EXPECT_TRUE(!image.aborted || largest(image.radiance) == 0);
    EXPECT_TRUE(image.aborted || last > told.size() / 4);
  }
}

TEST(Overlapping, SaysItsWork)
{
  const Scene scene = closeUp();
  RenderOptions options;
  options.accuracy = Accuracy::Overlapping;
  options.slices = 0.5;
  const double once = render(scene.view(), testCamera(true, 20, 20), options).statistics.raySums;
  options.slices = 1;
  const double twice = render(scene.view(), testCamera(true, 20, 20), options).statistics.raySums;
  EXPECT_GT(once, 20 * 20 * 40);
  EXPECT_NEAR(twice / once, 2, 0.1);
}
}
