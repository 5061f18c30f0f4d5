#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/GalaxyBuilder.h"
#include "Testing/Cxx/LightFixtures.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

namespace galaxy
{
namespace
{
constexpr double pixel = 15; // arcsec
constexpr int side = 200;

/// Two arms on an exponential disc, 0 to 1.
double spiral(double x, double y)
{
  const double r = std::hypot(x, y) + 0.1;
  return 0.95 * std::exp(-r / 7) * (0.55 + 0.45 * std::cos(2 * std::atan2(y, x) - 4 * std::log(r)));
}

ComponentDescription component(const std::string& name, ThicknessModel model)
{
  ComponentDescription made;
  made.name = name;
  made.particles = 100000;
  LayerDescription layer = clippedLayer();
  layer.image = "optical";
  made.layers = { layer };
  made.thickness.model = model;
  made.thickness.children = 4;
  made.thickness.scaleHeight = 0.35;
  made.thickness.sigma = 0.1;
  return made;
}

Galaxy galaxyOf(const std::vector<ComponentDescription>& components, int size = side)
{
  Galaxy input;
  input.rings = m83Rings();
  input.images = { skyPicture(size, spiral, pixel) };
  input.description.file = "m83.galaxy";
  input.description.centre = m83Centre;
  input.description.distance = m83Distance;
  input.description.spin = SpinSense::Clockwise;
  input.description.images = { pictureDescription("optical", pixel) };
  input.description.components = components;
  return input;
}

/// The light of a component on every pixel of the image, row by row. `onEdge`: the pixels to either
/// side of an edge that a particle is on, to its coordinates' single precision.
std::vector<double> earthView(
  const Particles& particles, std::uint8_t component, std::vector<bool>* onEdge = nullptr)
{
  std::vector<double> light(side * side, 0);
  const double kpc = pixel * m83Kpc;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const SeenParticle seen = seenFromEarth(particles, i);
    const double u = seen.place.x / kpc + side / 2.0, v = seen.place.y / kpc + side / 2.0;
    const double column = std::floor(u), row = std::floor(v);
    if (particles.component[i] == component && column >= 0 && row >= 0 && column < side &&
      row < side)
    {
      const int k = static_cast<int>(row) * side + static_cast<int>(column);
      light[k] += seen.light;
      for (const auto& [at, step] : { std::pair(u, 1), std::pair(v, side) })
      {
        const double off = at - std::round(at);
        const int beside = off > 0 ? k - step : k + step;
        if (onEdge && std::abs(off) < 2e-5 && beside >= 0 && beside < side * side)
        {
          (*onEdge)[k] = true;
          (*onEdge)[beside] = true;
        }
      }
    }
  }
  return light;
}

double fluxAt(int column, int row)
{
  const double kpc = pixel * m83Kpc;
  const double x = (column - (side - 1) / 2.0) * kpc, y = (row - (side - 1) / 2.0) * kpc;
  return static_cast<float>(spiral(x, y)) * kpc * kpc;
}

bool onDisk(const DiskInverse& inverse, int column, int row)
{
  const double kpc = pixel * m83Kpc;
  return inverse.covers((column - (side - 1) / 2.0) * kpc, (row - (side - 1) / 2.0) * kpc);
}
} // namespace

