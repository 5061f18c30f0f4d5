#include "Filters/Model/OpticalDepth.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace galaxy
{
namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 3.14159265358979323846;

ComponentDescription dust(DepthCalibration calibration)
{
  ComponentDescription component;
  component.name = "dust";
  component.role = ComponentRole::Absorbs;
  component.opticalDepth = 0.5;
  component.depth.calibration = calibration;
  return component;
}

/// An image of 2 arcsec pixels and a beam of 10 by 8 arcsec in this unit.
DepthImage imageIn(const std::string& unit)
{
  Image image;
  image.file = "i.fits";
  image.width = image.height = 4;
  image.values.assign(16, 1);
  image.unit = unit;
  ImageDescription description;
  description.suppliesCoordinates = true;
  description.coordinates.centre = { 204, -30 };
  description.coordinates.pixelScale = 2;
  description.beam = std::sqrt(80.0);
  return { "picture", unit,
    isColumnDensity(unit) ? Brightness() : brightnessOf(image, description) };
}

std::string messageOf(
  const ComponentDescription& component, const DepthImage* image, const DepthImage* companion)
{
  return errorOf([&] { const OpticalDepth depth(component, "m.galaxy", image, companion); });
}

std::string parseMessageOf(const std::string& lines)
{
  return errorOf([&] {
    parseGalaxyDescription(
      "[galaxy]\nra = 204\ndec = -29\ndistance = 4.9\n[image.dust]\nfile = \"d.fits\"\n"
      "[image.stars]\nfile = \"s.fits\"\n[[component]]\nname = \"dust\"\n"
      "layers = [ { image = \"dust\" } ]\n" +
        lines,
      "m.galaxy");
  });
}
} // namespace

TEST(OpticalDepth, GivenIsAlongTheLineOfSightAndFaceOnAcrossThePlane)
{
  const OpticalDepth given(dust(DepthCalibration::Given), "m.galaxy");
  EXPECT_EQ(given(0.8), 0.4);
  EXPECT_EQ(given(0.8, 7, 0.5), 0.4) << "neither a companion nor the inclination counts";
  const OpticalDepth faceOn(dust(DepthCalibration::FaceOn), "m.galaxy");
  EXPECT_EQ(faceOn(0.8), 0.4);
  // A thin disc's 1/cos i, to the square of its axis ratio of 0.1; never more than 10.
  EXPECT_NEAR(faceOn(0.8, 0, 0.5), 0.4 / std::sqrt(0.25 + 0.01 * 0.75), 1e-12);
  EXPECT_NEAR(faceOn(0.8, 0, 0.5) / 0.8, 1, 0.02);
  EXPECT_NEAR(faceOn(0.8, 0, 0), 4, 1e-12);
  for (double cosine = 0; cosine < 0.99; cosine += 0.01)
  {
    EXPECT_GT(faceOn(0.8, 0, cosine), faceOn(0.8, 0, cosine + 0.01));
  }
}

TEST(OpticalDepth, HydrocarbonsHaveTheReferenceDepthWithinTheRadius)
{
  ComponentDescription component = dust(DepthCalibration::PAH8um);
  component.depth.referenceDepth = 0.9;
  component.depth.referenceRadius = 3;
  component.depth.stellarImage = "stars";
  EXPECT_EQ(OpticalDepth::companionOf(component), "stars");
  const DepthImage at8um = imageIn("MJy/sr"), at3um = imageIn("MJy/sr");
  OpticalDepth depth(component, "m.galaxy", &at8um, &at3um);
  EXPECT_TRUE(depth.needsReference());

  // Rows of radius, 8 um, 3.6 um; one is all starlight, one blank, one outside.
  const std::vector<double> r = { 0, 1, 2, 3, 2.5, 4 };
  const std::vector<double> i8 = { 40, 20, 10, 2, nan, 500 };
  const std::vector<double> i3 = { 50, 20, nan, 10, 1, 0 };
  depth.setReference(meanWithin(
    r.size(), component.depth.referenceRadius, [&](std::size_t k) { return r[k]; },
    [&](std::size_t k) { return depth.signal(i8[k], i3[k]); }));
  const double mean = (40 - 0.232 * 50 + 20 - 0.232 * 20 + 10 + 0) / 4;
  EXPECT_NEAR(depth(40, 50), 0.9 * (40 - 0.232 * 50) / mean, 1e-12);
  EXPECT_NEAR(depth(500, 0), 0.9 * 500 / mean, 1e-9);
  EXPECT_EQ(depth(2, 10), 0) << "never negative";
  EXPECT_NEAR(depth(10, nan), 0.9 * 10 / mean, 1e-12);
  EXPECT_TRUE(std::isnan(depth(nan, 1)));
  double sum = 0;
  for (const std::size_t k : { 0, 1, 2, 3 })
  {
    sum += depth(i8[k], i3[k]);
  }
  EXPECT_NEAR(sum / 4, 0.9, 1e-12);
}

