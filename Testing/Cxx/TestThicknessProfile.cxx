#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/ThicknessFixtures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace galaxy
{
namespace
{
/// A file of the given text in a folder of this test's own.
std::string written(const std::string& name, const std::string& text)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / "thickness_profile";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
  return (folder / name).string();
}

/// The thickness of a component whose .galaxy file stands in that folder.
ThicknessDescription thicknessOf(const std::string& keys)
{
  const std::string file = written("g.galaxy", "");
  return parseGalaxyDescription("[galaxy]\nra = 1\ndec = 2\ndistance = 3\n[[component]]\n"
                                "name = \"gas\"\nprofile = \"Exponential\"\n"
                                "[component.thickness]\n" +
      keys,
    file)
    .components[0]
    .thickness;
}

} // namespace

TEST(ThicknessProfile, TaperedDiscTapers)
{
  const TiltedDisk disk(flatDisk(20), m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Tapered;
  thickness.children = 20;
  thickness.scaleLength = 4;
  thickness.scaleHeight = 0.3;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).meanChildren(8, 0.1), 20 * std::exp(-2), 1e-12);
  EXPECT_EQ(ThicknessProfile(thickness, disk).scaleHeight(8), 0.3);
  thickness.taperThickness = true;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(8), 0.3 * std::exp(-2), 1e-12);
}

TEST(ThicknessProfile, TaperedChildrenAreSeenToTaperUnasked)
{
  const TiltedDisk disk(flatDisk(20), m83Distance);
  const ThicknessDescription tapered = thicknessOf("model = \"Tapered\"\nscale_length = 4");
  EXPECT_NEAR(ThicknessProfile(tapered, disk).meanChildren(0, 1), 15, 1e-12);
  EXPECT_NEAR(ThicknessProfile(tapered, disk).meanChildren(8, 1), 15 * std::exp(-2), 1e-12);
  EXPECT_EQ(thicknessOf("model = \"Flared\"").children, 1);
  EXPECT_EQ(thicknessOf("model = \"Tapered\"\nchildren = 1").children, 1);
}

TEST(ThicknessProfile, LiteralReadingFallsWithTheScaleHeightAndIsAsThick)
{
  const TiltedDisk disk(flatDisk(20), m83Distance);
  ThicknessDescription thickness =
    thicknessOf("model = \"Tapered\"\nreading = \"Literal\"\nlaw = \"Box\"\nchildren = 20\n"
                "scale_length = 4\nscale_height = 0.5\nsigma = 0.2");
  const ThicknessProfile profile(thickness, disk);
  EXPECT_NEAR(profile.meanChildren(1.5, 0.1), 20 * std::exp(-3), 1e-12);
  EXPECT_EQ(profile.scaleHeight(1.5), 0.5);
  EXPECT_EQ(profile.law(), LayerLaw::Box);
  EXPECT_EQ(profile.inPlaneSigma(), 0.2);
}

TEST(ThicknessProfile, TheFlareIsInverseToTheDiscsFastestRotation)
{
  RingTable table;
  table.rings = { ring(0, 0, 1, 30, 0), ring(100, -240, 1, 30, 0), ring(1000, 120, 1, 30, 0) };
  const TiltedDisk disk(table, m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Flared;
  for (const double exponent : { 1.0, 0.5, 0.0 })
  {
    thickness.velocityExponent = exponent;
    for (const double r : { 0.0, 0.01, 1.0, 9.0 })
    {
      EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(r) * fwhmHeight(LayerLaw::Gaussian),
        std::pow(189.0 / 240, exponent) * (0.3 + 0.05 * r), 1e-12);
    }
  }
}

