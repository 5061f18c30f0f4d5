// Panoramas: what is seen of a sky must not depend on where the cube's faces lie.
#include "Filters/Splatting/Panorama.h"
#include "Filters/Splatting/SkyFace.h"
#include "Readers/Formats/Error.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

Panorama panoramaOf(Panorama::Kind kind, int width, int height, const Vec3& eye = {},
  const Vec3& at = { 0, 0, -1 }, const Vec3& up = { 0, 1, 0 })
{
  Panorama panorama;
  panorama.kind = kind;
  panorama.width = width;
  panorama.height = height;
  panorama.ahead = Camera::lookAt(eye, eye + at, up, false, 1, 90, width, height);
  return panorama;
}

Panorama allSky(int width, const Vec3& at = { 0, 0, -1 })
{
  return panoramaOf(Panorama::Kind::Equirectangular, width, width / 2, {}, at);
}

/// The solid angle of a pixel of an equirectangular panorama.
double solidAngle(const RenderedImage& image, int row)
{
  const double top = ((row + 1.0) / image.height - 0.5) * M_PI;
  const double bottom = (double(row) / image.height - 0.5) * M_PI;
  return 2 * M_PI / image.width * (std::sin(top) - std::sin(bottom));
}

/// Light that arrives from all the sky: radiance over solid angle.
double flux(const RenderedImage& image, int channel = 0)
{
  double sum = 0;
  for (int row = 0; row < image.height; ++row)
  {
    for (int column = 0; column < image.width; ++column)
    {
      sum += image.radiance[pixelAt(image, column, row) + channel] * solidAngle(image, row);
    }
  }
  return sum;
}

/// Directions spread evenly over the sky, but for both ends: a spiral with steps of the golden
/// angle.
std::vector<Vec3> evenly(int count)
{
  std::vector<Vec3> directions;
  for (int k = 0; k < count; ++k)
  {
    const double z = 1 - (2 * k + 1.0) / count, phi = k * M_PI * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    directions.push_back({ r * std::cos(phi), z, r * std::sin(phi) });
  }
  return directions;
}

