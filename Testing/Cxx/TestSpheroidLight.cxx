#include "Filters/Model/GalaxyBuilder.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

// Spheroids that take their light from a disk's pixels, and one that has none.
namespace galaxy
{
namespace
{
constexpr double arcsecs = 10;

ComponentDescription bulge(const std::string& name, double fraction)
{
  ComponentDescription component;
  component.name = name;
  component.type = ComponentType::Spheroid;
  component.particles = 20000;
  component.spheroid.sigma = { 1, 1, 1 };
  component.spheroid.lightFrom = "stars";
  component.spheroid.lightFraction = fraction;
  return component;
}

/// A disc of 6 kpc with even light within 5 kpc, on an image with more light beyond its edge.
Galaxy evenDisk()
{
  Galaxy input;
  input.rings = flatDisk(6);
  const auto light = [](double x, double y) {
    const double r = std::hypot(x, y);
    return r < 5 ? 0.5 : r > 6.5 ? 1 : 0;
  };
  input.images = { skyPicture(60, light, arcsecs) };
  input.description.file = "m.galaxy";
  input.description.centre = m83Centre;
  input.description.distance = m83Distance;
  input.description.images = { pictureDescription("light", arcsecs) };
  ComponentDescription stars;
  stars.name = "stars";
  stars.particles = 20000;
  stars.layers.resize(1);
  stars.layers[0].image = "light";
  stars.layers[0].clips = true;
  input.description.components = { stars };
  return input;
}

BuildReport reportOf(const Galaxy& input)
{
  BuildReport report;
  buildGalaxy(input, {}, &report);
  return report;
}
} // namespace

TEST(SpheroidLight, FractionsAreOfTheWholeLightOnTheDisk)
{
  Galaxy input = evenDisk();
  const double onDisk = reportOf(input).components[0].light;
  EXPECT_NEAR(onDisk / (0.5 * pi * 25), 1, 0.02); // whole pixels at the edge
  input.description.components.push_back(bulge("inner", 0.02));
  input.description.components.push_back(bulge("outer", 0.03));
  const BuildReport report = reportOf(input);
  EXPECT_NEAR(report.components[1].light / (0.02 * onDisk), 1, 1e-3);
  EXPECT_NEAR(report.components[2].light / (0.03 * onDisk), 1, 1e-3);
  const double sum =
    report.components[0].light + report.components[1].light + report.components[2].light;
  EXPECT_NEAR(sum / onDisk, 1, 1e-4) << "taken, not made";
  // Their order does not matter.
  std::swap(input.description.components[1], input.description.components[2]);
  const BuildReport swapped = reportOf(input);
  EXPECT_NEAR(swapped.components[1].light / report.components[2].light, 1, 1e-3);
  EXPECT_NEAR(swapped.components[2].light / report.components[1].light, 1, 1e-3);
}

TEST(SpheroidLight, DarkHalosAreDarkUnlessAskedToShine)
{
  const std::string text = "[galaxy]\nra = 204\ndec = -29\ndistance = 4.9\n[[component]]\n"
                           "name = \"halo\"\ntype = \"Spheroid\"\nparticles = 1000\n"
                           "[component.spheroid]\npreset = \"DarkHalo\"\n";
  const auto lightOf = [&](const std::string& keys) {
    Galaxy input;
    input.description = parseGalaxyDescription(text + keys, "m.galaxy");
    input.rings = readRings(input.description);
    return reportOf(input).components[0].light;
  };
  EXPECT_EQ(lightOf(""), 0);
  EXPECT_NEAR(lightOf("luminosity = 3\n"), 3, 1e-4);
  EXPECT_GT(lightOf("central_brightness = 0.01\n"), 0);
}

TEST(SpheroidLight, WhatCannotBeTakenIsSaid)
{
  // In the middle pixel a bulge of sigma 0.7 kpc wants 4 times what is there. Farther out it may
  // take twice as much as it would have to, with g = 2 * 0.15 * 25/2/0.49 exp(-R^2/2/0.49) of the
  // disc's 0.5 min(1, g); even so it lacks a fifth.
  Galaxy input = evenDisk();
  const double onDisk = reportOf(input).components[0].light;
  input.description.components.push_back(bulge("bulge", 0.15));
  input.description.components[1].spheroid.sigma = { 0.7, 0.7, 0.7 };
  const ComponentReport some = reportOf(input).components[1];
  EXPECT_NEAR(some.asked / (0.15 * onDisk), 1, 1e-5);
  const double peak = 2 * 0.15 * 25 / 2 / 0.49; // of the disc's brightness, so that it is 1 at r2
  const double r2 = 2 * 0.49 * std::log(peak);
  const double expected = (r2 / 25 + 2 * 0.15 / peak) * onDisk;
  EXPECT_NEAR(some.light / expected, 1, 0.05);
  EXPECT_LT(some.light, 0.9 * some.asked);
  // Of one of 1 kpc the middle lacks less than the rest can give.
  input.description.components[1].spheroid.sigma = { 1, 1, 1 };
  const ComponentReport whole = reportOf(input).components[1];
  EXPECT_NEAR(whole.light / whole.asked, 1, 1e-3);
  input.description.components[1].spheroid.sigma = { 2, 2, 2 };
  const ComponentReport all = reportOf(input).components[1];
  EXPECT_NEAR(all.light / all.asked, 1, 0.06) << "but for what lies beyond the disc's light";
}
} // namespace galaxy
