#include "FitsFixtures.h"

#include "Readers/Formats/Beam.h"
#include "Readers/Formats/Brightness.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/Galaxy.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

using galaxy::Brightness;
using galaxy::BrightnessConversion;
using galaxy::BrightnessKind;
using galaxy::Image;
using galaxy::ImageDescription;

namespace
{
const double gaussian = std::acos(-1.0) / (4 * std::log(2.0));

std::string card(const std::string& keyword, const std::string& value)
{
  std::string text = keyword;
  text.resize(8, ' ');
  text += "= " + value;
  text.resize(80, ' ');
  return text;
}

std::string exact(double number)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

/// size x size pixels of `pixel` arcsec, all of one value.
Image field(int size, double pixel, const std::string& unit, double value)
{
  Image image;
  image.file = "field.fits";
  image.width = image.height = size;
  image.values.assign(static_cast<std::size_t>(size) * size, value);
  image.unit = unit;
  const std::string middle = exact(0.5 * (size + 1));
  const std::string step = exact(pixel / 3600);
  image.cards = card("CTYPE1", "'RA---TAN'") + card("CTYPE2", "'DEC--TAN'") +
    card("CRPIX1", middle) + card("CRPIX2", middle) + card("CRVAL1", "30.") +
    card("CRVAL2", "60.") + card("CDELT1", "-" + step) + card("CDELT2", step);
  return image;
}

std::string beamCards(double major, double minor)
{
  return card("BMAJ", exact(major / 3600)) + card("BMIN", exact(minor / 3600));
}
} // namespace

