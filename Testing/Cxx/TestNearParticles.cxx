// Hard cases 27 and 28: the eye inside a particle, or a cloud of them. Lines as in HardCaseTable.
#include "Filters/Splatting/GaussianKernel.h"
#include "Filters/Splatting/NearParticle.h"
#include "Filters/Splatting/TileNodes.h"
#include "HardCaseTable.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

constexpr double pi = 3.14159265358979323846;

/// From (0, 0, z) along -z, a wide angle.
Camera eyeAt(double z, int size = 64, double angle = 80)
{
  return Camera::lookAt({ 0, 0, z }, { 0, 0, z - 1 }, { 0, 1, 0 }, false, 1, angle, size, size);
}

RenderedImage draw(const Scene& scene, const Camera& camera, Accuracy accuracy, Kernel kernel)
{
  RenderOptions options;
  options.accuracy = accuracy;
  options.kernel = kernel;
  return render(scene.view(), camera, options);
}

double middle(const RenderedImage& image)
{
  return image.radiance[pixelAt(image, image.width / 2, image.height / 2)];
}

TEST(NearParticles, InTheMiddleTheEyeSeesHalfTheColumnInAllDirections)
{
  Scene scene;
  scene.add({ 0, 0, 0 }, 3, { 2, 2, 2 });
  const double half = 2 * 0.5 * nearPeak * (1 - std::exp(-9.0));
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Overlapping })
  {
    const auto image = draw(scene, eyeAt(0), accuracy, Kernel::Gaussian);
    // The slices' Gaussian does not end.
    const double allowed = accuracy == Accuracy::Sorted ? 1e-6 : 2e-4;
    check("27", "eye in the middle of a particle", half, middle(image), allowed);
    check("27", "in the picture's corner", half, image.radiance[0], allowed);
  }
}

TEST(NearParticles, PassingThroughAParticleNothingJumps)
{
  for (const Kernel kernel : kernels)
  {
    const double sigma = 1.5 * NearParticle::sigmas(kernel);
    Scene scene;
    scene.add({ 0, 0, 0 }, 1.5, { 1, 1, 1 });
    double largestError = 0;
    for (double z = 6; z > -4; z -= 0.01)
    {
      const auto image = draw(scene, eyeAt(z, 9, 1), Accuracy::Sorted, kernel);
      const double expected = (1 + std::erf(z / sigma)) / (2 * pi * sigma * sigma);
      largestError = std::max(largestError, std::abs(middle(image) - expected));
    }
    // The spline is not the Gaussian of its variance: 4 % at its peak.
    check("28", kernel == Kernel::Gaussian ? "through a particle" : "through a spline", 0,
      largestError * pi * sigma * sigma, kernel == Kernel::Gaussian ? 2e-3 : 0.15);
  }
}

/// A cloud around the eye, of particles before, around and behind it.
Scene cloud(int n, bool absorbs)
{
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<float> uniform(0, 1);
  Scene scene;
  for (int i = 0; i < n; ++i)
  {
    const float K = absorbs && i % 2 ? 0.2F * uniform(random) : 0;
    scene.add({ normal(random), normal(random), normal(random) }, 0.1 + 0.6 * uniform(random),
      { uniform(random), 1, 0.5F }, { K, 1.5F * K, 2 * K });
  }
  return scene;
}

TEST(NearParticles, InACloudThePictureIsTheReferences)
{
  for (const bool absorbs : { false, true })
  {
    const Scene scene = cloud(600, absorbs);
    for (const Kernel kernel : kernels)
    {
      const auto fast = draw(scene, eyeAt(0.3), Accuracy::Sorted, kernel);
      RenderOptions options;
      options.kernel = kernel;
      const auto slow = renderReference(scene.view(), eyeAt(0.3), options);
      checkSame("28", "eye in a cloud", slow, fast, 5e-6);
      EXPECT_EQ(fast.statistics.drawn, slow.statistics.drawn);
      options.allowed = { 0.02 * largest(slow.radiance), 0.02 };
      const auto bounded = renderBounded(scene.view(), eyeAt(0.3), options);
      EXPECT_LE(largestDifference(bounded.radiance, slow.radiance),
        options.allowed.light + 0.02 * largest(slow.radiance));
    }
  }
}

/// Where pixels are fine, particles are drawn by the tiles' nodes.
TEST(NearParticles, AtNodesThePictureIsTheReferences)
{
  const Camera camera = eyeAt(0.3, 300, 28);
  ASSERT_TRUE(TileNodes::suffice(camera));
  for (const bool absorbs : { false, true })
  {
    const Scene scene = cloud(200, absorbs);
    const auto fast = draw(scene, camera, Accuracy::Sorted, Kernel::Gaussian);
    checkSame(
      "28", "eye in a cloud, fine pixels", renderReference(scene.view(), camera, {}), fast, 5e-6);
  }
}

/// From the middle of a ball of light all directions are equally bright, and a particle of what is
/// behind the eye counts where it reaches before it.
TEST(NearParticles, FromTheMiddleOfABallAllDirectionsAreAlike)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Scene scene;
  double light = 0;
  while (scene.h.size() < 200000)
  {
    const Vec3 p{ uniform(random), uniform(random), uniform(random) };
    if (length(p) < 1)
    {
      scene.add(p, 0.4, { 1, 1, 1 });
      light += 1;
    }
  }
  // Its density times its radius.
  const double expected = light / (4 * pi / 3);
  const Vec3 directions[] = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { 0, -1, 0 } };
  for (const Vec3& direction : directions)
  {
    const Camera camera = Camera::lookAt({}, direction, { 1, 1, 1 }, false, 1, 40, 16, 16);
    const auto image = draw(scene, camera, Accuracy::Sorted, Kernel::Gaussian);
    check("28", "in the middle of a ball", expected, total(image) / (16 * 16), 0.03);
  }
}
} // namespace