TEST(SkyFace, TheSharesOfAllFacesAreOneTogether)
{
  const Camera ahead = Camera::lookAt({}, { 1, 2, 3 }, { 0, 1, 0 }, false, 1, 90, 1, 1);
  for (const Vec3& direction : evenly(20000))
  {
    double sum = 0;
    for (int k = 0; k < SkyFace::count; ++k)
    {
      double x, y;
      const SkyFace face(ahead, k, 100);
      const double share = face.share(direction, x, y);
      sum += share;
      if (share > 0)
      {
        EXPECT_GT(dot(direction, face.camera().forward), std::cos(SkyFace::farthest()) - 1e-12);
        EXPECT_GE(std::acos(dot(direction, ahead.forward)), SkyFace::nearest(k) - 1e-6);
        EXPECT_GE(std::min(x, y), 0.5);
        EXPECT_LE(std::max(x, y), face.camera().width - 0.5);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Panorama, AShellOfLightIsEquallyBrightEverywhere)
{
  // Light L in all at the distance R has the radiance L / (4 pi R^2).
  Scene scene;
  const int count = 20000;
  for (const Vec3& direction : evenly(count))
  {
    scene.add(2 * direction, 0.25, { 1, 2, 0.5 });
  }
  const RenderedImage image = renderPanorama(scene.view(), allSky(128));
  const double expected = count / (4 * M_PI * 4);
  const std::size_t end = 3 * 128 * 2; // the rows where the spiral ends
  for (std::size_t i = end; i < image.radiance.size() - end; i += 3)
  {
    EXPECT_NEAR(image.radiance[i] / expected, 1, 0.005);
    EXPECT_NEAR(image.radiance[i + 1], 2 * image.radiance[i], 1e-4 * expected);
    EXPECT_FLOAT_EQ(image.transmittance[i], 1);
  }
  EXPECT_NEAR(flux(image) / count, 0.25, 1e-3);
}

TEST(Panorama, AShellOfDustIsEquallyDarkEverywhere)
{
  Scene scene;
  const int count = 20000;
  const float K = 4 * M_PI * 4 / count; // optical depth 1
  for (const Vec3& direction : evenly(count))
  {
    scene.add(2 * direction, 0.25, {}, { K, 2 * K, 0 });
  }
  const RenderedImage image = renderPanorama(scene.view(), allSky(64));
  const std::size_t end = 3 * 64 * 2;
  for (std::size_t i = end; i < image.transmittance.size() - end; i += 3)
  {
    EXPECT_NEAR(std::log(image.transmittance[i]), -1, 0.01);
    EXPECT_NEAR(std::log(image.transmittance[i + 1]), -2, 0.02);
    EXPECT_FLOAT_EQ(image.transmittance[i + 2], 1);
  }
}

TEST(Panorama, ABallOfLightAroundTheEyeIsEquallyBrightEverywhere)
{
  // Near the eye, across the limit to where the image plane is used, and beyond.
  Scene scene;
  for (int shell = 0; shell < 8; ++shell)
  {
    for (const Vec3& direction : evenly(3000))
    {
      scene.add((0.1 + 0.15 * shell) * direction, 0.3, { 1, 1, 1 });
    }
  }
  const RenderedImage image = renderPanorama(scene.view(), allSky(64));
  double mean = flux(image) / (4 * M_PI);
  for (std::size_t i = 0; i < image.radiance.size(); i += 3)
  {
    EXPECT_NEAR(image.radiance[i] / mean, 1, 0.03);
  }
}

/// In the middle of a face (straight ahead), where three meet, and between two.
const Vec3 places[] = { { 0, 0, -1 }, { 0.3568, 0.4911, 0.7947 }, { 1, 0, -1 }, { 1, 0.3, -1.1 },
  { 1, 1, -1 }, { -1, 1.2, 0.9 }, { 0.1, 1, 0.2 } };

/// Of a light that has 1/r^2 on Earth, or as a ball the mean of that over it.
double fluxOf(const Vec3& direction, double h)
{
  Scene scene;
  scene.add(3 * normalized(direction), h, { 9, 0, 0 });
  return flux(renderPanorama(scene.view(), allSky(512))) / (1 + h * h / 9 / 18);
}

TEST(Panorama, ALightsFluxDoesNotDependOnTheFace)
{
  for (const Vec3& place : { places[0], places[1], places[2], places[5] })
  {
    for (const auto& [h, tolerance] :
      { std::pair(1e-4, 0.03), std::pair(0.06, 0.01), std::pair(1.2, 0.04) })
    {
      EXPECT_NEAR(fluxOf(place, h), 1, tolerance)
        << h << ": " << place.x << ", " << place.y << ", " << place.z;
    }
  }
}

TEST(Panorama, APointIsWhereItsDirectionIs)
{
  for (const Vec3& place : places)
  {
    Scene scene;
    scene.add(3 * normalized(place), 1e-3, { 9, 0, 0 });
    const auto panorama = allSky(200);
    const RenderedImage image = renderPanorama(scene.view(), panorama);
    const auto brightest = std::max_element(image.radiance.begin(), image.radiance.end());
    const auto pixel = std::distance(image.radiance.begin(), brightest) / 3;
    Vec3 direction;
    ASSERT_TRUE(panorama.direction(pixel % 200 + 0.5, pixel / 200 + 0.5, direction));
    // A pixel is 1.8 degrees; on an edge of two, any of them.
    EXPECT_GT(dot(direction, normalized(place)), std::cos(0.75 * panorama.largestPixel()));
  }
}

TEST(Panorama, WestIsToTheRightOfNorth)
{
  const auto panorama = allSky(360);
  Vec3 direction;
  panorama.direction(270, 90, direction); // 90 degrees to the right
  EXPECT_NEAR(direction.x, 1, 1e-12);
  panorama.direction(180, 179.999, direction);
  EXPECT_NEAR(direction.y, 1, 1e-9);
}

TEST(Panorama, OfADomeTheAngleIsTheRadius)
{
  auto panorama = panoramaOf(Panorama::Kind::Dome, 220, 200);
  panorama.domeAngle = 220;
  Scene scene;
  const double angle = 99 * M_PI / 180; // 0.9 of the radius
  scene.add({ 5 * std::sin(angle), 0, -5 * std::cos(angle) }, 1e-3, { 9, 0, 0 });
  const RenderedImage image = renderPanorama(scene.view(), panorama);
  const auto at = std::distance(image.radiance.begin(),
                    std::max_element(image.radiance.begin(), image.radiance.end())) /
    3;
  EXPECT_NEAR(at % 220 + 0.5, 110 + 90, 1);
  EXPECT_NEAR(at / 220 + 0.5, 100, 1);
}

// A dome of next to no angle needs faces of more pixels than can be counted.
TEST(Panorama, FinerThanAnyMemoryIsRefused)
{
  auto panorama = panoramaOf(Panorama::Kind::Dome, 64, 64);
  panorama.domeAngle = 1e-9;
  EXPECT_THROW(renderPanorama(Scene().view(), panorama), Error);
}

TEST(Panorama, OutsideOfADomeNothingIsSeen)
{
  Scene scene;
  for (const Vec3& direction : evenly(3000))
  {
    scene.add(2 * direction, 0.5, { 1, 1, 1 }, { 1, 1, 1 });
  }
  const auto panorama = panoramaOf(Panorama::Kind::Dome, 64, 64);
  const RenderedImage image = renderPanorama(scene.view(), panorama);
  const std::size_t corner = pixelAt(image, 1, 1), middle = pixelAt(image, 32, 32);
  EXPECT_EQ(image.radiance[corner], 0);
  EXPECT_EQ(image.transmittance[corner], 1);
  EXPECT_GT(image.radiance[middle], 0);
  EXPECT_LT(image.transmittance[middle], 1);
}

TEST(Panorama, TurningTheFacesChangesNothing)
{
  // An eye among lights and dust, seen with the faces where they were and turned by 45 degrees,
  // which puts edges where there were middles.
  Scene scene;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (int k = 0; k < 30000; ++k)
  {
    const Vec3 p{ 4 * uniform(random), 4 * uniform(random), 4 * uniform(random) };
    const float L = k % 4 ? 1 : 0, K = k % 4 ? 0 : 0.02F;
    scene.add(p, 0.25, { L, L, L }, { K, K, K });
  }
  const int width = 256, shift = width / 8;
  const double s = std::sqrt(0.5);
  const RenderedImage one = renderPanorama(scene.view(), allSky(width));
  const RenderedImage other = renderPanorama(scene.view(), allSky(width, { s, 0, -s }));
  double square = 0, light = 0, most = 0;
  for (int row = 0; row < one.height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const double a = one.radiance[pixelAt(one, (column + shift) % width, row)];
      const double difference = a - other.radiance[pixelAt(other, column, row)];
      square += difference * difference;
      light += a;
      most = std::max(most, std::abs(difference));
    }
  }
  const double mean = light / (width * one.height);
  const double rms = std::sqrt(square / (width * one.height)) / mean;
  EXPECT_LT(rms, 0.05); // of particles that are wide on the sky, the shape
  EXPECT_LT(most / mean, 0.4);
}

TEST(Panorama, AnAbortLeavesNothing)
{
  Scene scene = randomScene(1000, true);
  RenderOptions options;
  std::vector<double> told;
  options.progress = [&told](double done) {
    told.push_back(done);
    return true;
  };
  EXPECT_FALSE(renderPanorama(scene.view(), allSky(64), options).aborted);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GT(told.back(), 0.9);
  // Also while a face that is drawn is spread over the sky.
  for (const double stop : { 0.02, 0.13, 0.4, 0.9 })
  {
    options.progress = [stop](double done) { return done < stop - 1e-9; };
    const RenderedImage image = renderPanorama(scene.view(), allSky(64), options);
    EXPECT_TRUE(image.aborted) << stop;
    EXPECT_EQ(largest(image.radiance), 0) << stop;
  }
}
} // namespace