TEST(BrightnessUnit, AsProgramsWriteThem)
{
  struct Known
  {
    const char* text;
    BrightnessKind kind;
    const char* quantity;
    double scale;
    bool isIntegrated;
  };
  constexpr double perSteradian = 2.3504430539097885e-11; // arcsec^2
  for (const Known& known : {
         Known{ "Jy/beam", BrightnessKind::PerBeam, "Jy", 1, false },
         Known{ "JY/BEAM ", BrightnessKind::PerBeam, "Jy", 1, false },
         Known{ "Jy beam-1", BrightnessKind::PerBeam, "Jy", 1, false },
         Known{ "Jy beam^-1 km s^-1", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "Jy/beam*m/s", BrightnessKind::PerBeam, "Jy", 1e-3, true },
         Known{ "Jy/beam.km/s", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "JY/BEAM km/s", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "mJy/beam", BrightnessKind::PerBeam, "Jy", 1e-3, false },
         Known{ "MJY/BEAM", BrightnessKind::PerBeam, "Jy", 1e-3, false },
         Known{ "MJy/sr", BrightnessKind::PerSolidAngle, "Jy", 1e6 * perSteradian, false },
         Known{ "MJY/SR", BrightnessKind::PerSolidAngle, "Jy", 1e6 * perSteradian, false },
         Known{ "uJy/arcsec**2", BrightnessKind::PerSolidAngle, "Jy", 1e-6, false },
         Known{ "Jy/pixel", BrightnessKind::PerPixel, "Jy", 1, false },
         Known{ "mJy", BrightnessKind::PerPixel, "Jy", 1e-3, false },
         Known{ "JY/B*M/S", BrightnessKind::PerBeam, "Jy", 1e-3, true },
         Known{ "JY/BEAM.KM/S", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "JY.KM/S/BEAM", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "Jy km s-1 beam-1", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "JY/B KM/SEC", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "Jy/beam*kms", BrightnessKind::PerBeam, "Jy", 1, true },
         Known{ "kJy/sr", BrightnessKind::PerSolidAngle, "Jy", 1e3 * perSteradian, false },
         Known{ "Jy/arcmin2", BrightnessKind::PerSolidAngle, "Jy", 1 / 3600., false },
         Known{ "mJy km/s/sq.arcsec", BrightnessKind::PerSolidAngle, "Jy", 1e-3, true },
         Known{ "2.5E-3 Jy/beam", BrightnessKind::PerBeam, "Jy", 2.5e-3, false },
         Known{ "K", BrightnessKind::Temperature, "K", 1, false },
         Known{ "mK", BrightnessKind::Temperature, "K", 1e-3, false },
         Known{ "K (Tmb)", BrightnessKind::Temperature, "K", 1, false },
         Known{ "K km/s", BrightnessKind::Temperature, "K", 1, true },
         Known{ "K.m.s**-1", BrightnessKind::Temperature, "K", 1e-3, true },
         Known{ "", BrightnessKind::PerPixel, "", 1, false },
         Known{ "counts", BrightnessKind::PerPixel, "counts", 1, false },
         Known{ "adu", BrightnessKind::PerPixel, "adu", 1, false },
         Known{ "ELECTRONS/S", BrightnessKind::PerPixel, "ELECTRONS/S", 1, false },
         Known{ "10**(-17) erg/s/cm2/arcsec2", BrightnessKind::PerSolidAngle, "erg/s/cm2", 1e-17,
           false },
         Known{ "10**-20 erg/s/cm**2/Angstrom", BrightnessKind::PerPixel, "erg/s/cm2/Angstrom",
           1e-20, false },
         Known{ "10**(-20)*erg/s/cm**2/Angstrom", BrightnessKind::PerPixel, "erg/s/cm2/Angstrom",
           1e-20, false },
         Known{ "ergs/s/cm**2/A", BrightnessKind::PerPixel, "ergs/s/cm2/A", 1, false },
         Known{ "erg/(s cm2 Angstrom arcsec2)", BrightnessKind::PerSolidAngle, "erg/s/cm2/Angstrom",
           1, false },
         Known{
           "1E-17 erg/s/cm^2/Ang/spaxel", BrightnessKind::PerPixel, "erg/s/cm2/Ang", 1e-17, false },
         Known{ "W m-2 sr-1", BrightnessKind::PerSolidAngle, "W/m2", perSteradian, false },
         Known{ "KM/S", BrightnessKind::NotBrightness, "KM/S", 1, false },
         Known{ "cm-2", BrightnessKind::NotBrightness, "/cm2", 1, false },
         Known{ "m/s", BrightnessKind::NotBrightness, "m/s", 1, false },
         Known{ "W.U.", BrightnessKind::NotBrightness, "W U", 1, false },
         Known{ "mag/arcsec^2", BrightnessKind::NotBrightness, "mag", 1, false },
         Known{ "(mJy/beam/V)**2", BrightnessKind::NotBrightness, "Jy/V", 1e-3, false },
       })
  {
    const galaxy::BrightnessUnit unit = galaxy::parseBrightnessUnit(known.text);
    EXPECT_EQ(unit.kind, known.kind) << known.text;
    EXPECT_EQ(unit.quantity, known.quantity) << known.text;
    if (unit.kind != BrightnessKind::NotBrightness)
    {
      EXPECT_NEAR(unit.scale / known.scale, 1, 1e-12) << known.text;
    }
    EXPECT_EQ(unit.isIntegrated, known.isIntegrated) << known.text;
  }
}

// A point of 2 Jy seen through a beam of 30 by 20 arcsec: its peak is 2 Jy/beam.
TEST(Brightness, FluxInABeam)
{
  Image image = field(101, 2, "Jy/beam", 0);
  image.cards += beamCards(30, 20);
  const auto exponent = [](double d, double width) {
    return 4 * std::log(2.0) * d * d / width / width;
  };
  for (int y = 0; y < 101; ++y)
  {
    for (int x = 0; x < 101; ++x)
    {
      image.values[static_cast<std::size_t>(y) * 101 + x] =
        2 * std::exp(-exponent(2 * (x - 50), 30) - exponent(2 * (y - 50), 20));
    }
  }
  const Brightness brightness = galaxy::brightnessOf(image, {});
  double flux = 0;
  for (const double value : image.values)
  {
    flux += value * brightness.toPixel;
  }
  EXPECT_NEAR(flux, 2, 1e-5);
  EXPECT_NEAR(brightness.beamArea, gaussian * 600, 1e-3);
  EXPECT_NEAR(brightness.pixelArea, 4, 1e-5);
  EXPECT_EQ(brightness.surfaceUnit, "Jy/arcsec2");
  EXPECT_TRUE(std::isnan(brightness.toColumnDensity));
}

