// Off the axis of a perspective nothing is lost: pictures against rays through spherical Gaussians,
// which know no image plane.
#include "Filters/Splatting/Lens.h"
#include "Filters/Splatting/Panorama.h"
#include "RayFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

Camera lookingAhead(double field, int size)
{
  return Camera::lookAt({}, { 0, 0, -1 }, { 0, 1, 0 }, false, 1, field, size, size);
}

/// At an angle from the axis of lookingAhead(), on a circle around it.
Vec3 direction(double angle, double around = 0)
{
  return { std::sin(angle) * std::cos(around), std::sin(angle) * std::sin(around),
    -std::cos(angle) };
}

constexpr double degree = M_PI / 180;

/// Directions spread evenly over the sky.
std::vector<Vec3> evenly(int count)
{
  std::vector<Vec3> directions;
  for (int k = 0; k < count; ++k)
  {
    const double z = 1 - (2 * k + 1.0) / count, phi = k * M_PI * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    directions.push_back({ r * std::cos(phi), r * std::sin(phi), z });
  }
  return directions;
}

/// Particles all around the eye, each as wide on the sky as `widths` of its distance.
Scene cloudAround(int count, double least, double most, float depth)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  Scene scene;
  for (const Vec3& towards : evenly(count))
  {
    const double distance = 5 * (1 + 3 * uniform(random));
    const double h = distance * (least + (most - least) * uniform(random));
    const float light = static_cast<float>(distance * distance * uniform(random));
    const float K = static_cast<float>(depth * distance * distance / count * uniform(random));
    scene.add(distance * towards, h, { light, light, light }, { K, K, K });
  }
  return scene;
}

/// Sums over the pixels that lie in the outermost tenth of a picture's angles.
struct Rim
{
  double light = 0, depth = 0;
  double raysLight = 0, raysDepth = 0;

  Rim(const Scene& scene, const Camera& camera, const RenderedImage& image)
  {
    const Rays rays(scene, camera);
    const double farthest = rays.angle(0, 0);
    for (int y = 0; y < image.height; ++y)
    {
      for (int x = 0; x < image.width; ++x)
      {
        if (rays.angle(x, y) > 0.9 * farthest)
        {
          const Rays::Seen seen = rays.pixel(x, y);
          this->raysLight += seen.light;
          this->raysDepth += seen.depth;
          this->light += image.radiance[pixelAt(image, x, y)];
          this->depth -= std::log(image.transmittance[pixelAt(image, x, y)]);
        }
      }
    }
  }
};

TEST(Perspective, AtTheRimLightAndOpticalDepthAreTheRays)
{
  for (const double field : { 30.0, 60.0, 90.0, 120.0 })
  {
    const Scene scene = cloudAround(20000, 0.02, 0.08, 2);
    const Camera camera = lookingAhead(field, 100);
    const Rim rim(scene, camera, render(scene.view(), camera));
    EXPECT_NEAR(rim.light / rim.raysLight, 1, 0.01) << field;
    EXPECT_NEAR(rim.depth / rim.raysDepth, 1, 0.01) << field;
  }
}

TEST(Perspective, AtEveryLevelTheRimIsTheRays)
{
  const Scene scene = cloudAround(12000, 0.02, 0.08, 2);
  const Camera camera = lookingAhead(75, 80);
  RenderOptions options;
  for (const Accuracy level :
    { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Preview, Accuracy::Overlapping })
  {
    options.accuracy = level;
    options.slices = 1;
    options.allowed = { 1e-3 * 12000 / (4 * M_PI), 1e-3 };
    const Rim rim(scene, camera, render(scene.view(), camera, options));
    EXPECT_NEAR(rim.light / rim.raysLight, 1, 0.01) << int(level);
    EXPECT_NEAR(rim.depth / rim.raysDepth, 1, 0.01) << int(level);
  }
}

TEST(Perspective, AWindowFarOffTheAxisIsTheRays)
{
  const Scene scene = cloudAround(20000, 0.02, 0.08, 2);
  Camera camera = lookingAhead(40, 40);
  // 59 to 67 degrees to the right: as a wall of screens has it.
  camera.centerX -= 2 * camera.scale;
  camera.centerY -= 0.5 * camera.scale;
  const RenderedImage image = render(scene.view(), camera);
  const Rays rays(scene, camera);
  double light = 0, depth = 0;
  Rays::Seen expected;
  for (int y = 0; y < image.height; ++y)
  {
    for (int x = 0; x < image.width; ++x)
    {
      const Rays::Seen seen = rays.pixel(x, y);
      expected.light += seen.light;
      expected.depth += seen.depth;
      light += image.radiance[pixelAt(image, x, y)];
      depth -= std::log(image.transmittance[pixelAt(image, x, y)]);
    }
  }
  EXPECT_NEAR(light / expected.light, 1, 0.01);
  EXPECT_NEAR(depth / expected.depth, 1, 0.01);
}

