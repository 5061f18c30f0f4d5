#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/LightMap.h"
#include "Filters/Model/SkyToDisk.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <array>
#include <numeric>

// Dust built from images, against the formulas of its calibration, pixel by pixel.
namespace galaxy
{
namespace
{
using Field = std::function<double(double x, double y)>;

constexpr double arcsecs = 10;
constexpr double side = arcsecs * m83Kpc; ///< of a pixel, kpc
constexpr int size = 60;
constexpr double radius = 6;

double smooth(double x, double y)
{
  return 0.2 + 0.7 * std::exp(-(x * x + y * y) / 18) + 0.02 * x;
}

/// An absorbing disc, tilted by 60 degrees about the y axis, and one image of it.
Galaxy dustGalaxy(DepthCalibration calibration, const Field& values, const std::string& unit = "")
{
  Galaxy input;
  input.rings = flatDisk(radius, 60);
  input.images = { skyPicture(size, values, arcsecs) };
  input.images[0].unit = unit;
  GalaxyDescription& galaxy = input.description;
  galaxy.file = "m.galaxy";
  galaxy.centre = m83Centre;
  galaxy.distance = m83Distance;
  galaxy.images = { pictureDescription("dust", arcsecs) };
  ComponentDescription dust;
  dust.name = "dust";
  dust.role = ComponentRole::Absorbs;
  dust.particles = 10000;
  dust.opticalDepth = 0.8;
  dust.depth.calibration = calibration;
  dust.layers.resize(1);
  dust.layers[0].image = "dust";
  dust.layers[0].clips = true;
  dust.thickness.model = ThicknessModel::Rings;
  dust.thickness.sigma = 0;
  galaxy.components = { dust };
  return input;
}

void addImage(
  Galaxy& input, const std::string& name, const Field& values, const std::string& unit = "")
{
  input.images.push_back(skyPicture(size, values, arcsecs));
  input.images.back().unit = unit;
  input.description.images.push_back(pictureDescription(name, arcsecs));
}

struct Pixel
{
  double x, y;                 ///< of its middle, kpc
  std::array<double, 4> light; ///< per kpc^2 of sky: whole, red, green, blue
};

/// What a component's particles sum up to on every pixel of the images.
std::vector<Pixel> pixelsOf(const Particles& particles, int component = 0)
{
  std::vector<Pixel> pixels(size * size);
  for (int p = 0; p < size * size; ++p)
  {
    pixels[p] = { (p % size - (size - 1) / 2.0) * side, (p / size - (size - 1) / 2.0) * side, {} };
  }
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    if (particles.component[i] == component)
    {
      const int column = int(std::floor(particles.position[3 * i] / side + size / 2.0));
      const int row = int(std::floor(particles.position[3 * i + 1] / side + size / 2.0));
      const double light = particles.intensity[i] / (side * side);
      Pixel& pixel = pixels.at(row * size + column);
      pixel.light[0] += light;
      for (int c = 0; c < 3; ++c)
      {
        pixel.light[1 + c] += light * particles.color[3 * i + c] / 255;
      }
    }
  }
  return pixels;
}

/// The radius in the plane of the tilted disc.
double planeRadius(const Pixel& pixel)
{
  return std::hypot(pixel.x / std::cos(60 * degree), pixel.y);
}

/// Every pixel well on the disc has this optical depth.
void expectDepth(const Galaxy& input, const Field& depth, double tolerance = 1e-5)
{
  int compared = 0;
  for (const Pixel& pixel : pixelsOf(allSeenFromEarth(buildGalaxy(input))))
  {
    if (planeRadius(pixel) < radius - 4 * side)
    {
      const double expected = depth(pixel.x, pixel.y);
      EXPECT_NEAR(pixel.light[0], expected, tolerance * expected) << pixel.x << ' ' << pixel.y;
      ++compared;
    }
  }
  EXPECT_GT(compared, 300);
}

double totalOf(const Particles& particles)
{
  return std::accumulate(particles.intensity.begin(), particles.intensity.end(), 0.0);
}

/// The mean of f over the disc's area.
double meanOnDisk(const Field& f)
{
  const int steps = 400;
  double sum = 0;
  for (int k = 0; k < steps; ++k)
  {
    const double r = radius * std::sqrt((k + 0.5) / steps);
    for (int l = 0; l < steps; ++l)
    {
      const double theta = 2 * pi * (l + 0.5) / steps;
      sum += f(r * std::cos(theta) * std::cos(60 * degree), r * std::sin(theta));
    }
  }
  return sum / (steps * steps);
}
} // namespace

TEST(CalibratedDust, GivenIsAlongTheLineOfSight)
{
  expectDepth(dustGalaxy(DepthCalibration::Given, smooth),
    [](double x, double y) { return 0.8 * smooth(x, y); });
}