TEST(OpticalDepth, StarlightIsTakenOffInOneUnit)
{
  ComponentDescription component = dust(DepthCalibration::PAH8um);
  component.depth.stellarImage = "stars";
  const DepthImage perSteradian = imageIn("MJy/sr"), perPixel = imageIn("mJy/pixel");
  OpticalDepth depth(component, "m.galaxy", &perSteradian, &perPixel);
  // 1 mJy in 4 arcsec^2, in MJy/sr.
  const double brightness = 1e-9 / (4 / std::pow(206264.80624709636, 2));
  EXPECT_NEAR(depth.signal(0.232 * brightness, 1) / depth.signal(0.232 * brightness), 0, 1e-6);

  const DepthImage counts = imageIn("counts");
  EXPECT_NE(
    messageOf(component, &counts, &perSteradian).find("'picture' in 'counts'"), std::string::npos);
  EXPECT_NE(messageOf(component, &perSteradian, nullptr).find("'stars'"), std::string::npos);
  component.depth.stellarImage = "";
  EXPECT_EQ(messageOf(component, &counts, nullptr), "") << "alone, its unit does not matter";
  OpticalDepth dark(component, "m.galaxy", &counts);
  EXPECT_THROW(dark.setReference(0), Error);
  EXPECT_THROW(dark.setReference(nan), Error);
}

TEST(OpticalDepth, GasFollowsGueverAndOezel)
{
  ComponentDescription component = dust(DepthCalibration::Gas);
  const DepthImage atoms = imageIn("atoms/cm^2");
  const OpticalDepth ofAtoms(component, "m.galaxy", &atoms);
  // N_H = 2.21e21 A_V, tau = A_V ln 10 / 2.5.
  EXPECT_NEAR(ofAtoms(2.21e21), std::log(10) / 2.5, 0.001);
  // 1 Msun/pc^2 is 1.249e20 atoms/cm^2.
  EXPECT_NEAR(ofAtoms(1.249e20), 0.052, 0.0002);

  const DepthImage perBeam = imageIn("Jy/beam km/s");
  const OpticalDepth ofBeam(component, "m.galaxy", &perBeam);
  EXPECT_NEAR(ofBeam(1) / (1.104e24 / 80 / 2.40e21), 1, 1e-6);
  const DepthImage kelvin = imageIn("K km/s");
  const OpticalDepth ofKelvin(component, "m.galaxy", &kelvin);
  EXPECT_NEAR(ofKelvin(100) / (1.823e20 / 2.40e21), 1, 1e-9);
  component.depth.dustToGas = 2.5;
  EXPECT_NEAR(OpticalDepth(component, "m.galaxy", &kelvin)(100) / ofKelvin(100), 2.5, 1e-9);

  const DepthImage light = imageIn("MJy/sr");
  EXPECT_NE(messageOf(component, &light, nullptr).find("MJy/sr"), std::string::npos);
  EXPECT_NE(messageOf(component, nullptr, nullptr).find("image"), std::string::npos);
}

TEST(OpticalDepth, MoleculesCountTwoAtoms)
{
  ComponentDescription component = dust(DepthCalibration::Gas);
  component.depth.molecularImage = "co";
  const DepthImage atoms = imageIn("cm-2"), co = imageIn("K km/s"), molecules = imageIn("cm-2");
  const OpticalDepth fromCo(component, "m.galaxy", &atoms, &co);
  EXPECT_NEAR(fromCo(1e21, 10) / ((1e21 + 2 * 2e20 * 10) / 2.40e21), 1, 1e-12);
  EXPECT_NEAR(fromCo(1e21, nan) / (1e21 / 2.40e21), 1, 1e-12);
  const OpticalDepth fromH2(component, "m.galaxy", &atoms, &molecules);
  EXPECT_NEAR(fromH2(1e21, 3e20) / (1.6e21 / 2.40e21), 1, 1e-12);
  const DepthImage plain = imageIn("K");
  EXPECT_NE(messageOf(component, &atoms, &plain).find("K km/s"), std::string::npos);
}

TEST(OpticalDepth, DustAt250um)
{
  // h nu/(k T) = 14387.77 um K / (250 um 20 K).
  EXPECT_NEAR(blackBodyAt250um(20) / 1.516e11, 1, 0.002);
  EXPECT_NEAR(blackBodyAt250um(1e6) / (2 * 1.380649e-23 * 1e6 / (250e-6 * 250e-6) / 1e-26), 1, 1e-4)
    << "Rayleigh and Jeans";
  ComponentDescription component = dust(DepthCalibration::Dust250um);
  const DepthImage image = imageIn("MJy/sr");
  const OpticalDepth depth(component, "m.galaxy", &image);
  EXPECT_NEAR(depth(10) / (6500 * 1e7 / blackBodyAt250um(20)), 1, 1e-9);
  component.depth.dustTemperature = 25;
  EXPECT_NEAR(depth(10) / OpticalDepth(component, "m.galaxy", &image)(10), 1.86, 0.01);
  const DepthImage perBeam = imageIn("Jy/beam");
  const double beam = pi / (4 * std::log(2.0)) * 80 / std::pow(206264.80624709636, 2);
  EXPECT_NEAR(
    OpticalDepth(component, "m.galaxy", &perBeam)(1) / (6500 / beam / blackBodyAt250um(25)), 1,
    1e-9);
  const DepthImage kelvin = imageIn("K");
  EXPECT_NE(messageOf(component, &kelvin, nullptr).find("'K'"), std::string::npos);
}

