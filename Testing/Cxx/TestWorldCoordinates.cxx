#include "CoordinateFixtures.h"

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ErrorOf.h"

using namespace galaxy::testing;
using galaxy::CelestialFrame;
using galaxy::PixelPosition;
using galaxy::SkyPosition;
using galaxy::SuppliedCoordinates;
using galaxy::WorldCoordinates;

TEST(WorldCoordinates, RoundTrips)
{
  expectRoundTrip(make(simple("TAN", 204.25, -29.87)));
  expectRoundTrip(make(simple("SIN", 204.25, -29.87)));
  expectRoundTrip(make(simple("TAN", 0.001, 89.999)));
  expectRoundTrip(make(with(simple("TAN", 204.25, 29.87), "CROTA2", "33")));
  expectRoundTrip(make(with(simple("SIN", 204.25, 29.87), "EPOCH", "1950.0")));
}

// At the reference declination's meridian TAN has tan(delta - delta0) = eta, SIN sin() = eta.
TEST(WorldCoordinates, ProjectionsDiffer)
{
  const double eta = 49.5 * 0.01 * radians;
  EXPECT_NEAR(
    sky(make(simple("TAN", 10, 20)), 50.5, 100).dec, 20 + std::atan(eta) / radians, 1e-10);
  EXPECT_NEAR(
    sky(make(simple("SIN", 10, 20)), 50.5, 100).dec, 20 + std::asin(eta) / radians, 1e-10);
}

TEST(WorldCoordinates, SignOfCdelt)
{
  EXPECT_LT(sky(make(simple("TAN", 10, 0)), 60.5, 50.5).ra, 10);
  EXPECT_GT(sky(make(with(simple("TAN", 10, 0), "CDELT1", "0.01")), 60.5, 50.5).ra, 10);
}

// AIPS: xi = CDELT1 dx cos - CDELT2 dy sin, eta = CDELT1 dx sin + CDELT2 dy cos of CROTA2.
TEST(WorldCoordinates, CrotaEqualsItsMatrix)
{
  const WorldCoordinates quarter = make(with(simple("TAN", 10, 0), "CROTA2", "90"));
  EXPECT_NEAR(sky(quarter, 50.5, 60.5).ra, 10 - std::atan(0.1 * radians) / radians, 1e-10);
  EXPECT_NEAR(sky(quarter, 50.5, 60.5).dec, 0, 1e-10);

  Cards cards = simple("TAN", 10, 40);
  const WorldCoordinates turned = make(with(cards, "CROTA2", "20"));
  const double c = 0.01 * std::cos(20 * radians), s = 0.01 * std::sin(20 * radians);
  cards.resize(cards.size() - 2); // CDELT
  cards = with(with(cards, "CD1_1", exact(-c)), "CD1_2", exact(-s));
  cards = with(with(cards, "CD2_1", exact(-s)), "CD2_2", exact(c));
  const WorldCoordinates matrix = make(cards);
  EXPECT_LT(separationArcsec(sky(turned, 80, 10), sky(matrix, 80, 10)), 1e-6);
  expectRoundTrip(matrix);
}

TEST(WorldCoordinates, AxesInEitherOrder)
{
  const Cards plain = simple("TAN", 30, 40);
  Cards swapped = with(with(plain, "CTYPE1", "'DEC--TAN'"), "CTYPE2", "'RA---TAN'");
  swapped = with(with(swapped, "CRVAL1", "40"), "CRVAL2", "30");
  swapped = with(with(swapped, "CDELT1", "0.01"), "CDELT2", "-0.01");
  EXPECT_LT(separationArcsec(sky(make(plain), 10, 80), sky(make(swapped), 80, 10)), 1e-9);
}

TEST(WorldCoordinates, CubeAxesAreLeftOut)
{
  Cards cube = with(simple("SIN", 30, 40), "NAXIS", "3");
  cube = with(with(cube, "NAXIS3", "7"), "CTYPE3", "'VELO-LSR'");
  cube = with(with(with(cube, "CRPIX3", "4"), "CRVAL3", "5e5"), "CDELT3", "2000");
  EXPECT_LT(separationArcsec(sky(make(cube), 7, 8), sky(make(simple("SIN", 30, 40)), 7, 8)), 1e-9);
}