TEST(CalibratedDust, FaceOnIsThePathThroughADiscOfFiniteThickness)
{
  const double path = 1 / std::sqrt(0.25 + 0.01 * 0.75);
  expectDepth(dustGalaxy(DepthCalibration::FaceOn, smooth),
    [=](double x, double y) { return 0.8 * path * smooth(x, y); });
}

TEST(CalibratedDust, FaceOnCullsByTheIntensity)
{
  // Intensities of 0.3, whose depth of 0.47 the threshold must not see, and of 0.9.
  const Field halves = [](double, double y) { return y > 0 ? 0.9 : 0.3; };
  Galaxy input = dustGalaxy(DepthCalibration::FaceOn, halves);
  input.description.components[0].layers[0].threshold = 0.4;
  const double depth = 0.8 * 0.9 / std::sqrt(0.25 + 0.01 * 0.75);
  expectDepth(input, [=](double, double y) { return y > 0 ? depth : 0; });
}

TEST(CalibratedDust, FaceOnSumsTheSheetsOfAFold)
{
  Galaxy input = dustGalaxy(DepthCalibration::FaceOn, [](double, double) { return 0.5; });
  input.rings.rings = { ring(0, 200, 10, 0, 0), ring(2.5 / m83Kpc, 200, 10, 0, 0),
    ring(3.5 / m83Kpc, 200, 10, 75, 0), ring(7 / m83Kpc, 200, 10, 75, 0) };
  input.description.components[0].particles = 40000;
  const TiltedDisk disk(input.rings, m83Distance);
  int folded = 0;
  for (const Pixel& pixel : pixelsOf(allSeenFromEarth(buildGalaxy(input))))
  {
    double path = 0;
    const std::vector<DiskPoint> places = skyToDisk(disk, pixel.x, pixel.y);
    for (const DiskPoint& place : places)
    {
      const double cos2 = std::pow(disk.frame(place.r).n.z, 2);
      path += 1 / std::sqrt(cos2 + 0.01 * (1 - cos2));
    }
    folded += places.size() > 1 ? 1 : 0;
    if (!places.empty() && places.back().r < 6.5)
    {
      EXPECT_NEAR(pixel.light[0], 0.8 * 0.5 * path, 1e-4 * path) << pixel.x << ' ' << pixel.y;
    }
  }
  EXPECT_GT(folded, 20);
}

TEST(CalibratedDust, FaceOnOfAProfileIsItsOpticalDepth)
{
  // 2 pi L^2 (1 - (1 + R/L) exp(-R/L)) of disc times the depth across it, whichever way it is said.
  const double whole = 2 * pi * 4 * (1 - (1 + radius / 2) * std::exp(-radius / 2));
  for (const DepthCalibration calibration : { DepthCalibration::Given, DepthCalibration::FaceOn })
  {
    Galaxy input = dustGalaxy(calibration, smooth);
    ComponentDescription& dust = input.description.components[0];
    dust.layers.clear();
    dust.profile = DiskProfile::Exponential;
    dust.scaleLength = 2;
    EXPECT_NEAR(totalOf(allSeenFromEarth(buildGalaxy(input))) / (0.8 * whole), 1, 1e-3)
      << int(calibration);
  }
}

TEST(CalibratedDust, HydrocarbonsInProportion)
{
  const Field starlight = [](double x, double y) { return 0.5 + 0.1 * smooth(y, x); };
  for (const bool takesOff : { false, true })
  {
    Galaxy input = dustGalaxy(DepthCalibration::PAH8um, smooth, "MJy/sr");
    addImage(input, "stars", starlight, "MJy/sr");
    DepthDescription& depth = input.description.components[0].depth;
    depth.referenceDepth = 1.7;
    depth.stellarImage = takesOff ? "stars" : "";
    const Field signal = [&](double x, double y) {
      return smooth(x, y) - (takesOff ? 0.232 * starlight(x, y) : 0);
    };
    // The mean is that of the pixels: to second order in their size.
    const double perSignal = 1.7 / meanOnDisk(signal);
    expectDepth(
      input, [&](double x, double y) { return perSignal * signal(x, y); }, 2e-3);
  }
}

TEST(CalibratedDust, GasWithAndWithoutMolecules)
{
  const Field atoms = [](double x, double y) { return 2e21 * smooth(x, y); };
  const Field co = [](double x, double y) { return 8 * smooth(y, x); };
  for (const bool adds : { false, true })
  {
    Galaxy input = dustGalaxy(DepthCalibration::Gas, atoms, "atoms/cm2");
    addImage(input, "co", co, "K km/s");
    DepthDescription& depth = input.description.components[0].depth;
    depth.dustToGas = 1.5;
    depth.coToH2 = 3e20;
    depth.molecularImage = adds ? "co" : "";
    expectDepth(input, [&](double x, double y) {
      return 1.5 * (atoms(x, y) + (adds ? 2 * 3e20 * co(x, y) : 0)) / 2.40e21;
    });
  }
}