TEST(OpticalDepth, KnowsColumnDensitiesHoweverWritten)
{
  for (const char* unit : { "cm-2", "cm^-2", "cm**-2", "1/cm2", "atoms/cm^2", "atoms cm-2", "H/cm2",
         "molecules/cm**2", "cm^{-2}" })
  {
    EXPECT_TRUE(isColumnDensity(unit)) << unit;
  }
  for (const char* unit : { "", "cm", "Jy/beam", "K km/s", "m-2", "cm-3", "10^20 cm-2" })
  {
    EXPECT_FALSE(isColumnDensity(unit)) << unit;
  }
}

TEST(OpticalDepth, KeysAreCheckedAgainstTheCalibration)
{
  const std::string absorbs = "role = \"Absorbs\"\n";
  EXPECT_EQ(parseMessageOf(absorbs +
              "calibration = \"PAH8um\"\nreference_optical_depth = 2\nreference_radius = 5\n"
              "stellar_image = \"stars\"\n"),
    "");
  EXPECT_EQ(parseMessageOf(absorbs +
              "calibration = \"Gas\"\nmolecular_image = \"stars\"\nco_to_h2 = 3e20\n"
              "dust_to_gas = 0.5\n"),
    "");
  const auto expectRefused = [](const std::string& lines, const std::string& key,
                               const std::string& word) {
    const std::string message = parseMessageOf(lines);
    EXPECT_NE(message.find(": " + key + ": "), std::string::npos) << lines << message;
    EXPECT_NE(message.find(word), std::string::npos) << lines << message;
  };
  expectRefused("calibration = \"Gas\"\n", "calibration", "Absorbs");
  expectRefused(absorbs + "stellar_image = \"stars\"\n", "stellar_image", "PAH8um");
  expectRefused(absorbs + "calibration = \"PAH8um\"\nstellar_image = \"star\"\n", "stellar_image",
    "did you mean `stars`");
  expectRefused(
    absorbs + "calibration = \"PAH8um\"\noptical_depth = 1\n", "optical_depth", "calibration");
  expectRefused(absorbs + "calibration = \"PAH8um\"\nreference_radius = 0\n", "reference_radius",
    "greater than 0");
  expectRefused(absorbs + "calibration = \"PAH8um\"\nreference_optical_depth = -1\n",
    "reference_optical_depth", "at least 0");
  expectRefused(absorbs + "calibration = \"Gas\"\nco_to_h2 = 1e20\n", "co_to_h2", "molecular");
  expectRefused(absorbs + "calibration = \"Gas\"\ndust_to_gas = -1\n", "dust_to_gas", "at least");
  expectRefused(absorbs + "calibration = \"Dust250um\"\ndust_temperature = 1\n", "dust_temperature",
    "2.8 to 1000");
  expectRefused(absorbs + "v_over_250um = 5000\n", "v_over_250um", "Dust250um");
  expectRefused(
    absorbs + "calibration = \"Gas\"\nprofile = \"Exponential\"\n", "calibration", "one layer");
  expectRefused(absorbs + "calibration = \"FaceOn\"\ntype = \"Spheroid\"\n", "calibration", "Disk");
}

TEST(OpticalDepth, KeysOfAClippedIntensityAreRefusedWhereTheImageTellsTheDepth)
{
  const auto messageOfLayer = [](const std::string& calibration, const std::string& keys) {
    return errorOf([&] {
      parseGalaxyDescription("[galaxy]\nra = 204\ndec = -29\ndistance = 4.9\n[image.dust]\n"
                             "file = \"d.fits\"\n[[component]]\nname = \"dust\"\nrole = "
                             "\"Absorbs\"\ncalibration = \"" +
          calibration + "\"\nlayers = [ { image = \"dust\", " + keys + " } ]\n",
        "m.galaxy");
    });
  };
  for (const char* calibration : { "PAH8um", "Gas", "Dust250um" })
  {
    for (const char* keys : { "clip = [0, 1]", "clip_percentile = [1, 99]", "stretch = \"Asinh\"" })
    {
      const std::string key = std::string(keys).substr(0, std::string(keys).find(' '));
      const std::string message = messageOfLayer(calibration, keys);
      EXPECT_NE(message.find(": " + key + ": "), std::string::npos) << keys << message;
      EXPECT_NE(message.find(calibration), std::string::npos) << keys << message;
      EXPECT_EQ(messageOfLayer("FaceOn", keys), "");
    }
    EXPECT_EQ(messageOfLayer(calibration, "threshold = 0.1, weight = 2"), "");
  }
}
} // namespace galaxy
