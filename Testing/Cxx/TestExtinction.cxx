#include "Filters/Model/Deredden.h"
#include "Readers/Formats/Extinction.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>

namespace galaxy
{
namespace
{
/// A file of one absorber with these lines more.
std::string absorber(const std::string& lines)
{
  return "[galaxy]\nra = 204\ndec = -29\ndistance = 4.9\n[image.dust]\nfile = \"d.fits\"\n"
         "[[component]]\nname = \"dust\"\nrole = \"Absorbs\"\nlayers = [ { image = \"dust\" } ]\n" +
    lines;
}

std::string emitter(const std::string& lines)
{
  return absorber("[[component]]\nname = \"stars\"\nlayers = [ { image = \"dust\" } ]\n") + lines;
}

Color absorptionOf(const std::string& lines)
{
  return parseGalaxyDescription(absorber(lines), "m.galaxy").components[0].absorption;
}

std::string messageOf(const std::string& text)
{
  return errorOf([&] { parseGalaxyDescription(text, "m.galaxy"); });
}

void expectNear(const Color& color, const Color& expected, double tolerance)
{
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(color[c], expected[c], tolerance) << c;
  }
}
} // namespace

TEST(Extinction, ReproducesTheCurvesAtTheBandsOfImages)
{
  struct Row
  {
    double wavelength, ccm31, ccm5, calzetti;
  };
  for (const Row& row : { Row{ 0.153, 2.63, 1.49, 2.52 }, Row{ 0.227, 2.96, 1.88, 2.04 },
         Row{ 0.438, 1.33, 1.21, 1.26 }, Row{ 0.545, 1.01, 1.01, 1.01 },
         Row{ 0.656, 0.818, 0.853, 0.822 }, Row{ 0.641, 0.841, 0.873, 0.846 },
         Row{ 0.798, 0.600, 0.670, 0.636 } })
  {
    const double tolerance = row.ccm31 > 0.9 ? 0.0055 : 0.00055;
    const double w = row.wavelength;
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::CCM89, w, 3.1), row.ccm31, tolerance) << w;
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::CCM89, w, 5), row.ccm5, tolerance) << w;
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::Calzetti, w, 4.05), row.calzetti, tolerance) << w;
  }
}

// A(x)/A(V) at wavenumbers (1/um) in every branch, which other programs agree on, for R_V = 3.1
// and 2.
TEST(Extinction, EveryBranchOfCCM89)
{
  struct Row
  {
    double x, at31, at2;
  };
  for (const Row& row :
    { Row{ 10, 5.23835484, 9.407 }, Row{ 9, 4.13406452, 7.3065 }, Row{ 7, 2.77962453, 4.60825807 },
      Row{ 6, 2.52195399, 4.01559036 }, Row{ 5, 2.84252644, 4.43845534 },
      Row{ 4.6, 3.18598916, 4.93952892 }, Row{ 4, 2.31531711, 3.39275574 },
      Row{ 3, 1.64254927, 2.068771 }, Row{ 2.78, 1.56880904, 1.9075018 },
      Row{ 2.27, 1.32257836, 1.49999733 }, Row{ 1.82, 1, 1 }, Row{ 1.43, 0.75125994, 0.68650255 },
      Row{ 1.11, 0.4780346, 0.36750326 }, Row{ 0.8, 0.28206957, 0.21678862 },
      Row{ 0.63, 0.19200814, 0.14757062 }, Row{ 0.46, 0.11572348, 0.08894094 } })
  {
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::CCM89, 1 / row.x, 3.1), row.at31, 1e-7) << row.x;
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::CCM89, 1 / row.x, 2), row.at2, 1e-7) << row.x;
  }
}