TEST(EarthView, IsTheImagePixelByPixel)
{
  Galaxy input = galaxyOf({ component("stars", ThicknessModel::Tapered),
    component("gas", ThicknessModel::Flared), component("dust", ThicknessModel::Gaussian) });
  ComponentDescription& dust = input.description.components[2];
  dust.particles = 90000;
  dust.role = ComponentRole::Absorbs;
  dust.hasDust = true;
  dust.opticalDepth = 3;
  input.description.components[1].sampling = SeedSampling::SurfaceUniform;
  BuildReport report;
  const Particles particles = buildGalaxy(input, {}, &report);
  const TiltedDisk disk(input.rings, m83Distance, SpinSense::Clockwise);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  for (std::uint8_t k = 0; k < 3; ++k)
  {
    const ComponentReport& done = report.components[k];
    const double factor = k == 2 ? 3 : 1;
    std::vector<bool> onEdge(side * side, false);
    const std::vector<double> light = earthView(particles, k, &onEdge);
    EXPECT_LT(std::count(onEdge.begin(), onEdge.end(), true), 0.03 * side * side);
    const int bins = done.bins;
    double off = 0, worst = 0;
    for (int row = 0; row < side; ++row)
    {
      for (int column = 0; column < side; ++column)
      {
        const double flux = factor * fluxAt(column, row);
        const double is = light[row * side + column];
        // Beside the disc's edge its thickness shows: such pixels may be covered as well.
        if (onDisk(inverse, column, row) || is > 0)
        {
          worst = std::max(worst, onEdge[row * side + column] ? 0 : std::abs(is / flux - 1));
        }
        else
        {
          off += flux;
        }
      }
    }
    EXPECT_EQ(bins, 1) << done.name;
    // The pixels' areas on the tangent plane differ from the flat ones by 1e-4 out here.
    EXPECT_LT(worst, 2e-4) << done.name;
    EXPECT_GT(off, 0);
    EXPECT_NEAR((done.flux - done.light) / off, 1, 0.01) << done.name;
    EXPECT_NEAR(std::accumulate(light.begin(), light.end(), 0.0) / done.light, 1, 1e-6);
    EXPECT_GT(done.filled, 0u);
    EXPECT_LT(done.filled, done.particles / 4);
  }
}

TEST(EarthView, SeedsNormalisedAloneAreBlurredByTheThickness)
{
  const auto residual = [](NormalizeAt at) {
    ComponentDescription stars = component("stars", ThicknessModel::Tapered);
    stars.normalizeAt = at;
    const std::vector<double> light = earthView(buildGalaxy(galaxyOf({ stars })), 0);
    double squares = 0, sum = 0, total = 0, flux = 0;
    for (int row = 60; row < 140; ++row)
    {
      for (int column = 60; column < 140; ++column)
      {
        const double expected = fluxAt(column, row), is = light[row * side + column];
        squares += (is - expected) * (is - expected);
        sum += expected * expected;
        total += is;
        flux += expected;
      }
    }
    EXPECT_NEAR(total / flux, 1, at == NormalizeAt::None ? 0.2 : 0.01);
    return std::sqrt(squares / sum);
  };
  EXPECT_LT(residual(NormalizeAt::Child), 1e-4);
  const double seeds = residual(NormalizeAt::Seed);
  EXPECT_GT(seeds, 0.05);
  EXPECT_LT(seeds, 0.5);
}

TEST(EarthView, ResidualBetweenThePixelsIsShotNoise)
{
  // Cells of 3 x 3 pixels, shifted by half a pixel: the normalisation knows nothing of them.
  ComponentDescription stars = component("stars", ThicknessModel::Tapered);
  const Particles particles = buildGalaxy(galaxyOf({ stars }));
  const double cell = 3 * pixel * m83Kpc, shift = 0.5 * pixel * m83Kpc;
  const int cells = 24;
  std::vector<double> light(cells * cells, 0), variance(cells * cells, 0);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const auto [place, h, seen] = seenFromEarth(particles, i);
    const double u = (place.x - shift) / cell + cells / 2;
    const double v = (place.y - shift) / cell + cells / 2;
    if (u >= 0 && v >= 0 && u < cells && v < cells)
    {
      const int k = static_cast<int>(v) * cells + static_cast<int>(u);
      light[k] += seen;
      variance[k] += seen * seen;
    }
  }
  double chi = 0;
  for (int k = 0; k < cells * cells; ++k)
  {
    double expected = 0;
    const int fine = 30;
    for (int j = 0; j < fine * fine; ++j)
    {
      const double x = (k % cells - cells / 2 + (j % fine + 0.5) / fine) * cell + shift;
      const double y = (k / cells - cells / 2 + (j / fine + 0.5) / fine) * cell + shift;
      expected += spiral(x, y) * cell * cell / (fine * fine);
    }
    chi += (light[k] - expected) * (light[k] - expected) / variance[k];
  }
  EXPECT_LT(chi / (cells * cells), 1);
}

