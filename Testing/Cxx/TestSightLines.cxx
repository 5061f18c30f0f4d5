#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/SightLines.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

// A large galaxy close by and far from face-on, as a camera at the Earth sees it.
namespace galaxy
{
namespace
{
constexpr double distance = 60;                                       ///< kpc
constexpr double outer = 12;                                          ///< kpc
constexpr int side = 120;                                             ///< pixels
constexpr double pixel = 2 * outer / side * 3600 / degree / distance; ///< arcsec
constexpr double kpc = 2 * outer / side;

/// Knots along a ridge, away from the centre.
double picture(double x, double y)
{
  const double knots = 1 + 0.9 * std::sin(3 * x) * std::sin(5 * y + x);
  return 0.5 * std::exp(-std::abs(y - 0.15 * x) - 0.1 * std::abs(x)) * knots;
}

Galaxy nearGalaxy(const std::vector<ComponentDescription>& components)
{
  Galaxy input;
  input.rings.file = "near.txt";
  input.rings.rings = { ring(outer / distance / degree * 3600, 200, 0, 77, 100) };
  Image image;
  image.file = "near.fits";
  image.width = image.height = side;
  for (int k = 0; k < side * side; ++k)
  {
    image.values.push_back(static_cast<float>(
      picture((k % side - (side - 1) / 2.0) * kpc, (k / side - (side - 1) / 2.0) * kpc)));
  }
  input.images = { image };
  input.description.file = "near.galaxy";
  input.description.centre = m83Centre;
  input.description.distance = distance / 1000;
  input.description.images = { pictureDescription("picture", pixel) };
  input.description.components = components;
  return input;
}

ComponentDescription disk(const std::string& name)
{
  ComponentDescription made;
  made.name = name;
  made.particles = 60000;
  made.layers.resize(1);
  made.layers[0].image = "picture";
  made.layers[0].clips = true;
  made.thickness.model = ThicknessModel::Tapered;
  made.thickness.scaleHeight = 0.1;
  made.thickness.sigma = 0.02;
  return made;
}

ComponentDescription dustDisk(DustModel model)
{
  ComponentDescription dust = disk("dust");
  dust.role = ComponentRole::Absorbs;
  dust.opticalDepth = 2;
  dust.hasDust = true;
  dust.dust.model = model;
  dust.dust.steps = 4;
  dust.dust.stepLength = 0.01;
  return dust;
}

struct Sky
{
  std::vector<double> light = std::vector<double>(side * side, 0);
  std::vector<double> size = std::vector<double>(side * side, 0); ///< pi h^2 of the particles
};

/// By the angles from the line of sight to the centre, as a pinhole camera measures them, or along
/// parallels.
Sky skyOf(const Particles& particles, bool fromEarth = true)
{
  Sky sky;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const float* p = &particles.position[3 * i];
    const double away = fromEarth ? distance - p[2] : distance;
    const double column = std::floor(p[0] / away / (kpc / distance) + side / 2.0);
    const double row = std::floor(p[1] / away / (kpc / distance) + side / 2.0);
    if (column >= 0 && row >= 0 && column < side && row < side)
    {
      const int k = static_cast<int>(row) * side + static_cast<int>(column);
      const double h = particles.smoothingLength[i];
      sky.light[k] += particles.intensity[i] / (away * away);
      sky.size[k] += h * h / (away * away);
    }
  }
  return sky;
}

double correlation(const std::vector<double>& p, const std::vector<double>& q)
{
  const auto mean = [&](auto f) {
    double sum = 0;
    for (std::size_t k = 0; k < p.size(); ++k)
    {
      sum += f(p[k], q[k]) / static_cast<double>(p.size());
    }
    return sum;
  };
  const double mp = mean([](double a, double) { return a; });
  const double mq = mean([](double, double b) { return b; });
  return mean([=](double a, double b) { return (a - mp) * (b - mq); }) /
    std::sqrt(mean([=](double a, double) { return (a - mp) * (a - mp); }) *
      mean([=](double, double b) { return (b - mq) * (b - mq); }));
}

/// The image's flux by pixel in steradians of the picture's brightness, where it shows the disc.
void expectTheImage(const Galaxy& input, double factor, const char* what)
{
  const Particles particles = buildGalaxy(input);
  const Sky earth = skyOf(particles), parallel = skyOf(particles, false);
  std::vector<double> seen, image, off;
  for (int k = 0; k < side * side; ++k)
  {
    const double x = (k % side - (side - 1) / 2.0) * kpc, y = (k / side - (side - 1) / 2.0) * kpc;
    const double u = -x * std::sin(100 * degree) + y * std::cos(100 * degree);
    const double w = x * std::cos(100 * degree) + y * std::sin(100 * degree);
    if (std::hypot(u, w / std::cos(77 * degree)) < outer - 1)
    {
      // Pixels of equal size on the plane are seen under angles that fall off its axis: cos^3.
      seen.push_back(earth.light[k]);
      off.push_back(parallel.light[k]);
      image.push_back(factor * input.images[0].values[k] * std::pow(kpc / distance, 2));
    }
  }
  ASSERT_GT(image.size(), 1500u);
  EXPECT_GT(correlation(seen, image), 0.99999) << what;
  EXPECT_LT(correlation(off, image), 0.95) << what;
  double sum = 0, expected = 0;
  for (std::size_t k = 0; k < image.size(); ++k)
  {
    sum += seen[k];
    expected += image[k];
  }
  EXPECT_NEAR(sum / expected, 1, 1e-4) << what;
}
} // namespace