TEST(ThicknessProfile, LocalScalingNeverWidensInward)
{
  RingTable table;
  table.rings = { ring(0, 0, 1, 30, 0), ring(100, 240, 1, 30, 0), ring(200, 120, 1, 30, 0),
    ring(200, 180, 1, 30, 0), ring(300, 90, 1, 30, 0) };
  const TiltedDisk disk(table, m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Flared;
  thickness.velocityScaling = VelocityScaling::Local;
  const ThicknessProfile profile(thickness, disk);
  const auto width = [&](double arcsec) {
    return profile.scaleHeight(arcsec * m83Kpc) * fwhmHeight(LayerLaw::Gaussian);
  };
  // The fastest from each radius outward, by hand.
  const double fastest[][2] = { { 0, 240 }, { 50, 240 }, { 100, 240 }, { 125, 210 }, { 150, 180 },
    { 190, 180 }, { 200, 180 }, { 250, 135 }, { 300, 90 }, { 350, 90 } };
  for (const auto& [arcsec, v] : fastest)
  {
    EXPECT_NEAR(width(arcsec), 189 / v * (0.3 + 0.05 * arcsec * m83Kpc), 1e-9) << arcsec;
  }
  for (double arcsec = 0; arcsec < 400; arcsec += 0.7)
  {
    EXPECT_LE(width(arcsec), width(arcsec + 0.7) * (1 + 1e-12)) << arcsec;
  }
}

TEST(ThicknessProfile, WithoutARotationThereIsNothingToScaleBy)
{
  const std::string component = "[[component]]\nname = \"gas\"\nprofile = \"Exponential\"\n"
                                "[component.thickness]\nmodel = \"Flared\"\n";
  const std::string galaxy = "[galaxy]\nra = 1\ndec = 2\ndistance = 3\ninclination = 40\n";
  const auto widthOf = [](const std::string& text) {
    const GalaxyDescription read = parseGalaxyDescription(text, "g.galaxy");
    const TiltedDisk disk(read.rings.empty() ? readRings(read) : m83Rings(), read.distance);
    return ThicknessProfile(read.components[0].thickness, disk).scaleHeight(2) *
      fwhmHeight(LayerLaw::Gaussian);
  };
  EXPECT_NEAR(widthOf(galaxy + component), 0.4, 1e-12);
  EXPECT_NEAR(widthOf(component + galaxy), 0.4, 1e-12);
  EXPECT_NEAR(widthOf(galaxy + "rotation_velocity = 100\n" + component), 1.89 * 0.4, 1e-12);
  EXPECT_NEAR(widthOf("[galaxy]\nra = 1\ndec = 2\ndistance = 3\nrings = \"r\"\n" + component),
    0.945 * 0.4, 1e-12);
}

TEST(ThicknessProfile, FlaredWidthIsCappedWhereNothingRotates)
{
  RingTable table;
  table.rings = { ring(100, 0, 1, 30, 0) };
  const TiltedDisk disk(table, m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Flared;
  thickness.fwhmCentre = 0;
  for (const double r : { 0.0, 3.0, 500.0 })
  {
    EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(r) * 2.3548, 4, 1e-4);
  }
}

TEST(ThicknessProfile, HydrostaticLimits)
{
  const TiltedDisk disk(flatDisk(60), m83Distance); // 200 km/s
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Hydrostatic;
  thickness.gasDispersion = 10;
  thickness.stellarSurfaceDensity = 0;
  thickness.gasSurfaceDensity = 0;
  // Halo alone: sigma_z = sigma_g R / v.
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(20), 1.0, 1e-4);
  // Own gravity alone: sigma_z = sigma_g^2 sqrt(2 pi)/(4 pi G Sigma).
  thickness.gasSurfaceDensity = 1e4;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(50) * 1000,
    100 * std::sqrt(2 * pi) / (4 * pi * 4.30091e-3 * 1e4), 1e-3);
  // Stars alone: FWHM = 1.665 sigma_g sqrt(z0 / (pi G Sigma)).
  thickness.gasSurfaceDensity = 0;
  thickness.stellarSurfaceDensity = 1e6;
  thickness.scaleLength = 1e9;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(50) * 2.3548,
    1.665 * 10 * std::sqrt(0.34 / 1000 / (pi * 4.30091e-3 * 1e6)), 1e-5);
  // The values of 10 km/s in a halo of 189 km/s at 5, 10, 20, 50 kpc: 0.62, 1.25, 2.49, 6.2 kpc.
  RingTable table;
  table.rings = { ring(0, 189, 1, 0, 0), ring(3000, 189, 1, 0, 0) };
  const TiltedDisk flat(table, m83Distance);
  thickness.stellarSurfaceDensity = 0;
  const ThicknessProfile halo(thickness, flat);
  EXPECT_NEAR(halo.scaleHeight(5) * 2.3548, 0.62, 0.006);
  EXPECT_NEAR(halo.scaleHeight(10) * 2.3548, 1.25, 0.006);
  EXPECT_NEAR(halo.scaleHeight(20) * 2.3548, 2.49, 0.006);
  EXPECT_NEAR(halo.scaleHeight(50) * 2.3548, 6.23, 0.01);
}

