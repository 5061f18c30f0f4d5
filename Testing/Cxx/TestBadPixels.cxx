#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/RegionList.h"
#include "Testing/Cxx/ErrorOf.h"

#include <fitsio.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace galaxy
{
namespace
{
const SkyPosition centre = { 202.47, 47.195 };

/// 101 x 101 pixels of 2 arcsec, North up and East left, the middle pixel at the centre.
WorldCoordinates coordinates()
{
  SuppliedCoordinates supplied;
  supplied.centre = centre;
  supplied.pixelScale = 2;
  return WorldCoordinates(supplied, 101, 101);
}

PixelRegion only(const std::string& text)
{
  static const WorldCoordinates sky = coordinates();
  RegionCanvas canvas;
  canvas.coordinates = &sky;
  const std::vector<PixelRegion> regions = parseRegions(text, "stars.reg", canvas);
  EXPECT_EQ(regions.size(), 1u) << text;
  return regions.empty() ? PixelRegion() : regions[0];
}

double areaOf(const PixelRegion& region)
{
  double area = 0;
  for (std::size_t i = 0, j = region.corners.size() - 1; i < region.corners.size(); j = i++)
  {
    const PixelPosition &p = region.corners[j], &q = region.corners[i];
    area += 0.5 * (p.x * q.y - q.x * p.y);
  }
  return std::abs(area);
}

std::string messageOf(const std::string& text)
{
  return errorOf([&] { parseRegions(text, "stars.reg", {}); });
}

/// Files of a test in a folder of their own.
class BadPixelFiles : public testing::Test
{
protected:
  BadPixelFiles()
    : folder(std::filesystem::path(testing::TempDir()) /
        ("galaxy-bad-pixels-" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(this->folder);
    this->image.width = this->image.height = 101;
    this->image.values.assign(101 * 101, 1);
    this->image.file = "image.fits";
    this->description.suppliesCoordinates = true;
    this->description.coordinates.centre = centre;
    this->description.coordinates.pixelScale = 2;
  }
  ~BadPixelFiles() override { std::filesystem::remove_all(this->folder); }

  std::string galaxyFile() const { return (this->folder / "m.galaxy").string(); }

  /// A square mask whose middle pixel is at the sky's centre; 0 arcsec a pixel: no coordinates.
  void writeMask(int size, double pixel, const std::vector<float>& values)
  {
    fitsfile* file = nullptr;
    int status = 0;
    const std::string path = "!" + (this->folder / "mask.fits").string();
    long axes[2] = { size, size };
    fits_create_file(&file, path.c_str(), &status);
    fits_create_img(file, FLOAT_IMG, 2, axes, &status);
    if (pixel > 0)
    {
      char types[2][9] = { "RA---TAN", "DEC--TAN" };
      fits_write_key(file, TSTRING, "CTYPE1", types[0], nullptr, &status);
      fits_write_key(file, TSTRING, "CTYPE2", types[1], nullptr, &status);
      const std::pair<const char*, double> numbers[] = { { "CRVAL1", centre.ra },
        { "CRVAL2", centre.dec }, { "CRPIX1", 0.5 * (size + 1) }, { "CRPIX2", 0.5 * (size + 1) },
        { "CDELT1", -pixel / 3600 }, { "CDELT2", pixel / 3600 } };
      for (auto [key, number] : numbers)
      {
        fits_write_key(file, TDOUBLE, key, &number, nullptr, &status);
      }
    }
    fits_write_img(file, TFLOAT, 1, size * size, const_cast<float*>(values.data()), &status);
    fits_close_file(file, &status);
    ASSERT_EQ(status, 0);
    this->description.mask = "mask.fits";
  }

  void writeRegions(const std::string& text)
  {
    std::ofstream(this->folder / "stars.reg") << text;
    this->description.regions = "stars.reg";
  }

  int marked() const { return std::count(this->image.bad.begin(), this->image.bad.end(), 1); }

  const std::filesystem::path folder;
  Image image;
  ImageDescription description;
};
} // namespace

TEST(RegionList, ShapesHaveTheirPlaceAndArea)
{
  const double pi = std::acos(-1.0);
  for (const char* text :
    { "fk5;circle(202.47,47.195,10\")", "icrs\ncircle 202.47 47.195 0.002777777777777778",
      "J2000; circle(13:29:52.8,+47:11:42.0,0.16666666666667')",
      "FK5\ncircle(13h29m52.8s,+47d11m42s,5i) # text={a; b(c)}",
      "#CRTFv0\ncircle[[13h29m52.8s, 47.11.42.0], 10arcsec], color=red",
      "#CRTFv0\nglobal coord=ICRS\ncircle[[202.47deg, 47.195deg], 10arcsec]",
      "image\ncircle(51,51,5)", "circle(51,51,10\")" })
  {
    const PixelRegion region = only(text);
    EXPECT_NEAR(region.middle.x, 51, 1e-3) << text;
    EXPECT_NEAR(region.middle.y, 51, 1e-3) << text;
    EXPECT_NEAR(areaOf(region), pi * 25, 0.02) << text;
  }
  EXPECT_NEAR(areaOf(only("fk5;ellipse(202.47,47.195,20\",6\",30)")), pi * 10 * 3, 0.02);
  EXPECT_NEAR(areaOf(only("fk5;box(202.47,47.195,20\",6\",30)")), 30, 0.01);
  EXPECT_NEAR(areaOf(only("image;polygon(1,1,11,1,11,6)")), 25, 1e-9);
}

TEST(RegionList, AnglesTurnAsTheProgramsMean)
{
  // DS9 turns the first axis from the right, against the clock; CASA from the North.
  const double c = 9 * std::cos(0.5236), s = 9 * std::sin(0.5236);
  for (const char* text : { "image;ellipse(51,51,10,2,30)",
         "fk5;ellipse(202.47,47.195,20\",4\",30)", "image;box(51,51,20,4,30)",
         "#CRTF\nellipse[[202.47deg, 47.195deg], [20arcsec, 4arcsec], -60deg]",
         "#CRTF\nrotbox[[51pix, 51pix], [20pix, 4pix], 30deg]" })
  {
    const PixelRegion region = only(text);
    EXPECT_TRUE(region.contains({ 51 + c, 51 + s })) << text;
    EXPECT_TRUE(region.contains({ 51 - c, 51 - s })) << text;
    EXPECT_FALSE(region.contains({ 51 + c, 51 - s })) << text;
    EXPECT_FALSE(region.contains({ 51 + s, 51 + c })) << text;
  }
}

TEST(RegionList, CommentsAndSigns)
{
  const std::vector<PixelRegion> regions = parseRegions("# Region file format: DS9\n"
                                                        "global color=green width=1\n\n"
                                                        "image # a frame\n"
                                                        "circle(3,3,1); -circle(9,9,2)\r\n"
                                                        "+box(5,5,2,2,0)\n",
    "stars.reg", {});
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_FALSE(regions[0].excluded);
  EXPECT_TRUE(regions[1].excluded);
  EXPECT_FALSE(regions[2].excluded);
}

TEST(RegionList, PhysicalPixelsFollowTheHeader)
{
  RegionCanvas canvas;
  canvas.shift = { 0.5, 0.25 };
  canvas.scale = { 0.5, 0.5 };
  const PixelRegion region = parseRegions("physical\ncircle(41,61,4)", "s", canvas)[0];
  EXPECT_EQ(region.middle.x, 21);
  EXPECT_EQ(region.middle.y, 30.75);
  EXPECT_NEAR(areaOf(region), std::acos(-1.0) * 4, 1e-9);
}

TEST(RegionList, ErrorsNameTheLine)
{
  EXPECT_EQ(messageOf("image\n\nannulus(3,3,1,2)\n"),
    "stars.reg: line 3: 'annulus' is not a shape; use circle, ellipse, box or polygon");
  EXPECT_EQ(messageOf("image\ncircle(3,3)\n"),
    "stars.reg: line 2: circle with 2 numbers; give as many as DS9 or CASA write");
  EXPECT_EQ(messageOf("circle(3,x3,1)\n"), "stars.reg: line 1: 'x3' must be a number");
  EXPECT_EQ(messageOf("image;circle(3,3,-1)\n"),
    "stars.reg: line 1: a length must be at least 0, not '-1'");
  EXPECT_EQ(messageOf("# fine\nfk5;circle(3,3,1\")\n"),
    "stars.reg: line 2: sky coordinates need an image with celestial coordinates; use image "
    "pixels");
  EXPECT_NE(messageOf("wcsq\ncircle(3,3,1)\n").find("line 1"), std::string::npos);
  EXPECT_NE(messageOf("#CRTF\nglobal coord=SUPERGAL\n").find("line 2"), std::string::npos);
  for (const char* odd : { "(", ")", "circle", "circle(", "-", "+", ";;", "circle[[", "box()" })
  {
    EXPECT_EQ(messageOf(odd).rfind(odd[0] == ';' ? "" : "stars.reg: line 1: ", 0), 0u) << odd;
  }
}

TEST_F(BadPixelFiles, RegionsMarkTheirPixels)
{
  this->writeRegions("fk5\ncircle(202.47,47.195,10\")\n-box(202.47,47.195,4.2\",100\",0)\n"
                     "image\ncircle(20.2,30.4,0.1)\ncircle(-50,3,9)\ncircle(1,1,3)\n");
  markBadPixels(this->description, this->galaxyFile(), this->image);
  const auto at = [this](int x, int y) { return this->image.bad[(y - 1) * 101 + x - 1]; };
  EXPECT_EQ(at(55, 51), 1);
  EXPECT_EQ(at(57, 51), 0);
  EXPECT_EQ(at(51, 51), 0);
  EXPECT_EQ(at(20, 30), 1);
  EXPECT_EQ(at(21, 30), 0);
  EXPECT_EQ(at(1, 1), 1);
  EXPECT_EQ(at(101, 3), 0);
}

TEST_F(BadPixelFiles, MaskHasItsOwnCoordinates)
{
  // Half as large pixels, a square of 20 by 20 of them in the middle bad, one pixel blank.
  std::vector<float> mask(201 * 201, 0);
  for (int y = 90; y < 111; ++y)
  {
    std::fill_n(&mask[y * 201 + 90], 21, 5.0f);
  }
  mask[100 * 201 + 180] = std::nanf("");
  this->writeMask(201, 1, mask);
  markBadPixels(this->description, this->galaxyFile(), this->image);
  EXPECT_EQ(this->image.bad[50 * 101 + 50], 1);
  EXPECT_EQ(this->image.bad[50 * 101 + 90], 1);
  EXPECT_EQ(this->marked(), 11 * 11 + 1);
}

TEST_F(BadPixelFiles, MaskWithoutCoordinatesHasTheImagesSize)
{
  std::vector<float> mask(101 * 101, 0);
  mask[7] = -1;
  this->writeMask(101, 0, mask);
  markBadPixels(this->description, this->galaxyFile(), this->image);
  EXPECT_EQ(this->marked(), 1);
  EXPECT_EQ(this->image.bad[7], 1);
  this->writeMask(50, 0, mask);
  EXPECT_THROW(markBadPixels(this->description, this->galaxyFile(), this->image), Error);
  this->description.mask = "none.fits";
  EXPECT_THROW(markBadPixels(this->description, this->galaxyFile(), this->image), Error);
}

TEST_F(BadPixelFiles, NothingAskedForIsNothingMarked)
{
  markBadPixels(this->description, this->galaxyFile(), this->image);
  EXPECT_TRUE(this->image.bad.empty());
}
} // namespace galaxy