TEST(SightLines, FromEarthEveryKindOfComponentIsItsImage)
{
  for (const ThicknessModel model : { ThicknessModel::Gaussian, ThicknessModel::Tapered,
         ThicknessModel::Flared, ThicknessModel::Hydrostatic, ThicknessModel::Rings })
  {
    ComponentDescription stars = disk("stars");
    stars.thickness.model = model;
    stars.thickness.children = 3;
    expectTheImage(nearGalaxy({ stars }), 1, "thickness");
  }
  for (const DustModel model :
    { DustModel::RingVelocity, DustModel::DiskRotation, DustModel::Fractal })
  {
    expectTheImage(nearGalaxy({ dustDisk(model) }), 2, "dust");
  }
  ComponentDescription even = disk("even");
  even.sampling = SeedSampling::SurfaceUniform;
  expectTheImage(nearGalaxy({ even }), 1, "even seeds");
}

TEST(SightLines, ABulgeAndTheDiskItTakesItsLightFromAreOneImage)
{
  ComponentDescription bulge;
  bulge.name = "bulge";
  bulge.type = ComponentType::Spheroid;
  bulge.particles = 20000;
  bulge.spheroid.sigma = { 1.5, 1.5, 3 };
  bulge.spheroid.lightFrom = "stars";
  bulge.spheroid.lightFraction = 0.3;
  expectTheImage(nearGalaxy({ disk("stars"), bulge }), 1, "bulge");
}

TEST(SightLines, StandWhereTheImageHasThemAsLargeAsTheyWereMade)
{
  ComponentDescription stars = disk("stars");
  stars.smoothing.model = SmoothingModel::Constant;
  stars.smoothing.length = 0.2;
  const Particles particles = buildGalaxy(nearGalaxy({ stars }));
  double nearest = 0, farthest = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const double z = particles.position[3 * i + 2];
    nearest = std::max(nearest, z);
    farthest = std::min(farthest, z);
    ASSERT_NEAR(particles.smoothingLength[i] / 0.2 * distance / (distance - z), 1, 1e-6);
  }
  EXPECT_GT(nearest, 8);
  EXPECT_LT(farthest, -8);
}

TEST(SightLines, WithoutImagesADiskIsWhatItsRingsAre)
{
  ComponentDescription flat = disk("flat");
  flat.layers.clear();
  flat.profile = DiskProfile::Exponential;
  flat.scaleLength = 4;
  flat.thickness.model = ThicknessModel::Rings;
  flat.thickness.sigma = 0;
  const auto reach = [](const Particles& particles) {
    double most = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      most = std::max<double>(most,
        std::hypot(
          particles.position[3 * i], particles.position[3 * i + 1], particles.position[3 * i + 2]));
    }
    return most;
  };
  EXPECT_LE(reach(buildGalaxy(nearGalaxy({ flat }))), outer * (1 + 1e-6));
  // Beside one with images it stays in line with that.
  const Galaxy both = nearGalaxy({ flat, disk("stars") });
  const Particles moved = buildFromSeeds(both, "flat", buildSeeds(both, "flat"));
  EXPECT_GT(reach(moved), outer * 1.01);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    const SeenParticle seen = seenFromEarth(moved, i, distance / 1000);
    const Vec3 n = TiltedDisk(both.rings, distance / 1000).frame(0).n;
    ASSERT_LT(std::abs(dot(seen.place, n)), 1e-5);
  }
}

TEST(SightLines, BehindTheObserverThereAreNone)
{
  EXPECT_EQ(nearness(10, 0), 1);
  EXPECT_EQ(nearness(10, 5), 0.5);
  EXPECT_EQ(nearness(10, -10), 2);
  for (const double z : { 10.0, 11.0, 1e30, 9.999999 })
  {
    EXPECT_GT(nearness(10, z), 0) << z;
  }
}
} // namespace galaxy
