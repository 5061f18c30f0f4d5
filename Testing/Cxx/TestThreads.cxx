// The particles are the same, bit for bit, for 1, 2 and 16 threads; of the kinds of components that
// other tests of this build with one seed or few particles. Each has more than one block of sums.
#include "Filters/Model/GalaxyBuilder.h"
#include "Testing/Cxx/HardCaseFixtures.h"

#include <omp.h>

namespace galaxy
{
namespace
{
constexpr std::size_t block = 65536; ///< of particles, whose sums are taken one by one
constexpr long long seeds = 70000;

double unevenLight(double x, double y)
{
  return 0.1 + 0.8 * std::exp(-std::hypot(x, y) / 4) + 0.01 * std::sin(x);
}

/// A component of one particle a seed, moving at random.
ComponentDescription manySeeds(const std::string& name = "stars")
{
  ComponentDescription component = thickLayer();
  component.name = name;
  component.particles = seeds;
  component.thickness.children = 1;
  component.velocityDispersion = 12;
  return component;
}

ComponentDescription absorber(DepthCalibration calibration, const std::string& name = "dust")
{
  ComponentDescription dust = manySeeds(name);
  dust.role = ComponentRole::Absorbs;
  dust.opticalDepth = 0.7;
  dust.depth.calibration = calibration;
  return dust;
}

ComponentDescription spheroid()
{
  ComponentDescription component;
  component.name = "spheroid";
  component.type = ComponentType::Spheroid;
  component.particles = seeds;
  component.velocityDispersion = 30;
  component.spheroid.profile = SpheroidProfile::Plummer;
  return component;
}

Galaxy galaxyFrom(const std::vector<ComponentDescription>& components)
{
  RingTable rings = flatDisk(10, 40, 30);
  rings.rings.insert(rings.rings.begin(), ring(0, 100, 10, 20, 10)); // warped
  Galaxy input = galaxyOf(rings, components, unevenLight);
  input.images[0].unit = "MJy/sr";
  return input;
}

void expectSameForAnyThreads(const Galaxy& input)
{
  BuildOptions options;
  options.velocities = true;
  omp_set_num_threads(1);
  BuildReport report;
  const Particles one = buildGalaxy(input, options, &report);
  for (const ComponentReport& component : report.components)
  {
    EXPECT_GT(component.particles, block) << component.name;
  }
  for (const int threads : { 2, 16 })
  {
    omp_set_num_threads(threads);
    BuildReport again;
    const Particles many = buildGalaxy(input, options, &again);
    EXPECT_TRUE(equalBits(one.position, many.position)) << threads;
    EXPECT_TRUE(equalBits(one.smoothingLength, many.smoothingLength)) << threads;
    EXPECT_TRUE(equalBits(one.intensity, many.intensity)) << threads;
    EXPECT_TRUE(equalBits(one.color, many.color)) << threads;
    EXPECT_TRUE(equalBits(one.component, many.component)) << threads;
    EXPECT_TRUE(equalBits(one.velocity, many.velocity)) << threads;
    for (std::size_t k = 0; k < again.components.size(); ++k)
    {
      EXPECT_EQ(report.components[k].light, again.components[k].light);
      EXPECT_EQ(report.components[k].flux, again.components[k].flux);
      EXPECT_EQ(report.components[k].smoothingLength, again.components[k].smoothingLength);
    }
  }
}
} // namespace

TEST(Threads, RandomMotionOfADisk)
{
  expectSameForAnyThreads(galaxyFrom({ manySeeds() }));
}

TEST(Threads, ListedClusters)
{
  ComponentDescription clusters = spheroid();
  clusters.spheroid.luminosity = 3;
  for (int k = 0; k < 150; ++k)
  {
    clusters.spheroid.listed.push_back(
      { { 0.1 * k, std::sin(0.3 * k), std::cos(0.7 * k) }, 1.0 + k % 7, k % 3 * 0.01 });
  }
  expectSameForAnyThreads(galaxyFrom({ clusters }));
}

TEST(Threads, NestedEllipsoids)
{
  ComponentDescription shells = spheroid();
  shells.spheroid.ellipsoids = { { 0.5, { 0.9, 0.8 }, 10, 20 }, { 2, { 0.8, 0.6 }, 40, 30 },
    { 6, { 0.6, 0.5 }, 70, 50 } };
  expectSameForAnyThreads(galaxyFrom({ shells }));
}

TEST(Threads, CalibratedDust)
{
  for (const DepthCalibration calibration : { DepthCalibration::FaceOn, DepthCalibration::PAH8um })
  {
    expectSameForAnyThreads(galaxyFrom({ absorber(calibration) }));
  }
}

TEST(Threads, DereddenedStars)
{
  ComponentDescription stars = manySeeds();
  stars.deredden = "dust";
  expectSameForAnyThreads(galaxyFrom({ stars, absorber(DepthCalibration::Given) }));
}

TEST(Threads, RidgedDust)
{
  ComponentDescription dust = absorber(DepthCalibration::Given);
  dust.hasDust = true;
  dust.dust.model = DustModel::Fractal;
  dust.dust.noise = FractalKind::Ridged;
  dust.dust.children = 1;
  dust.dust.winding = 2;
  expectSameForAnyThreads(galaxyFrom({ dust }));
}
} // namespace galaxy