TEST(WorldCoordinates, SmallLettersInCtype)
{
  const Cards cards =
    with(with(simple("TAN", 30, 40), "CTYPE1", "'ra---tan'"), "CTYPE2", "'dec--tan'");
  EXPECT_NEAR(sky(make(cards), 50.5, 50.5).ra, 30, 1e-9);
}

TEST(WorldCoordinates, RightAscensionWraps)
{
  const WorldCoordinates world = make(simple("TAN", 0.0, 0));
  const SkyPosition east = sky(world, 40.5, 50.5), west = sky(world, 60.5, 50.5);
  EXPECT_NEAR(east.ra, 0.1, 1e-5);
  EXPECT_NEAR(west.ra, 359.9, 1e-5);
  PixelPosition pixel;
  ASSERT_TRUE(world.skyToPixel({ -0.1, 0 }, pixel));
  EXPECT_NEAR(pixel.x, 60.5, 1e-4);
}

TEST(WorldCoordinates, BehindTheTangentPlane)
{
  for (const char* projection : { "TAN", "SIN" })
  {
    const WorldCoordinates world = make(simple(projection, 10, 20));
    PixelPosition pixel;
    EXPECT_FALSE(world.skyToPixel({ 190, -20 }, pixel));
    EXPECT_FALSE(world.skyToPixel({ 101, 0 }, pixel));
    EXPECT_TRUE(world.skyToPixel({ 40, 20 }, pixel));
    EXPECT_FALSE(world.skyToPixel({ std::nan(""), 20 }, pixel));
    EXPECT_FALSE(world.skyToPixel({ 10, 91 }, pixel));
  }
  SkyPosition position;
  EXPECT_FALSE(make(simple("SIN", 10, 20)).pixelToSky({ 1e5, 1e5 }, position));
}

TEST(WorldCoordinates, AnyTwoAxesOfACube)
{
  // Declination, polarization, frequency, right ascension.
  Cards cube = { { "NAXIS", "4" }, { "CTYPE1", "'DEC--TAN'" }, { "CTYPE2", "'STOKES'" },
    { "CTYPE3", "'FREQ'" }, { "CTYPE4", "'RA---TAN'" }, { "CRPIX1", "50.5" }, { "CRPIX3", "5" },
    { "CRPIX4", "50.5" }, { "CRVAL1", "-29.87" }, { "CRVAL3", "1.4e9" }, { "CRVAL4", "204.25" },
    { "CDELT1", "0.01" }, { "CDELT3", "1e5" }, { "CDELT4", "-0.01" } };
  const WorldCoordinates world("some.fits", header(cube), 100, 100, { 1, 4 });
  EXPECT_LT(separationArcsec(sky(world, 80, 10), { 204.715655855, -29.574190346 }), 1e-4);
  const WorldCoordinates turned("some.fits", header(cube), 100, 100, { 4, 1 });
  EXPECT_LT(separationArcsec(sky(turned, 10, 80), { 204.715655855, -29.574190346 }), 1e-4);
  expectRoundTrip(world);
  EXPECT_THROW(make(cube), galaxy::Error);
  EXPECT_THROW(WorldCoordinates("some.fits", header(cube), 100, 100, { 1, 5 }), galaxy::Error);
}

// A cube whose frames drift: in its first plane the third axis stands 4 pixels before its
// reference, which moves the image by 4 times the coupling.
TEST(WorldCoordinates, CoupledAxesStandAtTheirFirstPixel)
{
  Cards cube = with(simple("TAN", 30, 40), "NAXIS", "3");
  cube = with(with(with(cube, "CTYPE3", "'FREQ'"), "CRPIX3", "5"), "CRVAL3", "1.4e9");
  cube = with(with(with(cube, "CDELT3", "1e5"), "PC1_3", "0.5"), "PC2_3", "-0.25");
  const WorldCoordinates plain = make(simple("TAN", 30, 40));
  EXPECT_LT(separationArcsec(sky(make(cube), 20, 30), sky(plain, 18, 31)), 1e-6);
}