TEST(CalibratedDust, DustAt250um)
{
  const Field brightness = [](double x, double y) { return 15 * smooth(x, y); };
  Galaxy input = dustGalaxy(DepthCalibration::Dust250um, brightness, "MJy/sr");
  input.description.components[0].depth.dustTemperature = 23;
  const double nu = 299792458 / 250e-6;
  const double planck = 2 * 6.62607015e-34 * nu * nu * nu / (299792458.0 * 299792458) /
    (std::exp(6.62607015e-34 * nu / (1.380649e-23 * 23)) - 1) / 1e-26;
  expectDepth(input, [&](double x, double y) { return 6500 * 1e6 * brightness(x, y) / planck; });
}

TEST(CalibratedDust, LightIsDereddenedByTheDustsDepthWhereThereIsDust)
{
  for (const DustGeometry geometry : { DustGeometry::Sheet, DustGeometry::Mixed })
  {
    Galaxy input = dustGalaxy(DepthCalibration::Given, smooth);
    addImage(input, "light", [](double, double y) { return 0.4 + 0.03 * y; });
    ComponentDescription dust = input.description.components[0], stars = dust;
    dust.opticalDepth = 3;
    dust.innerRadius = 2;
    dust.outerRadius = 4;
    stars.name = "stars";
    stars.role = ComponentRole::Emits;
    stars.layers[0].image = "light";
    stars.deredden = "dust";
    stars.dustGeometry = geometry;
    input.description.components = { dust, stars };
    int behind = 0, free = 0;
    for (const Pixel& pixel : pixelsOf(allSeenFromEarth(buildGalaxy(input)), 1))
    {
      const double r = planeRadius(pixel);
      const bool isBehind = r > 2 && r < 4;
      for (int c = 0; c < 3 && r < radius - 4 * side && std::abs(r - 2) > 1e-3; ++c)
      {
        const double tau = isBehind ? 3 * smooth(pixel.x, pixel.y) * dust.absorption[c] : 0;
        const double leaves = geometry == DustGeometry::Sheet ? 0.5 * (1 + std::exp(-tau))
          : tau > 0                                           ? -std::expm1(-tau) / tau
                                                              : 1;
        // The blue is the largest channel; the others are 8-bit ratios to it.
        const double expected = (0.4 + 0.03 * pixel.y) / leaves;
        const double tolerance = c == 2 || !isBehind ? 1e-5 : 0.004;
        EXPECT_NEAR(pixel.light[1 + c] / expected, 1, tolerance) << r << ' ' << c;
        (isBehind ? behind : free) += 1;
      }
    }
    EXPECT_GT(behind, 300);
    EXPECT_GT(free, 200);
  }
}

TEST(CalibratedDust, CloudsKeepTheWholeCrossSection)
{
  for (const NormalizeAt normalizeAt : { NormalizeAt::Seed, NormalizeAt::None })
  {
    Galaxy input = dustGalaxy(DepthCalibration::Given, smooth);
    ComponentDescription& dust = input.description.components[0];
    dust.normalizeAt = normalizeAt;
    dust.hasDust = true;
    dust.dust.model = DustModel::Fractal;
    dust.dust.children = 4;
    dust.dust.contrast = 0;
    const double smoothTotal = totalOf(allSeenFromEarth(buildGalaxy(input)));
    for (const FractalKind kind : { FractalKind::FBm, FractalKind::Ridged })
    {
      for (const double contrast : { 1.0, 3.0, 5.0 })
      {
        dust.dust.noise = kind;
        dust.dust.contrast = contrast;
        EXPECT_NEAR(totalOf(allSeenFromEarth(buildGalaxy(input))) / smoothTotal, 1, 1e-5)
          << contrast;
      }
    }
  }
}

TEST(CalibratedDust, CloudsAreTheSameForAnyNumberOfThreads)
{
  Galaxy input = dustGalaxy(DepthCalibration::Given, smooth);
  ComponentDescription& dust = input.description.components[0];
  dust.normalizeAt = NormalizeAt::Seed;
  dust.particles = 70000; // more than a block of the sums
  dust.hasDust = true;
  dust.dust.model = DustModel::Fractal;
  dust.dust.children = 1;
  dust.dust.contrast = 4;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Particles one = buildGalaxy(input);
  omp_set_num_threads(3);
  EXPECT_TRUE(equalBits(one.intensity, buildGalaxy(input).intensity));
  omp_set_num_threads(threads);
}
} // namespace galaxy
