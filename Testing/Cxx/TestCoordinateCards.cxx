#include "CoordinateFixtures.h"

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ErrorOf.h"

using namespace galaxy::testing;
using galaxy::CelestialFrame;
using galaxy::SkyPosition;
using galaxy::WorldCoordinates;

namespace
{
/// The card with this text behind "= ", in front of the header: nothing closes or types it.
WorldCoordinates withCard(const Cards& cards, const std::string& keyword, const std::string& value)
{
  return WorldCoordinates("some.fits", header({ { keyword, value } }) + header(cards), 100, 100);
}

const std::vector<std::string> oddValues = { "6.00", "1", "'1e-5    '", "'0'", "'text'",
  "                     / not known", "''", "'no end", "'no end / of it", "T", "-1", "1D400",
  "65536", "2147483647" };

/// All that the header parsers of WCSLIB know beside what describes two linear axes.
std::vector<std::string> strayKeywords()
{
  std::vector<std::string> names = { "CNPIX1", "CNPIX2", "PPO3", "PPO6", "XPIXELSZ", "YPIXELSZ",
    "PLTRAH", "PLTRAM", "PLTRAS", "PLTDECSN", "PLTDECD", "PLTDECM", "PLTDECS", "PLATEID", "A_ORDER",
    "B_ORDER", "AP_ORDER", "BP_ORDER", "A_DMAX", "B_DMAX", "WCSAXES", "WCSAXESB", "CTYPE3",
    "CUNIT3", "CNAME1", "CNAME2", "WCSNAME", "SPECSYS", "SSYSOBS", "SSYSSRC", "VELREF", "TIMESYS",
    "TREFPOS", "TREFDIR", "TIMEUNIT", "PLEPHEM", "DATE-OBS", "DATE-BEG", "DATE-END", "DATE-AVG",
    "DATEREF", "DATE-REF", "MJDREF", "MJDREFI", "JDREFF", "MJD-OBS", "OBSORBIT", "OBSGEO-X",
    "RSUN_REF", "HGLN_OBS", "RESTFRQ", "RESTFREQ", "VSOURCE", "TIMEPIXR", "CRDER1", "CSYER2",
    "CPERR1", "DVERR", "DP1", "DQ2", "PS1_0", "PS99_99", "PV3_1", "CTYPE1A", "CTYPE99", "CRPIX99",
    "CD99_99B", "WAT1_000", "WAT1_001", "WAT2_099", "WAT2_999" };
  for (const char* root : { "A_", "B_", "AP_", "BP_" })
  {
    names.insert(names.end(),
      { root + std::string("0_2"), root + std::string("2_0"), root + std::string("9_9") });
  }
  for (const char* root : { "AMDX", "AMDY" })
  {
    names.insert(names.end(),
      { root + std::string("1"), root + std::string("13"), root + std::string("20"),
        root + std::string("99") });
  }
  return names;
}
} // namespace

// Keywords of plates, distortions, dates and further axes, legal or not, beside a good header.
TEST(CoordinateCards, StrayOnesDoNothing)
{
  const Cards cards = simple("TAN", 150, 20);
  const SkyPosition plain = sky(make(cards), 9, 7);
  for (const std::string& keyword : strayKeywords())
  {
    for (const std::string& value : oddValues)
    {
      const std::string message = galaxy::errorOf([&] {
        const WorldCoordinates world = withCard(cards, keyword, value);
        EXPECT_EQ(separationArcsec(sky(world, 9, 7), plain), 0) << keyword << " = " << value;
      });
      EXPECT_EQ(message, "") << keyword << " = " << value;
    }
  }
}