// The first Digitized Sky Survey's plate 02EF; its header says itself where the object at plate
// position (OBJCTX, OBJCTY) is. Plate positions count from the corner of pixel (CNPIX1, CNPIX2).
Cards plate()
{
  return { { "NAXIS", "2" }, { "NAXIS1", "671" }, { "NAXIS2", "671" },
    { "EPOCH", "1.9772154541016E+03" }, { "PLTRAH", "13" }, { "PLTRAM", "27" },
    { "PLTRAS", "4.8047100000000E+01" }, { "PLTDECSN", "'-       '" }, { "PLTDECD", "30" },
    { "PLTDECM", "15" }, { "PLTDECS", "3.1820050000000E+01" }, { "EQUINOX", "2000.0" },
    { "CNPIX1", "2332" }, { "CNPIX2", "7383" }, { "XPIXELSZ", "25.28445" },
    { "YPIXELSZ", "25.28445" }, { "PPO3", "1.7434938282480E+05" },
    { "PPO6", "1.7515879702645E+05" }, { "AMDX1", "6.7227495030690E+01" },
    { "AMDX2", "2.9793136064973E-02" }, { "AMDX3", "1.9576265118295E+00" },
    { "AMDX4", "6.7699293826749E-06" }, { "AMDX5", "-6.6700201545182E-06" },
    { "AMDX6", "8.9657410389098E-06" }, { "AMDX8", "2.1099251805393E-06" },
    { "AMDX9", "-1.8240621380626E-08" }, { "AMDX10", "2.2396865195897E-06" },
    { "AMDX11", "8.1481318481654E-08" }, { "AMDY1", "6.7234188870552E+01" },
    { "AMDY2", "-2.6344070495285E-02" }, { "AMDY3", "-6.9512728958735E-01" },
    { "AMDY4", "-3.9711762782279E-05" }, { "AMDY5", "-5.5705657285219E-06" },
    { "AMDY6", "-2.1510639123363E-07" }, { "AMDY8", "2.1239660767347E-06" },
    { "AMDY9", "-9.0598759410797E-09" }, { "AMDY10", "2.1857438364038E-06" },
    { "AMDY11", "-2.5749824973103E-07" } };
}

TEST(WorldCoordinates, PlateSolution)
{
  const WorldCoordinates world("plate.fits", header(plate()), 671, 671);
  // 13 37 00.785 -29 51 58.54 at (2667.27, 7718.51), FK5.
  const SkyPosition object = CelestialFrame::fk5(2000).toIcrs(
    { 15 * (13 + 37 / 60. + 0.785 / 3600), -(29 + 51 / 60. + 58.54 / 3600) });
  const double x = 2667.27 - 2332 + 0.5, y = 7718.51 - 7383 + 0.5;
  EXPECT_LT(separationArcsec(sky(world, x, y), object), 0.02);
  EXPECT_NEAR(separationArcsec(sky(world, 336, 336), sky(world, 336, 337)), 1.6995, 1e-4);
}

// Axes fitted to the plate say the same less exactly; those of a turned copy say something else.
TEST(WorldCoordinates, PlateSolutionOfAnotherImage)
{
  const WorldCoordinates solution("plate.fits", header(plate()), 671, 671);
  const SkyPosition middle = sky(solution, 336, 336);
  Cards axes = { { "CTYPE1", "'RA---TAN'" }, { "CTYPE2", "'DEC--TAN'" }, { "CRPIX1", "336" },
    { "CRPIX2", "336" }, { "CRVAL1", exact(middle.ra) }, { "CRVAL2", exact(middle.dec) },
    { "CDELT1", "-4.7208E-4" }, { "CDELT2", "4.7208E-4" } };
  const auto withAxes = [&axes](const std::string& rotation) {
    Cards all = with(plate(), "CROTA2", rotation);
    all.insert(all.end(), axes.begin(), axes.end());
    return WorldCoordinates("plate.fits", header(all), 671, 671);
  };
  EXPECT_EQ(separationArcsec(sky(withAxes("1.127"), 600, 600), sky(solution, 600, 600)), 0);
  const WorldCoordinates turned = withAxes("-20");
  const SkyPosition centre = sky(turned, 336, 336);
  EXPECT_LT(separationArcsec(centre, middle), 0.05); // FK5 and ICRS
  const SkyPosition up = sky(turned, 336, 346);
  EXPECT_NEAR(
    std::atan2((up.ra - centre.ra) * std::cos(middle.dec * radians), up.dec - centre.dec) / radians,
    20, 0.05);
}