TEST(Extinction, BranchesMeet)
{
  for (const double x : { 1.1, 3.3, 5.9, 8.0 })
  {
    const double before = extinctionCurve(ExtinctionLaw::CCM89, 1 / (x - 1e-9), 3.1);
    EXPECT_NEAR(extinctionCurve(ExtinctionLaw::CCM89, 1 / (x + 1e-9), 3.1) / before, 1, 0.005) << x;
  }
  // The two parts of Calzetti's published formula differ by 0.7 % where they meet.
  const double blue = extinctionCurve(ExtinctionLaw::Calzetti, 0.63 - 1e-9, 4.05);
  EXPECT_NEAR(extinctionCurve(ExtinctionLaw::Calzetti, 0.63, 4.05) / blue, 1, 0.0075);
}

TEST(Extinction, KeysSetTheAbsorption)
{
  expectNear(absorptionOf(""), { 0.834, 1, 1.319 }, 0);
  expectNear(absorptionOf("extinction = \"CCM89\"\n"), { 0.834, 1, 1.319 }, 0.0005);
  expectNear(absorptionOf("extinction = \"ccm89\"\nbands = [0.612, \"V\", 0.465]\n"),
    { 0.879, 1, 1.223 }, 0.0005);
  expectNear(absorptionOf("extinction = \"CCM89\"\nr_v = 5\nbands = [\"I\", \"V\", \"FUV\"]\n"),
    { 0.670 / 1.0068, 1, 1.491 / 1.0068 }, 0.001);
  expectNear(
    absorptionOf("extinction = \"Calzetti\"\n"), { 0.846 / 1.0093, 1, 1.2548 / 1.0093 }, 0.001);
  expectNear(absorptionOf("extinction = \"Grey\"\n"), { 1, 1, 1 }, 0);
  expectNear(absorptionOf("absorption = [1, 2, 3]\n"), { 1, 2, 3 }, 0);
}

TEST(Extinction, ContradictionsAndValuesOutOfRangeAreRefused)
{
  const auto expectRefused = [](const std::string& lines, const std::string& key,
                               const std::string& word) {
    const std::string message = messageOf(absorber(lines));
    EXPECT_NE(message.find(": " + key + ": "), std::string::npos) << lines << message;
    EXPECT_NE(message.find(word), std::string::npos) << lines << message;
  };
  expectRefused("extinction = \"CCM89\"\nabsorption = [1, 1, 1]\n", "absorption", "extinction");
  expectRefused("extinction = \"SMC\"\n", "extinction", "CCM89");
  expectRefused("r_v = 4\n", "r_v", "extinction");
  expectRefused("extinction = \"CCM89\"\nr_v = 1.9\n", "r_v", "2 to 6");
  expectRefused("extinction = \"CCM89\"\nbands = [\"R\", \"V\"]\n", "bands", "3 bands");
  expectRefused("extinction = \"CCM89\"\nbands = [\"R\", \"V\", \"X\"]\n", "bands", "Halpha");
  expectRefused("extinction = \"CCM89\"\nbands = [24, 8, 3]\n", "bands", "0.1 to 5 um");
  expectRefused("extinction = \"Calzetti\"\nbands = [\"3.6um\", \"V\", \"B\"]\n", "bands", "2.2");
  expectRefused(
    "extinction = \"Calzetti\"\nr_v = 2\nbands = [\"K\", \"V\", \"B\"]\n", "r_v", "negative");
}

TEST(Extinction, DustReddens)
{
  for (const ExtinctionLaw law : { ExtinctionLaw::CCM89, ExtinctionLaw::Calzetti })
  {
    const Color A = absorptionInBands(law, { 0.641, 0.545, 0.438 }, usualTotalToSelective(law));
    double screen = 1, mixed = 1;
    for (double tau = 0.1; tau < 20; tau *= 1.3)
    {
      const double behind = std::exp(-tau * A[2]) / std::exp(-tau * A[0]);
      const double within = escapeFraction(tau * A[2]) / escapeFraction(tau * A[0]);
      EXPECT_LT(behind, screen);
      EXPECT_LT(within, mixed);
      screen = behind;
      mixed = within;
    }
  }
}