// Those that count: read, or refused by their name.
TEST(CoordinateCards, BrokenOnesAreNamed)
{
  for (const char* keyword : { "CRVAL1", "CRPIX2", "CDELT1", "CROTA2", "PC1_1", "CD2_1", "LONPOLE",
         "LATPOLE", "PV2_1", "PV1_2" })
  {
    const std::string message =
      galaxy::errorOf([&] { make(with(simple("ZPN", 150, 20), keyword, "'10:00:00'")); });
    EXPECT_EQ(
      message.find(std::string("some.fits: ") + keyword + ": '10:00:00' is not a number"), 0u)
      << message;
  }
  for (const char* keyword : { "CTYPE1", "CTYPE2", "CUNIT1", "CUNIT2", "RADESYS", "RADECSYS",
         "EQUINOX", "EPOCH", "CPDIS1", "CQDIS2", "D2IMDIS1", "NAXIS", "CRVAL2", "PV2_3" })
  {
    for (const std::string& value : oddValues)
    {
      galaxy::errorOf([&] { make(with(simple("TAN", 150, 20), keyword, value)); });
    }
  }
  // A text that nothing closes is what stands there.
  const Cards open = with(simple("TAN", 150, 20), "CTYPE1", "'RA---TAN / longitude");
  EXPECT_EQ(separationArcsec(sky(make(open), 9, 7), sky(make(simple("TAN", 150, 20)), 9, 7)), 0);
}

TEST(CoordinateCards, DExponents)
{
  const Cards cards = simple("TAN", 150, 20);
  Cards fortran = with(with(cards, "CDELT1", "-1.0D-02"), "CDELT2", "1.0d-02");
  fortran = with(with(fortran, "CRVAL1", "1.5D+02"), "CRPIX1", "0.505D2");
  EXPECT_EQ(separationArcsec(sky(make(fortran), 9, 7), sky(make(cards), 9, 7)), 0);
  const Cards matrix = with(with(cards, "PC1_1", "9.0D-1"), "PC1_2", "-3D-1");
  const Cards plain = with(with(cards, "PC1_1", "0.9"), "PC1_2", "-0.3");
  EXPECT_EQ(separationArcsec(sky(make(matrix), 9, 7), sky(make(plain), 9, 7)), 0);
  const SkyPosition fk4 = sky(make(with(cards, "EQUINOX", "1950.")), 9, 7);
  EXPECT_EQ(separationArcsec(sky(make(with(cards, "EQUINOX", "1.95D+03")), 9, 7), fk4), 0);
  EXPECT_EQ(separationArcsec(sky(make(with(cards, "EPOCH", "1.95D3")), 9, 7), fk4), 0);
}

TEST(CoordinateCards, EquinoxAsText)
{
  const Cards cards = simple("TAN", 150, 20);
  const SkyPosition plain = sky(make(cards), 20, 80);
  const auto at = [&](const std::string& keyword, const std::string& value) {
    return sky(make(with(cards, keyword, value)), 20, 80);
  };
  const SkyPosition b1950 = CelestialFrame::fk4(1950).toIcrs(plain);
  const SkyPosition j2000 = CelestialFrame::fk5(2000).toIcrs(plain);
  for (const char* keyword : { "EQUINOX", "EPOCH", "RADESYS", "RADECSYS" })
  {
    for (const char* value : { "'B1950'", "'b1950.0'", "'B1950 (mean)'", "'1950    '" })
    {
      EXPECT_LT(separationArcsec(at(keyword, value), b1950), 1e-6) << keyword << value;
    }
    EXPECT_LT(separationArcsec(at(keyword, "'J2000.0'"), j2000), 1e-6) << keyword;
  }
  EXPECT_LT(
    separationArcsec(at("EQUINOX", "'J1950'"), CelestialFrame::fk5(1950).toIcrs(plain)), 1e-6);
  EXPECT_LT(
    separationArcsec(at("EPOCH", "'B1955.3'"), CelestialFrame::fk4(1955.3).toIcrs(plain)), 1e-6);
  const Cards fk5 = with(with(cards, "RADESYS", "'FK5'"), "EQUINOX", "'1950.0'");
  EXPECT_LT(
    separationArcsec(sky(make(fk5), 20, 80), CelestialFrame::fk5(1950).toIcrs(plain)), 1e-6);
  // A date is no equinox; ICRS has none.
  EXPECT_EQ(separationArcsec(at("EPOCH", "'1950-01-31'"), plain), 0);
  const Cards icrs = with(with(cards, "RADESYS", "'ICRS'"), "EQUINOX", "'of date'");
  EXPECT_EQ(separationArcsec(sky(make(icrs), 20, 80), plain), 0);
  for (const auto& [keyword, value] : { std::pair("EQUINOX", "'APPARENT'"), { "EQUINOX", "20000" },
         { "RADESYS", "'GAPPT'" }, { "RADESYS", "'TETE'" } })
  {
    const std::string message =
      galaxy::errorOf([&, k = keyword, v = value] { make(with(cards, k, v)); });
    EXPECT_EQ(message.find(std::string("some.fits: ") + keyword), 0u) << message;
  }
}