TEST(ThicknessProfile, RingsBringTheirOwnHeightAndLaw)
{
  RingTable table = flatDisk(10);
  table.rings = { ring(0, 200, 10, 0, 0), ring(600, 200, 30, 0, 0) };
  table.layerLaw = LayerLaw::Exponential;
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Rings;
  const TiltedDisk disk(table, m83Distance);
  const ThicknessProfile profile(thickness, disk);
  EXPECT_EQ(profile.law(), LayerLaw::Exponential);
  EXPECT_NEAR(profile.scaleHeight(300 * m83Kpc), 20 * m83Kpc, 1e-12);
}

TEST(ThicknessProfile, MeasuredWidthsReplaceTheFormula)
{
  written("widths.csv", "# M83's gas\nradius, fwhm\n2, 0.5 # inner\n\n6,0.9\n10, 0.7\n");
  const ThicknessDescription thickness =
    thicknessOf("model = \"Flared\"\nprofile_table = \"widths.csv\"\nfwhm_maximum = 0.1");
  const TiltedDisk disk(m83Rings(), m83Distance);
  const ThicknessProfile profile(thickness, disk);
  const double widths[][2] = { { 0, 0.5 }, { 2, 0.5 }, { 3, 0.6 }, { 6, 0.9 }, { 8, 0.8 },
    { 10, 0.7 }, { 99, 0.7 } };
  for (const auto& [r, fwhm] : widths)
  {
    EXPECT_NEAR(profile.scaleHeight(r) * fwhmHeight(LayerLaw::Gaussian), fwhm, 1e-12) << r;
  }
  written("one.txt", "5 0.4");
  EXPECT_EQ(thicknessOf("model = \"Flared\"\nprofile_table = \"one.txt\"").profileTable.size(), 1u);
  const std::string message =
    errorOf([] { thicknessOf("profile_table = \"one.txt\"\nmodel = \"Tapered\""); });
  EXPECT_NE(message.find("profile_table: needs model = \"Flared\""), std::string::npos) << message;
}

TEST(ThicknessProfile, InheritedLightIsRefusedWherePixelsShareTheirFlux)
{
  const auto read = [](const std::string& keys) {
    parseGalaxyDescription("[galaxy]\nra = 1\ndec = 2\ndistance = 3\n[image.a]\nfile = \"a\"\n"
                           "[[component]]\nname = \"stars\"\n" +
        keys + "[component.thickness]\nchild_light = \"Inherit\"\n",
      "g.galaxy");
  };
  const std::string layers = "layers = [{ image = \"a\" }]\n";
  const std::string message = errorOf([&] { read(layers); });
  EXPECT_NE(message.find("line 11: child_light: "), std::string::npos) << message;
  EXPECT_NO_THROW(read(layers + "normalize_at = \"Seed\"\n"));
  EXPECT_NO_THROW(read(layers + "normalize_at = \"None\"\n"));
  EXPECT_NO_THROW(read("profile = \"Exponential\"\n"));
}