/// The image plane has d/z^3 of a point's light per area, as of its cross-section.
TEST(Perspective, APointsLightIsThatOfItsSolidAngleOnThePlane)
{
  for (const Kernel kernel : kernels)
  {
    for (const double angle : { 0.0, 20.0, 40.0, 50.0, 54.0 })
    {
      const Camera camera = lookingAhead(90, 200);
      const double d = 7, z = d * std::cos(angle * degree);
      const double share = d / (z * z * z);
      const double pixels = camera.scale * camera.scale;
      Scene light, dust;
      light.add(d * direction(angle * degree, M_PI / 4), 1e-4, { 3, 0, 0 });
      dust.add(d * direction(angle * degree, M_PI / 4), 1e-4, {}, { 1e-4F, 0, 0 });
      RenderOptions options;
      options.kernel = kernel;
      const RenderedImage image = render(light.view(), camera, options);
      EXPECT_NEAR(total(image) / (3 * share * pixels), 1, 1e-3) << angle;
      double depth = 0;
      for (const float through : render(dust.view(), camera, options).transmittance)
      {
        depth -= std::log(through);
      }
      EXPECT_NEAR(depth / (1e-4 * share * pixels), 1, 1e-3) << angle;
    }
  }
}

/// Of a shell of radius R of Gaussians, what one direction sees for each of them, by quadrature.
double shellColumn(double R, double sigma)
{
  const int steps = 4000;
  double sum = 0;
  for (int k = 0; k < steps; ++k)
  {
    const double w = M_PI * (k + 0.5) / steps, b = R * std::sin(w) / sigma;
    const double before = 0.5 * (1 + std::erf(R * std::cos(w) / sigma));
    sum += std::sin(w) * std::exp(-b * b) * before * M_PI / steps;
  }
  return sum * 2 * M_PI / (M_PI * sigma * sigma) / (4 * M_PI);
}

/// A shell of so many smoothing lengths in all pixels of a picture.
void checkShell(double radius, double field, double allowed, Kernel kernel = Kernel::Gaussian)
{
  const int count = 20000;
  // The spline's variance is 3 h^2/40.
  const double sigma = kernel == Kernel::Gaussian ? 1.0 / 3 : std::sqrt(3.0 / 20);
  const double expected = count * shellColumn(radius, sigma);
  const auto K = static_cast<float>(1 / expected);
  Scene scene;
  for (const Vec3& towards : evenly(count))
  {
    scene.add(radius * towards, 1, { 1, 1, 1 }, { K, 0, 0 });
  }
  RenderOptions options;
  options.kernel = kernel;
  const RenderedImage image = render(scene.view(), lookingAhead(field, 24), options);
  double largest = 0, largestDepth = 0;
  for (std::size_t pixel = 0; pixel < image.radiance.size(); pixel += 3)
  {
    const double depth = -std::log(double(image.transmittance[pixel]));
    largest = std::max(largest, std::abs(image.radiance[pixel + 1] / expected - 1));
    largestDepth = std::max(largestDepth, std::abs(depth - 1));
  }
  EXPECT_LT(largest, allowed) << radius << ", " << field;
  EXPECT_LT(largestDepth, allowed) << radius << ", " << field;
}

TEST(Perspective, AShellAroundTheEyeIsTheSameInAllDirections)
{
  for (const double radius : { 0.5, 1.4, 1.7, 1.95, 2.05, 2.3, 3.0, 6.0 })
  {
    checkShell(radius, 60, 0.005);
    checkShell(radius, 90, 0.012);
  }
  for (const double field : { 120.0, 140.0 })
  {
    checkShell(1.4, field, 0.01);
    checkShell(6, field, 0.02);
  }
  checkShell(1.4, 90, 0.005, Kernel::CubicSpline);
  checkShell(3, 90, 0.012, Kernel::CubicSpline);
  checkShell(6, 90, 0.005, Kernel::CubicSpline);
}

/// The light of a picture of a particle over what the rays see.
double lightOverRays(const Scene& scene, const Camera& camera)
{
  const RenderedImage image = render(scene.view(), camera);
  const Rays rays(scene, camera, 1);
  double expected = 0;
  for (int y = 0; y < image.height; ++y)
  {
    for (int x = 0; x < image.width; ++x)
    {
      expected += rays.pixel(x, y).light;
    }
  }
  return total(image) / expected;
}