TEST(CoordinateCards, OldIndices)
{
  const Cards cards = simple("TAN", 150, 20);
  const Cards pc = with(with(cards, "PC1_1", "0.9"), "PC2_1", "0.25");
  const Cards pcOld = with(with(cards, "PC001001", "0.9"), "PC002001", "0.25");
  EXPECT_EQ(separationArcsec(sky(make(pc), 9, 7), sky(make(pcOld), 9, 7)), 0);
  const Cards cd = with(with(cards, "CD1_1", "-0.02"), "CD2_2", "0.01");
  const Cards cdOld = with(with(cards, "CD001001", "-0.02"), "CD02_02", "0.01");
  EXPECT_EQ(separationArcsec(sky(make(cd), 9, 7), sky(make(cdOld), 9, 7)), 0);
  EXPECT_GT(separationArcsec(sky(make(cd), 9, 7), sky(make(cards), 9, 7)), 1000);
  const Cards zpn = with(simple("ZPN", 150, 20), "PV2_1", "2");
  const Cards zpnOld = with(simple("ZPN", 150, 20), "PROJP1", "2");
  EXPECT_EQ(separationArcsec(sky(make(zpn), 9, 7), sky(make(zpnOld), 9, 7)), 0);
}

TEST(CoordinateCards, AlternateDescription)
{
  Cards cards = { { "NAXIS", "2" }, { "CTYPE1", "'LINEAR'" }, { "CTYPE2", "'LINEAR'" } };
  for (const auto& [keyword, value] : simple("TAN", 150, 20))
  {
    if (keyword.rfind("NAXIS", 0) != 0)
    {
      cards.emplace_back(keyword + "C", value);
    }
  }
  EXPECT_EQ(separationArcsec(sky(make(cards), 9, 7), sky(make(simple("TAN", 150, 20)), 9, 7)), 0);
}

// IRAF: the correction of eta is a polynomial of xi and eta in degrees, here 1e-3 eta, with zeros
// before it; so the image is 1.001 times as high.
TEST(CoordinateCards, ZerosInCorrection)
{
  const auto corrected = [](const std::string& code, const std::string& end) {
    Cards cards = simple(code, 150, 20);
    cards.emplace_back("WAT1_001", "'wtype=" + end + " axtype=ra'");
    cards.emplace_back(
      "WAT2_001", "'wtype=" + end + " axtype=dec latcor = \"3. 2. 2. 1. -1. 1. -1.'");
    cards.emplace_back("WAT2_002", "'1. 0. 0. 0.001 0. \"'");
    return make(cards);
  };
  const Cards plain = with(simple("TAN", 150, 20), "CDELT2", "0.01001");
  EXPECT_LT(separationArcsec(sky(corrected("TNX", "tnx"), 9, 7), sky(make(plain), 9, 7)), 1e-6);
  const std::string zenithal = "zpx projp1=1.";
  EXPECT_LT(separationArcsec(sky(corrected("ZPX", zenithal), 9, 7),
              sky(make(with(with(plain, "CTYPE1", "'RA---ARC'"), "CTYPE2", "'DEC--ARC'")), 9, 7)),
    1e-6);
  expectRoundTrip(corrected("TNX", "tnx"));
}