TEST(Brightness, DoesNotDependOnThePixel)
{
  ImageDescription description;
  description.convert = BrightnessConversion::SurfaceBrightness;
  Image fine = field(11, 1, "counts", 5), coarse = field(11, 2, "counts", 20);
  galaxy::convertBrightness(description, fine);
  galaxy::convertBrightness(description, coarse);
  EXPECT_NEAR(fine.values[60], 5, 1e-5);
  EXPECT_NEAR(coarse.values[60], 5, 1e-5);
  EXPECT_EQ(fine.unit, "counts/arcsec2");
  Image sky = field(11, 3, "MJy/sr", 2);
  galaxy::convertBrightness(description, sky);
  EXPECT_NEAR(sky.values[60], 2e6 / std::pow(180 / std::acos(-1.0) * 3600, 2), 1e-12);
  EXPECT_EQ(sky.unit, "Jy/arcsec2");
}

// 1.104e24 I/(bmaj bmin), I in Jy/beam km/s; 1.823e18 atoms per cm^2 for each K km/s.
TEST(Brightness, ColumnDensity)
{
  ImageDescription description;
  description.convert = BrightnessConversion::ColumnDensity;
  Image line = field(11, 5, "Jy/beam*m/s", 400);
  line.cards += beamCards(30, 20);
  galaxy::convertBrightness(description, line);
  EXPECT_NEAR(line.values[60] / (1.104e24 * 0.4 / 600), 1, 1e-6);
  EXPECT_EQ(line.unit, "cm-2");
  Image kelvin = field(11, 5, "K km/s", 100);
  galaxy::convertBrightness(description, kelvin);
  EXPECT_NEAR(kelvin.values[60], 1.823e20, 1e8);
  Image channel = field(11, 5, "K", 100);
  EXPECT_THROW(galaxy::convertBrightness(description, channel), galaxy::Error);
  // The mass of one atom for each of the atoms, 1.6735e-24 g, from the same columns.
  const Brightness brightness = galaxy::brightnessOf(field(11, 5, "K km/s", 100), {});
  const double megaparsec = 3.0856776e24, sun = 1.98841e33;
  const double area = 25 * std::pow(3 * megaparsec / 206264.806, 2) * 121;
  EXPECT_NEAR(galaxy::hydrogenMass(field(11, 5, "K km/s", 100), brightness, 3) /
      (1.823e20 * area * 1.6735e-24 / sun),
    1, 1e-3);
}

TEST(Brightness, NamesWhatIsMissing)
{
  const std::string message =
    galaxy::errorOf([] { galaxy::brightnessOf(field(11, 5, "Jy/beam", 1), {}); });
  EXPECT_EQ(message.find("field.fits: BMAJ: "), 0u) << message;
  EXPECT_NE(message.find("`beam = [bmaj, bmin, bpa]`"), std::string::npos) << message;
  ImageDescription description;
  description.beam = 10;
  EXPECT_NEAR(galaxy::brightnessOf(field(11, 5, "Jy/beam", 1), description).toSurface,
    1 / (gaussian * 100), 1e-9);
  description.convert = BrightnessConversion::SurfaceBrightness;
  Image velocity = field(11, 5, "m/s", 1);
  EXPECT_THROW(galaxy::convertBrightness(description, velocity), galaxy::Error);
  description.unit = "counts";
  galaxy::convertBrightness(description, velocity);
  EXPECT_NEAR(velocity.values[0], 1 / 25.0, 1e-7);
}

TEST(Beam, OfHistory)
{
  Image image = field(3, 1, "JY/BEAM", 0);
  EXPECT_FALSE(galaxy::beamOf(image));
  std::string history = "HISTORY AIPS   CLEAN BMAJ=  2.5000E-03 BMIN=  1.2500E-03 BPA=  45.50";
  history.resize(80, ' ');
  image.cards += history;
  const auto beam = galaxy::beamOf(image);
  ASSERT_TRUE(beam);
  EXPECT_NEAR(beam->major, 9, 1e-9);
  EXPECT_NEAR(beam->minor, 4.5, 1e-9);
  EXPECT_NEAR(beam->positionAngle, 45.5, 1e-9);
  image.cards += beamCards(20, 10);
  EXPECT_NEAR(galaxy::beamOf(image)->major, 20, 1e-2);
}