TEST(Perspective, WhereAParticleBecomesNearNothingJumps)
{
  struct Path
  {
    Vec3 from, to;
    double field;
    bool isWhole; ///< all of it is in the picture, all the way
  };
  const auto radial = [](double angle) {
    return Path{ 3 * direction(angle * degree, 0.5), 1.2 * direction(angle * degree, 0.5), 90,
      angle < 10 };
  };
  // Also past the eye, at the side.
  const Path paths[] = { radial(0), radial(5), radial(30), radial(45), radial(52),
    { { 2, 0.3, -2.5 }, { 2, 0.3, 0.5 }, 90, false },
    { { -1.5, -1.5, -1.4 }, { -1.5, -1.5, 0 }, 110, false } };
  const int steps = 180;
  for (const Path& path : paths)
  {
    RenderedImage before;
    for (int k = 0; k <= steps; ++k)
    {
      const double t = double(k) / steps;
      Scene scene;
      scene.add((1 - t) * path.from + t * path.to, 1, { 1, 1, 1 });
      const Camera camera = lookingAhead(path.field, 40);
      const RenderedImage image = render(scene.view(), camera);
      const double peak = 9 / M_PI;
      if (k > 0)
      {
        EXPECT_LT(largestDifference(image.radiance, before.radiance), 0.04 * peak) << k;
      }
      before = image;
      if (path.isWhole && k % 10 == 0)
      {
        EXPECT_NEAR(lightOverRays(scene, camera), 1, 0.01) << k;
      }
    }
  }
}

/// No disc of the image plane shows what lies beside the eye or behind it.
TEST(Perspective, WhatNoRayMeetsIsNotSeen)
{
  const Camera camera = lookingAhead(90, 40);
  for (const double distance : { 1.1, 1.5, 2.1, 3.0, 5.0, 20.0 })
  {
    for (double angle = 56 + std::asin(1 / distance) / degree; angle <= 180; angle += 3)
    {
      Scene scene;
      scene.add(distance * direction(angle * degree, 0.7), 1, { 1, 1, 1 });
      const RenderedImage image = render(scene.view(), camera);
      EXPECT_LT(largest(image.radiance), 0.012 * 9 / M_PI) << distance << ", " << angle;
    }
  }
}

/// Means per solid angle over rings of five degrees around the axis.
struct Rings
{
  static constexpr int count = 9;
  double light[count] = {}, through[count] = {}, solidAngle[count] = {};

  void add(const RenderedImage& image, int x, int y, double angle, double weight)
  {
    const int ring = static_cast<int>(angle / (5 * degree));
    if (ring < count)
    {
      this->light[ring] += weight * image.radiance[pixelAt(image, x, y)];
      this->through[ring] += weight * image.transmittance[pixelAt(image, x, y)];
      this->solidAngle[ring] += weight;
    }
  }
};

TEST(Perspective, ADomeAndAFlatPictureOfOneSceneAgree)
{
  const Scene scene = cloudAround(20000, 0.02, 0.1, 2);
  Panorama dome;
  dome.kind = Panorama::Kind::Dome;
  dome.width = dome.height = 220;
  dome.domeAngle = 110;
  dome.ahead = lookingAhead(90, 1);
  const RenderedImage round = renderPanorama(scene.view(), dome);
  const Camera camera = lookingAhead(90, 200);
  const RenderedImage flat = render(scene.view(), camera);
  Rings ofDome, ofPlane;
  for (int y = 0; y < 220; ++y)
  {
    for (int x = 0; x < 220; ++x)
    {
      const double angle = std::hypot(x + 0.5 - 110, y + 0.5 - 110) / 110 * 55 * degree;
      ofDome.add(round, x, y, angle, std::sin(angle) / angle);
    }
  }
  const Rays rays(scene, camera);
  for (int y = 0; y < 200; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const double angle = rays.angle(x, y);
      ofPlane.add(flat, x, y, angle, std::pow(std::cos(angle), 3));
    }
  }
  for (int ring = 0; ring < Rings::count; ++ring)
  {
    const double dome2 = ofDome.solidAngle[ring], plane2 = ofPlane.solidAngle[ring];
    EXPECT_NEAR(ofPlane.light[ring] / plane2 / (ofDome.light[ring] / dome2), 1, 0.01) << ring;
    EXPECT_NEAR(ofPlane.through[ring] / plane2, ofDome.through[ring] / dome2, 0.003) << ring;
  }
}

TEST(Lens, ACirclesSmoothingLengthIsFoundAgain)
{
  const Lens lens(lookingAhead(90, 100), Kernel::Gaussian);
  for (const double angle : { 0.0, 0.4, 0.9 })
  {
    for (const double h : { 1e-3, 0.1, 0.3 })
    {
      const Vec3 seen{ std::sin(angle), 0, std::cos(angle) };
      const Lens::Circle circle = lens.circle(seen, h);
      const double found = lens.smoothingLength(circle.x, circle.y, h * circle.radius, 1);
      EXPECT_NEAR(found / h, 1, 0.5 * h * h) << angle << ", " << h;
    }
  }
}
} // namespace