TEST(CoordinateCards, BrokenCorrection)
{
  for (const char* text :
    { "'wtype=tnx lngcor = \"3. 2. 2. 1. -1. 1. -1. 1. 0. 0.001", // open
      "'wtype=tnx lngcor = \"3. 2. 2. 1. -1. 1. -1. 1. 0. 0.001 '", "'wtype=tnx lngcor = \"3. \"'",
      "'wtype=tnx lngcor = \"3. 999999999. 9. 1. -1. 1. -1. 1. 0. 0.001 \"'",
      "'wtype=tnx lngcor = \"3. 2. 2. 1. -1. 1. -1. 1. 0. 0.001 0. \"'",
      "'wtype=tnx lngcor = \"3. 2. 2. 1. -1. x -1. 1. 0. 0. 0. 0. \"'" })
  {
    const std::string message =
      galaxy::errorOf([&] { make(with(simple("TNX", 150, 20), "WAT1_001", text)); });
    EXPECT_EQ(message.find("some.fits: WAT1_001: "), 0u) << message;
  }
  // Without any correction TNX is TAN.
  EXPECT_EQ(
    separationArcsec(sky(make(simple("TNX", 5, 6)), 9, 7), sky(make(simple("TAN", 5, 6)), 9, 7)),
    0);
}

// HST says how far its tables move a place.
TEST(CoordinateCards, DistortionTables)
{
  Cards cards = simple("TAN", 150, 20);
  cards = with(with(cards, "CPDIS1", "'LOOKUP'"), "DP1", "'EXTVER: 1.0'");
  cards = with(with(cards, "D2IMDIS2", "'Lookup'"), "D2IMERR2", "0.04");
  const SkyPosition plain = sky(make(simple("TAN", 150, 20)), 9, 7);
  EXPECT_EQ(separationArcsec(sky(make(with(cards, "CPERR1", "0.06")), 9, 7), plain), 0);
  for (const Cards& refused :
    { cards, with(cards, "CPERR1", "3"), with(simple("TAN", 150, 20), "CPDIS1", "'TPD'") })
  {
    const std::string message = galaxy::errorOf([&] { make(refused); });
    EXPECT_EQ(message.find("some.fits: CPDIS1: "), 0u) << message;
  }
}

namespace
{
/// The plate 02EF's pixels about a place (see TestWorldCoordinates), as DSS writes them.
Cards plateCards()
{
  return { { "NAXIS", "2" }, { "PLTRAH", "13" }, { "PLTRAM", "27" }, { "PLTRAS", "48.0" },
    { "PLTDECSN", "'-'" }, { "PLTDECD", "30" }, { "PLTDECM", "15" }, { "PLTDECS", "31.8" },
    { "CNPIX1", "6900" }, { "CNPIX2", "6900" }, { "XPIXELSZ", "25.28445" },
    { "YPIXELSZ", "25.28445" }, { "PPO3", "1.7434938282480E+05" },
    { "PPO6", "1.7515879702645E+05" }, { "AMDX1", "67.2" }, { "AMDX2", "0.03" }, { "AMDX3", "0" },
    { "AMDY1", "67.2" }, { "AMDY2", "-0.03" }, { "AMDY3", "0" } };
}
} // namespace

// The plate's centre is what its header says, South where the sign is a bare minus.
TEST(CoordinateCards, PlateIsWhole)
{
  const WorldCoordinates world("plate.fits", header(plateCards()), 100, 100);
  galaxy::PixelPosition centre;
  const double ra = 15 * (13 + 27 / 60. + 48 / 3600.), dec = -(30 + 15 / 60. + 31.8 / 3600);
  ASSERT_TRUE(world.skyToPixel({ ra, dec }, centre));
  EXPECT_NEAR(centre.x, 174349.38282480 / 25.28445 - 6900 + 0.5, 1e-6);
  EXPECT_NEAR(centre.y, 175158.79702645 / 25.28445 - 6900 + 0.5, 1e-6);
  // Any number missing, or a text, leaves no solution; axes of its own then count.
  for (const auto& [keyword, value] : plateCards())
  {
    Cards broken = with(plateCards(), keyword, "'x'");
    if (keyword == "NAXIS")
    {
      continue;
    }
    EXPECT_THROW(make(broken), galaxy::Error) << keyword;
    const Cards axes = simple("TAN", 150, 20);
    broken.insert(broken.end(), axes.begin(), axes.end());
    EXPECT_EQ(separationArcsec(sky(make(broken), 9, 7), sky(make(axes), 9, 7)), 0) << keyword;
  }
}

