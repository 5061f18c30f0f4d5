#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/WorldCoordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

using galaxy::CelestialFrame;
using galaxy::PixelPosition;
using galaxy::SkyPosition;
using galaxy::SuppliedCoordinates;
using galaxy::WorldCoordinates;

namespace
{
using Cards = std::vector<std::pair<std::string, std::string>>;
const double radians = std::acos(-1.0) / 180;

std::string header(const Cards& cards)
{
  std::string text;
  for (const auto& [keyword, value] : cards)
  {
    std::string card = keyword;
    card.resize(8, ' ');
    card += "= " + value;
    card.resize(80, ' ');
    text += card;
  }
  return text;
}

/// 100 x 100 pixels of 0.01 degrees, North up, East left, about (ra, dec).
Cards simple(const std::string& projection, double ra, double dec)
{
  return { { "NAXIS", "2" }, { "NAXIS1", "100" }, { "NAXIS2", "100" },
    { "CTYPE1", "'RA---" + projection + "'" }, { "CTYPE2", "'DEC--" + projection + "'" },
    { "CRPIX1", "50.5" }, { "CRPIX2", "50.5" }, { "CRVAL1", std::to_string(ra) },
    { "CRVAL2", std::to_string(dec) }, { "CDELT1", "-0.01" }, { "CDELT2", "0.01" } };
}

Cards with(Cards cards, const std::string& keyword, const std::string& value)
{
  for (auto& card : cards)
  {
    if (card.first == keyword)
    {
      card.second = value;
      return cards;
    }
  }
  cards.emplace_back(keyword, value);
  return cards;
}

std::string exact(double number)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

WorldCoordinates make(const Cards& cards)
{
  return WorldCoordinates("some.fits", header(cards), 100, 100);
}

SkyPosition sky(const WorldCoordinates& world, double x, double y)
{
  SkyPosition position;
  EXPECT_TRUE(world.pixelToSky({ x, y }, position));
  return position;
}

double separationArcsec(const SkyPosition& a, const SkyPosition& b)
{
  const double u = std::sin((a.dec - b.dec) * radians / 2);
  const double v = std::sin((a.ra - b.ra) * radians / 2);
  const double h = u * u + std::cos(a.dec * radians) * std::cos(b.dec * radians) * v * v;
  return 2 * std::asin(std::sqrt(h)) / radians * 3600;
}

void expectRoundTrip(const WorldCoordinates& world)
{
  for (double x = 1; x <= 100; x += 11)
  {
    for (double y = 1; y <= 100; y += 11)
    {
      PixelPosition back;
      ASSERT_TRUE(world.skyToPixel(sky(world, x, y), back));
      EXPECT_NEAR(back.x, x, 1e-7);
      EXPECT_NEAR(back.y, y, 1e-7);
    }
  }
}
} // namespace

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

// Where astropy 5.2 puts B1950 100 +80 in ICRS; without E-terms it would be 0.3 arcsec away.
TEST(WorldCoordinates, BesselianEquinox)
{
  const SkyPosition known = { 102.18535497, 79.94643726 };
  const Cards cards = simple("SIN", 100, 80);
  for (const Cards& fk4 : { with(cards, "EPOCH", "1950.0"), with(cards, "EQUINOX", "1950"),
         with(cards, "RADESYS", "'FK4'") })
  {
    EXPECT_LT(separationArcsec(sky(make(fk4), 50.5, 50.5), known), 0.03);
  }
}

TEST(WorldCoordinates, PlateDateIsNoEquinox)
{
  const Cards cards = simple("TAN", 210.8, 54.35);
  const SkyPosition plain = sky(make(cards), 20, 20);
  EXPECT_EQ(separationArcsec(sky(make(with(cards, "EPOCH", "1955.3")), 20, 20), plain), 0);
  EXPECT_GT(separationArcsec(sky(make(with(cards, "EPOCH", "1950.0")), 20, 20), plain), 600);
  EXPECT_GT(separationArcsec(sky(make(with(cards, "EQUINOX", "1955.3")), 20, 20), plain), 600);
}

// The north Galactic pole and the Galactic centre in ICRS (ESA 1997, volume 1, 1.5.3).
TEST(WorldCoordinates, Galactic)
{
  Cards cards = simple("TAN", 0, 0);
  cards = with(with(cards, "CTYPE1", "'GLON-TAN'"), "CTYPE2", "'GLAT-TAN'");
  EXPECT_LT(separationArcsec(sky(make(cards), 50.5, 50.5), { 266.40499625, -28.93617242 }), 0.01);
  cards = with(cards, "CRVAL2", "90.0");
  EXPECT_LT(separationArcsec(sky(make(cards), 50.5, 50.5), { 192.85948, 27.12825 }), 0.01);
}

TEST(CelestialFrame, InverseOfEach)
{
  for (const CelestialFrame& frame :
    { CelestialFrame::icrs(), CelestialFrame::galactic(), CelestialFrame::ecliptic(),
      CelestialFrame::fk5(1975), CelestialFrame::fk4(1950), CelestialFrame::fk4(1900) })
  {
    for (double dec = -89.5; dec < 90; dec += 17.9)
    {
      const SkyPosition position = { 123.25, dec };
      EXPECT_LT(separationArcsec(frame.toIcrs(frame.fromIcrs(position)), position), 1e-5);
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
    try
    {
      make(cards);
      FAIL();
    }
    catch (const galaxy::Error& error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("`ra`, `dec` and `pixel_scale`"), std::string::npos) << message;
      EXPECT_EQ(message.find("some.fits: CTYPE: "), 0u) << message;
    }
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