namespace
{
std::string historyCard(const std::string& text)
{
  std::string card = "HISTORY " + text;
  card.resize(80, ' ');
  return card;
}

/// 10.8 by 7.2 arcsec, by whatever cards.
void expectBeam(const std::string& cards, double positionAngle)
{
  Image image = field(20, 1.5, "Jy/beam", 1);
  image.cards += cards;
  const auto beam = galaxy::beamOf(image);
  ASSERT_TRUE(beam) << cards;
  EXPECT_NEAR(beam->major, 10.8, 1e-9) << cards;
  EXPECT_NEAR(beam->minor, 7.2, 1e-9) << cards;
  EXPECT_NEAR(beam->positionAngle, positionAngle, 1e-9) << cards;
}
} // namespace

TEST(Beam, WhereverProgramsWriteIt)
{
  expectBeam(historyCard("AIPS   CLEAN BMAJ=  3.0D-03 BMIN=  2.0D-03 BPA= 1"), 1);
  expectBeam(historyCard("AIPS   CLEAN BMAJ=  3.0E-03 BMIN=  2.0E-03 BPA= -40.24 = "), -40.24);
  // What a task was told is not what the image has.
  expectBeam(historyCard("AIPS   CLEAN BMAJ=  3.0E-03 BMIN=  2.0E-03 BPA= 1") +
      historyCard("CONVL BMAJ=  30.0 BMIN= 20.0 BPA= 2  / arcsec"),
    1);
  expectBeam(historyCard("CONVL BMAJ = 10.8 BMIN = 7.2 BPA = 2  / arcsec"), 2);
  expectBeam(historyCard("imager::clean() [] Fitted beam used in") +
      historyCard("> restoration: 10.8 by 7.2 (arcsec) at pa 82.5 (deg)"),
    82.5);
  expectBeam(card("CLEANBMJ", "3.0D-3") + card("CLEANBMN", "0.002") + card("CLEANBPA", "3"), 3);
  expectBeam(card("BMMAJ", "10.8") + card("BMMIN", "7.2") + card("BMPA", "3"), 3);
  for (const auto& [major, minor] : { std::pair("10.8 / [arcsec] beam", "7.2 / [arcsec] beam"),
         { "10.8 / beam major axis in arcseconds", "7.2 / in arcseconds" },
         { "'10.8 arcsec'", "'7.2\"'" }, { "0.18 / (arcmin)", "0.12 / (arcmin)" },
         { "10800.0 / mas", "7200.0 / mas" }, { "3.0D-3 / radio beam", "2.0D-3 / degrees" } })
  {
    expectBeam(card("BMAJ", major) + card("BMIN", minor) + card("BPA", "4 / [deg]"), 4);
  }
}

// 10.8 degrees of a field of half an arcminute: arcsec, most likely, but nothing says so.
TEST(Beam, WiderThanTheImage)
{
  Image image = field(20, 1.5, "Jy/beam", 1);
  image.cards += card("BMAJ", "10.8") + card("BMIN", "7.2");
  const std::string message = galaxy::errorOf([&] { galaxy::brightnessOf(image, {}); });
  EXPECT_EQ(message.find("field.fits: BMAJ: "), 0u) << message;
  EXPECT_NE(message.find("38880 by 25920 arcsec"), std::string::npos) << message;
  EXPECT_NE(message.find("`beam = [bmaj, bmin, bpa]`"), std::string::npos) << message;
  ImageDescription description;
  description.beam = 8.8;
  EXPECT_NEAR(galaxy::brightnessOf(image, description).beamArea, gaussian * 8.8 * 8.8, 1e-9);
  // A cutout may be smaller than its beam; where the unit is none of beams, none counts.
  Image cutout = field(5, 1.5, "Jy/beam", 1);
  cutout.cards += beamCards(12, 10);
  EXPECT_NEAR(galaxy::brightnessOf(cutout, {}).beamArea, gaussian * 120, 1e-9);
  image.unit = "K";
  EXPECT_EQ(galaxy::brightnessOf(image, {}).toSurface, 1);
}