TEST(ThicknessProfile, UnusableWidthsAreRefusedWithTheirLine)
{
  const char* const cases[][3] = { { "a.txt", "r w\n1 2\n3\n", "line 3" },
    { "b.txt", "1 2\n3 x\n", "line 2" }, { "c.txt", "# c\n1 2\n1 3\n", "line 3" },
    { "d.txt", "1 -2\n", "line 1" }, { "e.txt", "1 2\n3 nan\n", "line 2" },
    { "f.txt", "1 2 3\n", "line 1" }, { "g.txt", "radius fwhm\n", "must hold rows" },
    { "h.txt", "r w\nr w\n1 2\n", "line 2" } };
  for (const auto& [name, text, cause] : cases)
  {
    written(name, text);
    const std::string message = errorOf([name = name] {
      thicknessOf("model = \"Flared\"\nprofile_table = \"" + std::string(name) + "\"");
    });
    EXPECT_NE(message.find(name), std::string::npos) << message;
    EXPECT_NE(message.find(cause), std::string::npos) << message;
  }
  const std::string message =
    errorOf([] { thicknessOf("model = \"Flared\"\nprofile_table = \"none.txt\""); });
  EXPECT_NE(message.find("none.txt"), std::string::npos) << message;
}

TEST(ThicknessProfile, WhatIsOutOfRangeIsRefusedByName)
{
  using T = ThicknessDescription;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const struct
  {
    const char* name;
    double T::*member;
    double wrong;
  } cases[] = { { "children", &T::children, -1 }, { "children", &T::children, HUGE_VAL },
    { "sigma", &T::sigma, -1 }, { "compression", &T::compression, 1.1 },
    { "compression", &T::compression, -0.1 }, { "scale_length", &T::scaleLength, 0 },
    { "scale_height", &T::scaleHeight, 0 }, { "fwhm_centre", &T::fwhmCentre, -1 },
    { "fwhm_edge", &T::fwhmEdge, 0 }, { "edge_radius", &T::edgeRadius, 0 },
    { "flare_length", &T::flareLength, 0 }, { "fwhm_maximum", &T::fwhmMaximum, 0 },
    { "reference_velocity", &T::referenceVelocity, 0 },
    { "velocity_exponent", &T::velocityExponent, nan }, { "gas_dispersion", &T::gasDispersion, 0 },
    { "stellar_surface_density", &T::stellarSurfaceDensity, -1 },
    { "gas_surface_density", &T::gasSurfaceDensity, nan } };
  requireInRange(T(), "m.galaxy", "gas");
  for (const auto& [name, member, wrong] : cases)
  {
    for (const double value : { wrong, nan })
    {
      T thickness;
      thickness.*member = value;
      const std::string message = errorOf([&] { requireInRange(thickness, "m.galaxy", "gas"); });
      EXPECT_NE(message.find(name), std::string::npos) << message;
      EXPECT_NE(message.find("gas"), std::string::npos) << message;
    }
  }
  const struct
  {
    const char* name;
    std::function<void(T&)> spoil;
  } choices[] = { { "maximum_children", [](T& t) { t.maximumChildren = 0; } },
    { "model", [](T& t) { t.model = static_cast<ThicknessModel>(5); } },
    { "law", [](T& t) { t.law = LayerLaw::FromFile; } },
    { "velocity_scaling", [](T& t) { t.velocityScaling = static_cast<VelocityScaling>(2); } },
    { "reading", [](T& t) { t.reading = static_cast<TaperReading>(2); } },
    { "child_light", [](T& t) { t.childLight = static_cast<ChildLight>(-1); } } };
  for (const auto& [name, spoil] : choices)
  {
    T thickness;
    spoil(thickness);
    const std::string message = errorOf([&] { requireInRange(thickness, "m.galaxy", "gas"); });
    EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}
} // namespace galaxy
