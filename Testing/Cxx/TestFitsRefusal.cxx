#include "FitsFixtures.h"

#include "Readers/Formats/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace
{
using FitsRefusal = galaxy::testing::FitsFolder;
using AsinhImage = galaxy::testing::FitsFolder;
using galaxy::testing::contains;
using galaxy::testing::messageOf;
using namespace std::string_literals;
} // namespace

TEST_F(FitsRefusal, OtherFilesAreNamed)
{
  const std::string filling(3000, '\x7f');
  const std::string tar = std::string(257, '\x01') + "ustar";
  for (const auto& [start, words] :
    { std::pair("BZh91AY&SY"s, "bunzip2"), { "\xfd"s + "7zXZ\0"s, "unxz" }, { "PK\3\4", "zip" },
      { "\x1f\x9d\x90", "uncompress" }, { "\x28\xb5\x2f\xfd", "zstd" },
      { "7z\xbc\xaf\x27\x1c", "7z" }, { tar, "tar" }, { "\x89HDF\r\n\x1a\n", "HDF5" },
      { "#ASDF 1.0.0\n", "ASDF" }, { "\x89PNG\r\n\x1a\n", "PNG" }, { "\xff\xd8\xff\xe0", "JPEG" },
      { "II*\0"s, "TIFF" }, { "MM\0*"s, "TIFF" }, { "GIF89a", "GIF" }, { "%PDF-1.5", "PDF" },
      { "\x93NUMPY", "NumPy" }, { "\n<!doctype html>\n<html>", "web page" },
      { "<html lang=en>", "web page" }, { "<?xml version='1.0'?>", "XML" },
      { "version https://git-lfs.github.com/spec", "git lfs" },
      { std::string(2880, '\0'), "zeros" } })
  {
    const std::string file = this->path("image.fits");
    std::ofstream(file, std::ios::binary) << start << filling;
    const std::string message = messageOf(file);
    EXPECT_EQ(message.find(file + ": not readable as FITS: it is "), 0u) << message;
    EXPECT_TRUE(contains(message, words)) << message;
  }
  std::ofstream(this->path("empty.fits"));
  EXPECT_TRUE(contains(messageOf(this->path("empty.fits")), "it is empty"));
  std::ofstream(this->path("text.fits")) << "Error 404: nothing here\nreally";
  EXPECT_TRUE(contains(messageOf(this->path("text.fits")), "'Error 404: nothing here'"));
}

TEST_F(FitsRefusal, WhatIsNoImage)
{
  const auto table = [](const char* extension, const char* keyword, const char* value) {
    return [=](fitsfile* f, int* status) {
      char name[] = "SIGNAL", form[] = "1E";
      char* names[] = { name };
      char* forms[] = { form };
      fits_create_img(f, BYTE_IMG, 0, nullptr, status);
      fits_create_tbl(f, BINARY_TBL, 48, 1, names, forms, nullptr, extension, status);
      fits_update_key_str(f, keyword, value, nullptr, status);
      fits_update_key_lng(f, "NSIDE", 2, nullptr, status);
    };
  };
  const std::string sky = this->write("sky.fits", table("xtension", "PIXTYPE", "HEALPIX"));
  const std::string message = messageOf(sky);
  EXPECT_TRUE(contains(message, "HDU 1 'xtension' is a HEALPix map (NSIDE = 2)")) << message;
  EXPECT_TRUE(contains(message, "; use reproject or healpy")) << message;
  galaxy::FitsSelection selection;
  selection.hdu = 1;
  EXPECT_TRUE(contains(messageOf(sky, selection), "it is a HEALPix map"));
  selection.extension = "SCI";
  EXPECT_TRUE(contains(messageOf(sky, selection), "choose from 'xtension'"));
  const std::string events = this->write("x.fits", table("EVENTS", "TELESCOP", "CHANDRA"));
  EXPECT_TRUE(contains(messageOf(events), "HDU 1 'EVENTS' is a list of events"));
  const std::string line = this->write("line.fits", [](fitsfile* f, int* status) {
    galaxy::testing::addImage(f, FLOAT_IMG, { 1, 2, 3 }, status, { 3 });
  });
  EXPECT_TRUE(contains(messageOf(line), "HDU 0 is of one axis"));
}

// Values 0.001 n + 2, so that the flux is BOFFSET + BSOFTEN (e^(v ln 10 / 2.5) - its inverse).
TEST_F(AsinhImage, IsMadeLinear)
{
  const std::string file = this->write("stack.fits", [](fitsfile* f, int* status) {
    long axes[] = { 2, 2 };
    short values[] = { 0, 1000, -2000, -32768 };
    fits_create_img(f, SHORT_IMG, 2, axes, status);
    fits_update_key_lng(f, "BLANK", -32768, nullptr, status);
    fits_write_img(f, TSHORT, 1, 4, values, status);
    fits_update_key_dbl(f, "BSCALE", 0.001, 10, nullptr, status);
    fits_update_key_dbl(f, "BZERO", 2, 10, nullptr, status);
    fits_update_key_dbl(f, "BSOFTEN", 120, 10, nullptr, status);
    fits_update_key_dbl(f, "BOFFSET", 35, 10, nullptr, status);
  });
  const galaxy::Image image = galaxy::readFitsImage(file);
  const auto flux = [](double v) {
    const double factor = std::pow(10, v / 2.5);
    return 35 + 120 * (factor - 1 / factor);
  };
  EXPECT_NEAR(image.values[0], flux(2), 1e-9);
  EXPECT_NEAR(image.values[1], flux(3), 1e-9);
  EXPECT_NEAR(image.values[2], 35, 1e-12);
  EXPECT_TRUE(std::isnan(image.values[3]));
  EXPECT_TRUE(contains(image.note, "BSOFTEN"));
}