// AIPS's moment map: 3 Jy/beam m/s through 12 by 10 arcsec.
TEST(Beam, ColumnOfAipsMoment)
{
  Image image = field(5, 1.5, "JY/B*M/S", 3);
  image.cards += historyCard("AIPS   CLEAN BMAJ=  1.0000E-02 BMIN=  9.0000E-03 BPA= -10.00") +
    historyCard("AIPS   CLEAN BMAJ=  3.3333333E-03 BMIN=  2.7777778E-03 BPA= -40.24");
  ImageDescription description;
  description.convert = BrightnessConversion::ColumnDensity;
  galaxy::convertBrightness(description, image);
  EXPECT_NEAR(image.values[12] / (1.104e24 * 3e-3 / 120), 1, 1e-6);
}

class BrightnessFiles : public galaxy::testing::FitsFolder
{
};

// CASA's beams of the channels, the first of which holds no data.
TEST_F(BrightnessFiles, MedianOfTheBeamsTable)
{
  const std::string file = this->write("cube.fits", [](fitsfile* fits, int* status) {
    galaxy::testing::addImage(fits, FLOAT_IMG, { 1, 2, 3, 4, 5, 6 }, status);
    char names[3][5] = { "BMAJ", "BMIN", "BPA" };
    char forms[3][3] = { "1E", "1E", "1E" };
    char units[3][7] = { "arcsec", "arcsec", "deg" };
    char* name[] = { names[0], names[1], names[2] };
    char* form[] = { forms[0], forms[1], forms[2] };
    char* unit[] = { units[0], units[1], units[2] };
    fits_create_tbl(fits, BINARY_TBL, 0, 3, name, form, unit, "BEAMS", status);
    double major[] = { 0, 11, 13, 12 }, minor[] = { 0, 6, 8, 7 }, angle[] = { 0, 30, 30, 30 };
    fits_write_col(fits, TDOUBLE, 1, 1, 1, 4, major, status);
    fits_write_col(fits, TDOUBLE, 2, 1, 1, 4, minor, status);
    fits_write_col(fits, TDOUBLE, 3, 1, 1, 4, angle, status);
  });
  const auto beam = galaxy::beamOf(galaxy::readFitsImage(file));
  ASSERT_TRUE(beam);
  EXPECT_NEAR(beam->major, 12, 1e-5);
  EXPECT_NEAR(beam->minor, 7, 1e-5);
  EXPECT_NEAR(beam->positionAngle, 30, 1e-5);
}

TEST_F(BrightnessFiles, ConvertedWithTheGalaxy)
{
  this->write("gas.fits", [](fitsfile* fits, int* status) {
    galaxy::testing::addImage(fits, DOUBLE_IMG, { 1, 2, 3, 4, 5, 6 }, status);
  });
  std::ofstream(this->path("some.galaxy"))
    << "[galaxy]\nra = 10\ndec = 20\ndistance = 5\n[image.gas]\nfile = \"gas.fits\"\nra = 10\n"
       "dec = 20\npixel_scale = 2\nbeam = [8, 2, 40]\nunit = \"Jy/beam km/s\"\n"
       "convert = \"ColumnDensity\"\n";
  const galaxy::Galaxy galaxy = galaxy::readGalaxy(this->path("some.galaxy"));
  ASSERT_EQ(galaxy.images.size(), 1u);
  EXPECT_NEAR(galaxy.images[0].values[2] / (3 * 1.104e24 / 16), 1, 1e-6);
  EXPECT_EQ(galaxy.images[0].unit, "cm-2");
}

// The WSRT moment map: 2047439.79 Jy/beam m/s in all, pixels of 19.99688 arcsec, a beam of
// 57.4163 by 48.3153 arcsec, hence 260.466 Jy km/s and at 8.9 Mpc 4.861e9 Msun. The
// middle of the image is half a pixel from the reference pixel, where NCP is 1.2e-4 larger.
TEST(Brightness, AtomicHydrogenOfNGC2903)
{
  const std::string file = GALAXY_SOURCE_DIR "/../shared/data/NGC2903/NGC_2903_HI_mom0.fits";
  if (!std::filesystem::exists(file))
  {
    GTEST_SKIP() << "no data at " << file;
  }
  const Image image = galaxy::readFitsImage(file);
  const double mass = galaxy::hydrogenMass(image, galaxy::brightnessOf(image, {}), 8.9);
  EXPECT_NEAR(mass / (2.356e5 * 8.9 * 8.9 * 260.466), 1, 2e-4);
}
