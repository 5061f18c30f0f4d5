#include "Testing/Cxx/HardCaseFixtures.h"
#include "Testing/Cxx/ThicknessFixtures.h"

#include <omp.h>

// Hard cases of what seeds become, numbered as in the other TestHardCases files.

namespace galaxy
{
namespace
{
constexpr std::array<ThicknessModel, 5> thicknessModels = { ThicknessModel::Gaussian,
  ThicknessModel::Tapered, ThicknessModel::Flared, ThicknessModel::Hydrostatic,
  ThicknessModel::Rings };
constexpr std::array<DustModel, 3> dustModels = { DustModel::RingVelocity, DustModel::DiskRotation,
  DustModel::Fractal };
constexpr std::array<SeedSampling, 2> samplings = { SeedSampling::ImageDriven,
  SeedSampling::SurfaceUniform };

ComponentDescription dustOf(DustModel model)
{
  ComponentDescription dust = thickLayer();
  dust.name = "lanes";
  dust.role = ComponentRole::Absorbs;
  dust.hasDust = true;
  dust.dust.model = model;
  dust.dust.steps = 5;
  dust.particles = 3000;
  return dust;
}

ComponentDescription spheroidOf(SpheroidProfile profile)
{
  ComponentDescription spheroid;
  spheroid.name = "spheroid";
  spheroid.type = ComponentType::Spheroid;
  spheroid.particles = 2000;
  spheroid.spheroid.profile = profile;
  return spheroid;
}

/// A disk component of every thickness and every dust, with one sampling.
std::vector<ComponentDescription> everyDisk(SeedSampling sampling)
{
  std::vector<ComponentDescription> components;
  for (const ThicknessModel model : thicknessModels)
  {
    components.push_back(thickLayer(model));
    components.back().thickness.sigma = 0.1;
  }
  for (const DustModel model : dustModels)
  {
    components.push_back(dustOf(model));
  }
  for (ComponentDescription& component : components)
  {
    component.sampling = sampling;
  }
  return components;
}

bool equalParticles(const Particles& p, const Particles& q)
{
  return equalBits(p.position, q.position) && equalBits(p.smoothingLength, q.smoothingLength) &&
    equalBits(p.intensity, q.intensity) && equalBits(p.color, q.color) &&
    equalBits(p.component, q.component) && equalBits(p.velocity, q.velocity);
}

/// Heights over a face-on disc, kpc.
std::vector<double> heightsOf(const Particles& particles)
{
  std::vector<double> heights;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    heights.push_back(positionOf(particles, i).z);
  }
  return heights;
}

double largest(const std::vector<double>& heights)
{
  double most = 0;
  for (const double z : heights)
  {
    most = std::max(most, std::abs(z));
  }
  return most;
}

double rms(const std::vector<double>& heights)
{
  double squares = 0;
  for (const double z : heights)
  {
    squares += z * z;
  }
  return std::sqrt(squares / static_cast<double>(heights.size()));
}
} // namespace

TEST(HardCase, N20_NoScaleHeightIsExactlyPlanar)
{
  RingTable rings = m83Rings();
  const TiltedDisk disk(rings, m83Distance);
  const auto mostOver = [&](double height) {
    for (Ring& ring : rings.rings)
    {
      ring.scaleHeight = height;
    }
    const Particles particles = buildGalaxy(galaxyOf(rings, { thickLayer(ThicknessModel::Rings) }));
    std::vector<double> heights;
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const Vec3 p = seenFromEarth(particles, i).place;
      heights.push_back(dot(p, disk.frame(length(p)).n));
    }
    return largest(heights);
  };
  EXPECT_LT(mostOver(0), 1e-5); // single precision of 15 kpc
  EXPECT_GT(mostOver(10), 0.3);
  // Face-on nothing is rounded at all.
  RingTable flat = flatDisk(10);
  flat.rings[0].scaleHeight = 0;
  EXPECT_EQ(
    largest(heightsOf(buildGalaxy(galaxyOf(flat, { thickLayer(ThicknessModel::Rings) })))), 0);
}

TEST(HardCase, N21_LorentzianTailEnds)
{
  RingTable rings = flatDisk(10);
  rings.layerLaw = LayerLaw::Lorentzian;
  ComponentDescription stars = ofPoints(thickLayer(ThicknessModel::Rings));
  stars.thickness.children = 10;
  const std::vector<double> heights = heightsOf(buildGalaxy(galaxyOf(rings, { stars })));
  const double scaleHeight = 10 * m83Kpc;
  EXPECT_LE(largest(heights), 10 * scaleHeight * (1 + 1e-6));
  EXPECT_GT(largest(heights), 9.9 * scaleHeight);
  // The mean of z^2 under 1/(1 + z^2) up to 10: 10/atan(10) - 1.
  EXPECT_NEAR(rms(heights) / (scaleHeight * std::sqrt(10 / std::atan(10.0) - 1)), 1, 0.03);
}

TEST(HardCase, N22_WithoutRotationTheFlareIsCapped)
{
  RingTable still = flatDisk(10);
  still.rings[0].rotationVelocity = 0;
  for (const double exponent : { 0.5, 1.0, 2.0 })
  {
    ComponentDescription gas = ofPoints(thickLayer(ThicknessModel::Flared));
    gas.thickness.fwhmMaximum = 2;
    gas.thickness.velocityExponent = exponent;
    const Particles particles = buildGalaxy(galaxyOf(still, { gas }));
    expectFinite(particles);
    EXPECT_NEAR(rms(heightsOf(particles)) / (2 / std::sqrt(8 * std::log(2.0))), 1, 0.03);
  }
}