// A whole plate of a size of 0, beside good axes.
TEST(CoordinateCards, SingularPlate)
{
  const Cards axes = simple("TAN", 150, 20);
  for (const char* keyword : { "XPIXELSZ", "AMDX1" })
  {
    Cards cards = with(with(plateCards(), keyword, "0"), "AMDY2", "0");
    cards.insert(cards.end(), axes.begin(), axes.end());
    EXPECT_EQ(separationArcsec(sky(make(cards), 9, 7), sky(make(axes), 9, 7)), 0) << keyword;
  }
}

// On the straight meridian of the polyconic projection the latitude is eta itself.
TEST(OffTheSky, MeridianOfPolyconic)
{
  const WorldCoordinates world = make(simple("PCO", 150, 0));
  const SkyPosition place = sky(world, 50.5, 70.5);
  EXPECT_NEAR(place.ra, 150, 1e-8);
  EXPECT_NEAR(place.dec, 0.2, 1e-8);
  expectRoundTrip(world);
}

// x' = x - 0.01 x^2 from the reference pixel is folded beyond x = 50: what lies there is seen
// nearer as well.
TEST(OffTheSky, FoldedDistortion)
{
  Cards cards = with(with(simple("TAN", 150, 20), "A_ORDER", "2"), "B_ORDER", "2");
  cards = with(with(with(cards, "A_2_0", "-0.01"), "CRPIX1", "1"), "CTYPE1", "'RA---TAN-SIP'");
  const WorldCoordinates world = make(with(cards, "CTYPE2", "'DEC--TAN-SIP'"));
  SkyPosition place;
  EXPECT_TRUE(world.pixelToSky({ 30, 50 }, place));
  EXPECT_FALSE(world.pixelToSky({ 90, 50 }, place));
}

TEST(OffTheSky, AbsurdNumbers)
{
  for (const Cards& cards : { with(simple("PCO", 150, 20), "PV2_11", "-1e30"),
         with(simple("TPV", 150, 20), "PV1_4", "1e30"),
         with(with(with(simple("TAN", 150, 20), "A_ORDER", "9"), "B_ORDER", "9"), "A_9_0", "1e300"),
         with(simple("TAN", 150, 20), "CRPIX1", "1e300"),
         with(simple("AIT", 150, 20), "CDELT1", "1e30") })
  {
    galaxy::errorOf([&] {
      const WorldCoordinates world = make(cards);
      for (double x = 1; x <= 100; x += 0.5)
      {
        SkyPosition place = { 1, 2 };
        if (world.pixelToSky({ x, x }, place))
        {
          EXPECT_TRUE(place.ra >= 0 && place.ra < 360 && std::abs(place.dec) <= 90);
        }
      }
    });
  }
}

// Of an all-sky map the first and the last pixels see the same meridian.
TEST(OffTheSky, SeamIsOnIt)
{
  Cards cards = with(with(simple("CAR", 0, 0), "CDELT1", "-3.6"), "CDELT2", "1.8");
  cards = with(with(cards, "CRPIX1", "51"), "CRPIX2", "51");
  EXPECT_NEAR(sky(make(cards), 1, 51).ra, 180, 1e-9);
  EXPECT_NEAR(sky(make(cards), 101, 51).ra, 180, 1e-9);
  EXPECT_NEAR(sky(make(cards), 20, 101).dec, 90, 1e-9);
}