TEST(Deredden, UndoesDustInTheMidst)
{
  EXPECT_NEAR(dereddening(DustGeometry::Sheet, 1.0), 1.46, 0.005);
  EXPECT_NEAR(dereddening(DustGeometry::Mixed, 1.0), 1.58, 0.005);
  for (const DustGeometry geometry : { DustGeometry::Sheet, DustGeometry::Mixed })
  {
    EXPECT_EQ(dereddening(geometry, 0.0), 1);
    EXPECT_NEAR(dereddening(geometry, 1e-9), 1 + 0.5e-9, 1e-15);
  }
  for (const double tau : { 1e-4, 0.3, 2.0, 30.0 })
  {
    // Half the light is before the sheet; of mixed light, an integral over the depth leaves.
    EXPECT_NEAR(dereddening(DustGeometry::Sheet, tau) * (0.5 + 0.5 * std::exp(-tau)), 1, 1e-14);
    double leaves = 0;
    for (int k = 0; k < 20000; ++k)
    {
      leaves += std::exp(-tau * (k + 0.5) / 20000) / 20000;
    }
    EXPECT_NEAR(dereddening(DustGeometry::Mixed, tau) * leaves, 1, 1e-6);
  }
  EXPECT_NEAR(dereddening(DustGeometry::Sheet, 1e4), 2, 1e-12);
  const Color factors = dereddening(DustGeometry::Mixed, 1.0, { 0.5, 1, 2 });
  EXPECT_EQ(factors[1], dereddening(DustGeometry::Mixed, 1.0));
  EXPECT_EQ(factors[2], dereddening(DustGeometry::Mixed, 2.0));
}

TEST(Deredden, NamesAnAbsorbingComponent)
{
  const GalaxyDescription galaxy =
    parseGalaxyDescription(emitter("deredden = \"dust\"\ndust_geometry = \"Mixed\"\n"), "m.galaxy");
  EXPECT_EQ(galaxy.components[1].deredden, "dust");
  EXPECT_EQ(galaxy.components[1].dustGeometry, DustGeometry::Mixed);
  EXPECT_NE(
    messageOf(emitter("deredden = \"dusk\"\n")).find("did you mean `dust`"), std::string::npos);
  EXPECT_NE(messageOf(emitter("deredden = \"stars\"\n")).find("absorbs"), std::string::npos);
  EXPECT_NE(
    messageOf(emitter("dust_geometry = \"Mixed\"\n")).find("needs deredden"), std::string::npos);
  EXPECT_NE(messageOf(absorber("deredden = \"dust\"\n")).find("Emits"), std::string::npos);
}

TEST(Deredden, NeedsImagesOfTheLightAndOfTheDust)
{
  const auto expectRefused = [](const std::string& text) {
    const std::string message = messageOf(text);
    EXPECT_NE(message.find(": deredden: "), std::string::npos) << text << message;
    EXPECT_NE(message.find("layers"), std::string::npos) << message;
  };
  expectRefused(emitter("deredden = \"dust\"\nprofile = \"Exponential\"\n"));
  expectRefused(emitter("deredden = \"dust\"\ntype = \"Spheroid\"\n"));
  const std::string stars = "[[component]]\nname = \"stars\"\nlayers = [ { image = \"dust\" } ]\n"
                            "deredden = \"dust\"\n";
  EXPECT_EQ(messageOf(absorber(stars)), "");
  expectRefused(absorber("profile = \"Exponential\"\n" + stars));
  expectRefused(absorber("type = \"Spheroid\"\n" + stars));
}

TEST(Deredden, SectionsThatWouldBeIgnoredAreRefused)
{
  EXPECT_EQ(messageOf(absorber("[component.dust]\n")), "");
  EXPECT_EQ(messageOf(absorber("[component.thickness]\n")), "");
  const std::string both = messageOf(absorber("[component.dust]\n[component.thickness]\n"));
  EXPECT_NE(both.find(": thickness: contradicts [component.dust]"), std::string::npos) << both;
  const std::string round = messageOf(absorber("type = \"Spheroid\"\n[component.dust]\n"));
  EXPECT_NE(round.find(": dust: needs type"), std::string::npos) << round;
}
} // namespace galaxy