TEST(HardCase, N23_TheCentreIsFinite)
{
  const BuildOptions options = withVelocities();
  // An odd picture has a pixel in the middle, which alone is lit.
  const auto point = [](double x, double y) { return std::hypot(x, y) < 1e-9 ? 0.7 : 0; };
  RingTable rising = m83Rings();
  rising.rings[0].rotationVelocity = 0;
  for (const RingTable& rings : { m83Rings(), rising })
  {
    for (const SeedSampling sampling : samplings)
    {
      const Galaxy input =
        galaxyOf(rings, everyDisk(sampling), point, picturePixel, pictureSide + 1);
      BuildReport report;
      const Particles particles = buildGalaxy(input, options, &report);
      expectFinite(particles);
      for (const ComponentReport& done : report.components)
      {
        EXPECT_NEAR(done.light / (0.7 * pictureKpc * pictureKpc), 1, 1e-5) << done.name;
      }
    }
    // Seeds at R = 0 itself and beside it.
    for (ComponentDescription& component : everyDisk(SeedSampling::ImageDriven))
    {
      const Galaxy input = galaxyOf(rings, { component });
      const Particles particles =
        buildFromSeeds(input, component.name, seedsAt({ 0, 1e-30F, 0, 0, 1e-9, 1 }), options);
      EXPECT_GE(particles.size(), 6u);
      expectFinite(particles);
    }
  }
}

TEST(HardCase, N24_AnUnstableDustStepIsRefused)
{
  for (const DustModel model : { DustModel::RingVelocity, DustModel::DiskRotation })
  {
    ComponentDescription dust = dustOf(model);
    dust.particles = 100;
    // nu dt = (sigma_w/h_d) l/sqrt(v^2 + 2 sigma^2) = 1, at the disc's 200 km/s
    const double limit = dust.dust.scaleHeight / dust.dust.verticalDispersion *
      std::sqrt(200.0 * 200 + 2 * std::pow(dust.dust.velocityDispersion, 2));
    dust.dust.stepLength = 1.01 * limit;
    const std::string message = messageOf(galaxyOf(flatDisk(10), { thickLayer(), dust }));
    EXPECT_EQ(message.rfind("hard.galaxy: lanes: dust: ", 0), 0u) << message;
    EXPECT_NE(message.find("step_length"), std::string::npos) << message;
    dust.dust.stepLength = 0.99 * limit;
    EXPECT_EQ(messageOf(galaxyOf(flatDisk(10), { thickLayer(), dust })), "");
  }
}

TEST(HardCase, N32_AnyNumberOfThreadsGivesTheSameBits)
{
  std::vector<ComponentDescription> components = everyDisk(SeedSampling::ImageDriven);
  components[1].sampling = components[5].sampling = SeedSampling::SurfaceUniform;
  components[2].normalizeAt = NormalizeAt::Seed;
  components[3].normalizeAt = NormalizeAt::None;
  components[4].profile = DiskProfile::Exponential;
  components[4].scaleLength = 2;
  components[0].automaticCount = true;
  for (const SpheroidProfile profile : { SpheroidProfile::Gaussian, SpheroidProfile::Sersic,
         SpheroidProfile::Hernquist, SpheroidProfile::Exponential, SpheroidProfile::Plummer,
         SpheroidProfile::NFW, SpheroidProfile::Cored })
  {
    components.push_back(spheroidOf(profile));
  }
  components.push_back(spheroidOf(SpheroidProfile::Sersic));
  components.back().spheroid.lightFrom = "bulged";
  components[1].name = "bulged";
  components.push_back(spheroidOf(SpheroidProfile::Cored));
  components.back().spheroid.clusters = 20;
  for (const SmoothingModel model :
    { SmoothingModel::Neighbours, SmoothingModel::Constant, SmoothingModel::Brightness })
  {
    components[static_cast<std::size_t>(model)].smoothing.model = model;
  }
  const Galaxy input = galaxyOf(
    m83Rings(), components, [](double x, double y) { return std::exp(-std::hypot(x - 1, y) / 4); });
  const BuildOptions options = withVelocities();
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Particles one = buildGalaxy(input, options);
  EXPECT_GT(one.size(), 50000u);
  for (const int threads : { 2, 16 })
  {
    omp_set_num_threads(threads);
    EXPECT_TRUE(equalParticles(one, buildGalaxy(input, options))) << threads;
  }
  omp_set_num_threads(before);
}

TEST(HardCase, N38_NoChildrenOrTooMany)
{
  for (const ThicknessModel model : thicknessModels)
  {
    for (const double children : { 0.0, 1e30 })
    {
      ComponentDescription stars = thickLayer(model);
      stars.particles = 4000;
      stars.thickness.children = children;
      stars.thickness.maximumChildren = 7;
      const Galaxy input = galaxyOf(flatDisk(10, 40, 20), { stars });
      BuildReport report;
      const Particles particles = buildGalaxy(input, {}, &report);
      const ComponentReport& done = report.components[0];
      EXPECT_EQ(done.particles - done.filled, (children > 0 ? 7 : 1) * done.seedsKept);
      expectFinite(particles);
      const EarthView view(input, particles);
      EXPECT_LT(view.worst, 2e-4);
      // Nothing but what a thick edge shows beside the disc comes on top.
      EXPECT_NEAR(done.light / view.flux, 1, 0.1);
      EXPECT_GT(done.light, view.flux * (1 - 2e-4));
    }
  }
}
} // namespace galaxy
