#include "Filters/Model/GalaxyBuilder.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

namespace galaxy
{
namespace
{
ComponentDescription diskComponent(const std::string& name, long long particles, double height)
{
  ComponentDescription component;
  component.name = name;
  component.particles = particles;
  LayerDescription layer;
  layer.image = "optical";
  layer.clips = true;
  component.layers = { layer };
  component.thickness.model = ThicknessModel::Tapered;
  component.thickness.scaleHeight = height;
  component.thickness.children = 3;
  return component;
}

/// M83's rings, one image, and stars, gas, dust and a bulge.
Galaxy galaxyInput()
{
  Galaxy input;
  input.rings = m83Rings();
  input.images = { skyPicture(
    400, [](double x, double y) { return std::exp(-std::hypot(x, y) / 8); }, 10) };
  GalaxyDescription& galaxy = input.description;
  galaxy.file = "m83.galaxy";
  galaxy.centre = m83Centre;
  galaxy.distance = m83Distance;
  galaxy.images = { pictureDescription("optical", 10) };
  galaxy.components = { diskComponent("stars", 20000, 0.3), diskComponent("gas", 10000, 0.3),
    diskComponent("dust", 500, 0.1), diskComponent("bulge", 5000, 0.1) };
  galaxy.components[0].layers[0].threshold = 0.05;
  galaxy.components[1].thickness.model = ThicknessModel::Flared;
  galaxy.components[1].brightness = 9;
  galaxy.components[2].role = ComponentRole::Absorbs;
  galaxy.components[2].hasDust = true;
  galaxy.components[2].opticalDepth = 0.5;
  galaxy.components[3].type = ComponentType::Spheroid;
  return input;
}

double lightOf(const Particles& particles, std::uint8_t component)
{
  double sum = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    sum += particles.component[i] == component ? particles.intensity[i] : 0;
  }
  return sum;
}

bool equalParticles(const Particles& p, const Particles& q)
{
  return equalBits(p.position, q.position) && equalBits(p.smoothingLength, q.smoothingLength) &&
    equalBits(p.intensity, q.intensity) && equalBits(p.color, q.color) &&
    equalBits(p.component, q.component) && equalBits(p.velocity, q.velocity);
}

std::string messageOf(const Galaxy& input)
{
  return errorOf([&] { buildGalaxy(input); });
}
} // namespace

TEST(GalaxyBuilder, BuildsEveryComponent)
{
  const Galaxy input = galaxyInput();
  BuildReport report;
  const Particles particles = buildGalaxy(input, {}, &report);
  ASSERT_EQ(report.components.size(), 4u);
  std::size_t total = 0;
  for (const ComponentReport& component : report.components)
  {
    EXPECT_GT(component.particles, 0u);
    EXPECT_GT(component.smoothingLength, 0);
    EXPECT_LE(component.seedsKept, component.seedsDrawn);
    total += component.particles;
  }
  EXPECT_EQ(total, particles.size());
  EXPECT_EQ(report.components[0].seedsDrawn, 20000u);
  EXPECT_EQ(report.components[0].seedsKept, 20000u); // drawn by the light, none is dark
  EXPECT_EQ(report.components[3].particles, 5000u);
  ASSERT_EQ(particles.components.size(), 4u);
  EXPECT_EQ(particles.components[2].name, "dust");
  EXPECT_TRUE(particles.components[2].absorbs);
  EXPECT_EQ(particles.components[1].brightness, 9);
  EXPECT_TRUE(particles.velocity.empty());
  for (const float x : particles.position)
  {
    ASSERT_TRUE(std::isfinite(x));
  }
}

TEST(GalaxyBuilder, LightIsTheImages)
{
  const Galaxy input = galaxyInput();
  const Particles particles = buildGalaxy(input);
  // The image's exponential of 8 kpc lies within the projected disc almost whole.
  const double whole = 2 * pi * 64;
  EXPECT_NEAR(lightOf(particles, 1) / whole, 1, 0.02); // brightness 9 is not multiplied in
  EXPECT_NEAR(lightOf(particles, 2) / (0.5 * whole), 1, 0.02);
  // Stars below 0.05 of the peak are dark: R < 8 ln 20, 1 - 0.05 (1 + ln 20) of the light.
  EXPECT_NEAR(lightOf(particles, 0) / whole, 1 - 0.05 * (1 + std::log(20.0)), 0.005);
}

TEST(GalaxyBuilder, IsTheSameForAnyNumberOfThreads)
{
  const Galaxy input = galaxyInput();
  BuildOptions options;
  options.velocities = true;
  omp_set_num_threads(1);
  const Particles one = buildGalaxy(input, options);
  EXPECT_EQ(one.velocity.size(), 3 * one.size());
  for (const int threads : { 2, 5 })
  {
    omp_set_num_threads(threads);
    EXPECT_TRUE(equalParticles(one, buildGalaxy(input, options)));
  }
  options.seed = 2;
  EXPECT_FALSE(equalParticles(one, buildGalaxy(input, options)));
}

