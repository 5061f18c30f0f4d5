// One circle of 21.6 arcsec in the frames and writings of DS9 and CASA; places by astropy.
#include "Readers/Formats/RegionList.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>

namespace galaxy
{
namespace
{
/// 201 x 201 pixels of 3.6 arcsec about a place in Virgo.
const WorldCoordinates& coordinates()
{
  static const WorldCoordinates sky = [] {
    SuppliedCoordinates supplied;
    supplied.centre = { 188.5637, 12.0264 };
    supplied.pixelScale = 3.6;
    return WorldCoordinates(supplied, 201, 201);
  }();
  return sky;
}

std::vector<PixelRegion> regionsOf(const std::string& text)
{
  RegionCanvas canvas;
  canvas.coordinates = &coordinates();
  return parseRegions(text, "some.reg", canvas);
}

std::string messageOf(const std::string& text)
{
  return errorOf([&] { regionsOf(text); });
}

int pixelsIn(const PixelRegion& region)
{
  int count = 0;
  for (int y = 1; y <= 201; ++y)
  {
    for (int x = 1; x <= 201; ++x)
    {
      count += region.contains({ double(x), double(y) });
    }
  }
  return count;
}
} // namespace

TEST(RegionDialects, OneCircleInEveryFrame)
{
  for (const char* text : { "fk5;circle(188.5637,12.0264,21.6\")",
         "\xef\xbb\xbf"
         "fk5\ncircle(188.5637,12.0264,21.6\")\n",
         "# DS9\rfk5\rcircle(12:34:15.288,+12:01:35.04,0.36')\r",
         " icrs ; circle( 12h34m15.288s, +12d01m35.04s, 0.006d )",
         "galactic;circle(287.154114,74.369399,21.6\")",
         "galactic;circle(+287:09:14.812,+74:22:09.836,21.6\")",
         "ecliptic;circle(183.003242,14.424339,21.6\")",
         "ecliptic;circle(183:00:11.67,+14:25:27.62,21.6\")",
         "global color=green font=\"helvetica 10 image roman\" width=3 fk5\n"
         "circle(12:34:15.288,+12:01:35.04,21.6\")",
         "global galactic color=green\ncircle(287:09:14.812,74:22:09.836,21.6\")",
         "#CRTFv0\ncircle[[287.154114deg, 74.369399deg], 21.6arcsec], coord=GALACTIC",
         "#CRTFv0\nglobal coord=GALACTIC\ncircle[[287:09:14.812, 74:22:09.836], 21.6arcsec]",
         "fk5\ncircle(188.5637,12.0264,21.6\") || # color=red\n" })
  {
    std::vector<PixelRegion> regions;
    ASSERT_EQ(errorOf([&] { regions = regionsOf(text); }), "") << text;
    ASSERT_EQ(regions.size(), 1u) << text;
    EXPECT_NEAR(regions[0].middle.x, 101, 0.02) << text;
    EXPECT_NEAR(regions[0].middle.y, 101, 0.02) << text;
    EXPECT_NEAR(pixelsIn(regions[0]), 113, 4) << text;
  }
}

TEST(RegionDialects, WhatIsUnknownIsNamed)
{
  EXPECT_NE(
    messageOf("detector\ncircle(1,2,3)\n").find("line 1: 'detector' is a frame not known here"),
    std::string::npos);
  EXPECT_NE(
    messageOf("wcsa;circle(1,2,3)\n").find("'wcsa' is a frame not known"), std::string::npos);
  EXPECT_NE(messageOf("circle(12:34:15,12:01:35,21\")\n").find("name the frame of angles first"),
    std::string::npos);
  EXPECT_NE(
    messageOf("fk5;circle(12:75:15,12:01:35,21\")\n").find("line 1: '12:75:15' must be a number"),
    std::string::npos);
  EXPECT_NE(messageOf("fk5;circle(1,91,21\")\n").find("must be -90 to 90 degrees, not '91'"),
    std::string::npos);
  EXPECT_NE(messageOf("\xff\xfe"
                      "f")
              .find("UTF-16"),
    std::string::npos);
}

TEST(RegionDialects, MessagesAreWholeAndPrintable)
{
  const std::string escape = messageOf("image\n\x1b[31mcirclo(1,2,3)\n");
  EXPECT_EQ(escape.find('\x1b'), std::string::npos);
  EXPECT_NE(escape.find("line 2: '\\x1b' is not a shape; use circle"), std::string::npos) << escape;
  const std::string longName = messageOf("image\n" + std::string(100000, 'a') + "(1,2,3)\n");
  EXPECT_LT(longName.size(), 300u);
  EXPECT_NE(longName.find("; use circle"), std::string::npos);
  EXPECT_NE(messageOf(std::string("image\ncirc\0le(1,2,3)\n", 21)).find("line 2: holds a NUL byte"),
    std::string::npos);
}

TEST(RegionDialects, ExclusionsAndSigns)
{
  const std::vector<PixelRegion> regions =
    regionsOf("image;!circle(5,5,2);-box(5,5,2,2);+circle(5,5,1)\n");
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_TRUE(regions[0].excluded);
  EXPECT_TRUE(regions[1].excluded);
  EXPECT_FALSE(regions[2].excluded);
}
} // namespace galaxy