TEST(EarthView, FewParticlesKeepTheLight)
{
  const Galaxy input = galaxyOf({ component("stars", ThicknessModel::Tapered) });
  BuildReport whole, part;
  BuildOptions options;
  buildGalaxy(input, options, &whole);
  options.particleScale = 0.01;
  const Particles few = buildGalaxy(input, options, &part);
  EXPECT_EQ(whole.components[0].bins, 1);
  EXPECT_GE(part.components[0].bins, 8);
  EXPECT_LT(few.size(), 4000u);
  // What is lost lies in the joined pixels at the edge of the disc.
  EXPECT_NEAR(part.components[0].light / whole.components[0].light, 1, 0.01);
}

TEST(EarthView, APixelThatEverySeedMissesGetsAParticle)
{
  ComponentDescription stars = component("stars", ThicknessModel::Tapered);
  stars.sampling = SeedSampling::SurfaceUniform;
  stars.particles = 50;
  Galaxy input = galaxyOf({ stars });
  std::fill(input.images[0].values.begin(), input.images[0].values.end(), 0);
  input.images[0].values[120 * side + 90] = 0.5;
  BuildReport report;
  const Particles particles = buildGalaxy(input, {}, &report);
  EXPECT_EQ(report.components[0].seedsKept, 0u);
  ASSERT_EQ(particles.size(), 1u);
  const double kpc = pixel * m83Kpc;
  EXPECT_NEAR(particles.intensity[0] / (0.5 * kpc * kpc), 1, 1e-3);
  EXPECT_EQ(earthView(particles, 0)[120 * side + 90], seenFromEarth(particles, 0).light);
}

TEST(EarthView, ABulgeTakesItsLightFromThePixels)
{
  ComponentDescription bulge;
  bulge.name = "bulge";
  bulge.type = ComponentType::Spheroid;
  bulge.particles = 30000;
  bulge.spheroid.sigma = { 0.8, 0.8, 0.6 };
  bulge.spheroid.lightFrom = "stars";
  bulge.spheroid.lightFraction = 0.004;
  const Galaxy input = galaxyOf({ component("stars", ThicknessModel::Tapered), bulge });
  BuildReport report;
  const Particles particles = buildGalaxy(input, {}, &report);
  EXPECT_NEAR(report.components[1].light / (0.004 * report.components[0].flux), 1, 0.01);
  const std::vector<double> stars = earthView(particles, 0), round = earthView(particles, 1);
  const TiltedDisk disk(input.rings, m83Distance);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  double fromBulge = 0;
  for (int row = 0; row < side; ++row)
  {
    for (int column = 0; column < side; ++column)
    {
      const int k = row * side + column;
      if (onDisk(inverse, column, row))
      {
        ASSERT_NEAR((stars[k] + round[k]) / fluxAt(column, row), 1, 2e-4);
        fromBulge = std::max(fromBulge, round[k] / fluxAt(column, row));
      }
    }
  }
  EXPECT_GT(fromBulge, 0.1);
  EXPECT_EQ(particles.components[1].name, "bulge");
}

TEST(EarthView, AutomaticCountHasTheNoiseAskedFor)
{
  ComponentDescription stars = component("stars", ThicknessModel::Tapered);
  stars.automaticCount = true;
  stars.noise = 0.1;
  Galaxy input = galaxyOf({ stars });
  const double beam = 60; // arcsec
  input.description.images[0].beam = beam;
  const auto count = [&](double viewPixel) {
    BuildOptions options;
    options.viewPixel = viewPixel;
    BuildReport report;
    buildGalaxy(input, options, &report);
    return static_cast<double>(report.components[0].seedsDrawn);
  };
  const double once = count(0);
  // Light in effective beams: (sum F)^2 / sum F^2 pixels of them.
  double sum = 0, squares = 0;
  for (int k = 0; k < side * side; ++k)
  {
    const double flux = fluxAt(k % side, k / side);
    sum += flux;
    squares += flux * flux;
  }
  const double beams = sum * sum / squares * pixel * pixel / (1.1331 * beam * beam);
  EXPECT_NEAR(once / (100 * beams), 1, 0.01);
  input.description.components[0].noise = 0.05;
  EXPECT_NEAR(count(0) / once, 4, 0.01);
  EXPECT_NEAR(count(2 * beam * m83Kpc) / once, 1, 0.01);
  EXPECT_NEAR(count(0.1 * beam * m83Kpc) / once, 4, 0.01);
}
} // namespace galaxy