TEST(GalaxyBuilder, StagesGiveTheSameParticlesAsTheWhole)
{
  Galaxy input = galaxyInput();
  for (ComponentDescription& component : input.description.components)
  {
    component.normalizeAt = NormalizeAt::Seed;
  }
  const Particles whole = buildGalaxy(input);
  std::size_t start = 0;
  for (const char* name : { "stars", "gas", "dust" })
  {
    const Seeds seeds = buildSeeds(input, name);
    const Particles part = buildFromSeeds(input, name, seeds);
    ASSERT_LE(start + part.size(), whole.size());
    EXPECT_TRUE(
      std::equal(part.position.begin(), part.position.end(), whole.position.begin() + 3 * start));
    EXPECT_TRUE(
      std::equal(part.intensity.begin(), part.intensity.end(), whole.intensity.begin() + start));
    ASSERT_EQ(part.components.size(), 1u);
    EXPECT_EQ(part.components[0].name, name);
    start += part.size();
  }
  EXPECT_THROW(buildSeeds(input, "bulge"), Error);
  EXPECT_THROW(buildSeeds(input, "nebula"), Error);
}

TEST(GalaxyBuilder, ParticleScaleKeepsTheLight)
{
  const Galaxy input = galaxyInput();
  BuildOptions options;
  options.particleScale = 2;
  BuildReport report;
  const Particles twice = buildGalaxy(input, options, &report);
  EXPECT_EQ(report.components[0].seedsDrawn, 40000u);
  EXPECT_EQ(report.components[3].particles, 10000u);
  const Particles once = buildGalaxy(input);
  EXPECT_NEAR(lightOf(twice, 1) / lightOf(once, 1), 1, 1e-3);
  EXPECT_NEAR(lightOf(twice, 3) / lightOf(once, 3), 1, 1e-5);
  options.particleScale = 0;
  EXPECT_EQ(buildGalaxy(input, options).size(), 0u);
}

TEST(GalaxyBuilder, ProgressRunsToTheEndAndCanStop)
{
  const Galaxy input = galaxyInput();
  BuildOptions options;
  std::vector<double> fractions;
  options.progress = [&fractions](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  buildGalaxy(input, options);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_GT(fractions.size(), 100u); // of 24 stages
  for (const double stop : { 0.0, 0.3, 0.6, 1.0 })
  {
    options.progress = [stop](double fraction) { return fraction < stop; };
    EXPECT_THROW(buildGalaxy(input, options), Aborted);
  }
  // Who says once that it is not wanted need not say it again. How often it is asked hangs on how
  // the threads share the work.
  for (std::size_t stop = 1; stop < fractions.size(); stop += 29)
  {
    std::size_t told = 0;
    options.progress = [&](double) { return ++told != stop; };
    bool isAborted = false;
    try
    {
      buildGalaxy(input, options);
    }
    catch (const Aborted&)
    {
      isAborted = true;
    }
    EXPECT_LE(told, stop);
    EXPECT_EQ(isAborted, told == stop);
    EXPECT_TRUE(isAborted || stop > 100);
  }
}

TEST(GalaxyBuilder, HasAsManyComponentsAsAByteCounts)
{
  Galaxy input = galaxyInput();
  ComponentDescription one = input.description.components[3];
  input.description.components.clear();
  for (int k = 0; k < 256; ++k)
  {
    one.name = std::to_string(k);
    one.particles = 1;
    input.description.components.push_back(one);
  }
  const Particles particles = buildGalaxy(input);
  ASSERT_EQ(particles.size(), 256u);
  for (int k = 0; k < 256; ++k)
  {
    EXPECT_EQ(particles.component[k], k);
  }
  one.name = "one too many";
  input.description.components.push_back(one);
  EXPECT_NE(messageOf(input).find("more than 256 components"), std::string::npos);
}

TEST(GalaxyBuilder, ErrorsNameFileAndCause)
{
  Galaxy input = galaxyInput();
  input.description.components[0].layers[0].image = "radio";
  EXPECT_EQ(messageOf(input).rfind("m83.galaxy: radio: ", 0), 0u) << messageOf(input);
  input = galaxyInput();
  input.description.components[2].dust.stepLength = 100;
  EXPECT_EQ(messageOf(input).rfind("m83.galaxy: dust: ", 0), 0u) << messageOf(input);
  input = galaxyInput();
  input.images.clear();
  EXPECT_NE(messageOf(input), "");
  input = galaxyInput();
  input.rings.rings.clear();
  EXPECT_NE(messageOf(input), "");
}
} // namespace galaxy