TEST(WorldCoordinates, PlateDateIsNoEquinox)
{
  const Cards cards = simple("TAN", 210.8, 54.35);
  const SkyPosition plain = sky(make(cards), 20, 20);
  EXPECT_EQ(separationArcsec(sky(make(with(cards, "EPOCH", "1955.3")), 20, 20), plain), 0);
  EXPECT_GT(separationArcsec(sky(make(with(cards, "EPOCH", "1950.0")), 20, 20), plain), 600);
  EXPECT_GT(separationArcsec(sky(make(with(cards, "EQUINOX", "1955.3")), 20, 20), plain), 600);
}

// Astropy 5.2's Galactic centre and north Galactic pole in ICRS.
TEST(CelestialFrame, Galactic)
{
  const CelestialFrame galactic = CelestialFrame::galactic();
  EXPECT_LT(separationArcsec(galactic.toIcrs({ 0, 0 }), { 266.404988287, -28.936177762 }), 1e-4);
  EXPECT_LT(separationArcsec(galactic.toIcrs({ 0, 90 }), { 192.859477895, 27.128252415 }), 1e-4);
}

TEST(CelestialFrame, InverseOfEach)
{
  for (const CelestialFrame& frame : { CelestialFrame::icrs(), CelestialFrame::galactic(),
         CelestialFrame::ecliptic(2000), CelestialFrame::fk4WithoutETerms(1950),
         CelestialFrame::fk5(1975), CelestialFrame::fk4(1950), CelestialFrame::fk4(1900) })
  {
    for (double dec = -89.5; dec < 90; dec += 17.9)
    {
      const SkyPosition position = { 123.25, dec };
      EXPECT_LT(separationArcsec(frame.toIcrs(frame.fromIcrs(position)), position), 1e-8);
    }
  }
}

// 50.3 arcsec a year along the ecliptic: 3.07 s in right ascension at the equinox.
TEST(CelestialFrame, PrecessionSpeed)
{
  const SkyPosition equinox = CelestialFrame::fk5(1975).toIcrs({ 0, 0 });
  EXPECT_NEAR(equinox.ra * 240 / 25, 3.0749, 1e-3);
  EXPECT_NEAR(equinox.dec * 3600 / 25, 20.043, 1e-2);
}

TEST(WorldCoordinates, NoCelestialAxes)
{
  for (const Cards& cards : { Cards{ { "NAXIS", "2" } },
         with(with(simple("TAN", 1, 2), "CTYPE1", "'FREQ'"), "CTYPE2", "'STOKES'"), Cards{} })
  {
    const std::string message = galaxy::errorOf([&] { make(cards); });
    EXPECT_NE(message.find("`ra`, `dec` and `pixel_scale`"), std::string::npos) << message;
    EXPECT_EQ(message.find("some.fits: CTYPE: "), 0u) << message;
  }
}

TEST(SuppliedCoordinates, MiddleScaleAngleAndMirror)
{
  SuppliedCoordinates supplied;
  supplied.centre = { 10, 0 };
  supplied.pixelScale = 36;
  const double step = std::atan(0.1 * radians) / radians; // ten pixels
  const SkyPosition up = sky(WorldCoordinates(supplied, 100, 100), 50.5, 60.5);
  EXPECT_NEAR(up.ra, 10, 1e-10);
  EXPECT_NEAR(up.dec, step, 1e-10);
  EXPECT_NEAR(sky(WorldCoordinates(supplied, 100, 100), 40.5, 50.5).ra, 10 + step, 1e-10);

  supplied.positionAngle = 90;
  EXPECT_NEAR(sky(WorldCoordinates(supplied, 100, 100), 50.5, 60.5).ra, 10 + step, 1e-10);
  EXPECT_NEAR(sky(WorldCoordinates(supplied, 100, 100), 60.5, 50.5).dec, step, 1e-10);

  supplied.positionAngle = 0;
  supplied.mirrored = true;
  supplied.pixel = { 1, 1 };
  EXPECT_NEAR(sky(WorldCoordinates(supplied, 100, 100), 11, 1).ra, 10 + step, 1e-10);
  expectRoundTrip(WorldCoordinates(supplied, 100, 100));

  supplied.pixelScale = 0;
  EXPECT_THROW(WorldCoordinates(supplied, 100, 100), galaxy::Error);
}
