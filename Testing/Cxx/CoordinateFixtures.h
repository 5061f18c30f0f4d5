#ifndef galaxy_CoordinateFixtures_h
#define galaxy_CoordinateFixtures_h

#include "Readers/Formats/WorldCoordinates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace galaxy::testing
{
using Cards = std::vector<std::pair<std::string, std::string>>;
inline const double radians = std::acos(-1.0) / 180;

inline std::string header(const Cards& cards)
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
inline Cards simple(const std::string& projection, double ra, double dec)
{
  return { { "NAXIS", "2" }, { "NAXIS1", "100" }, { "NAXIS2", "100" },
    { "CTYPE1", "'RA---" + projection + "'" }, { "CTYPE2", "'DEC--" + projection + "'" },
    { "CRPIX1", "50.5" }, { "CRPIX2", "50.5" }, { "CRVAL1", std::to_string(ra) },
    { "CRVAL2", std::to_string(dec) }, { "CDELT1", "-0.01" }, { "CDELT2", "0.01" } };
}

inline Cards with(Cards cards, const std::string& keyword, const std::string& value)
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

inline std::string exact(double number)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

inline WorldCoordinates make(const Cards& cards)
{
  return WorldCoordinates("some.fits", header(cards), 100, 100);
}

inline SkyPosition sky(const WorldCoordinates& world, double x, double y)
{
  SkyPosition position;
  EXPECT_TRUE(world.pixelToSky({ x, y }, position));
  return position;
}

inline double separationArcsec(const SkyPosition& a, const SkyPosition& b)
{
  const double u = std::sin((a.dec - b.dec) * radians / 2);
  const double v = std::sin((a.ra - b.ra) * radians / 2);
  const double h = u * u + std::cos(a.dec * radians) * std::cos(b.dec * radians) * v * v;
  return 2 * std::asin(std::sqrt(h)) / radians * 3600;
}

inline void expectRoundTrip(const WorldCoordinates& world)
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
} // namespace galaxy::testing

#endif
