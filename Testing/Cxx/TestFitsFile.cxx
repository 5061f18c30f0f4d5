#include "Readers/Formats/FitsFile.h"
#include "Testing/Cxx/FitsFixtures.h"

#include <fitsio.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>

using galaxy::FitsSelection;
using galaxy::Image;
using galaxy::readFitsImage;

namespace
{
using FitsFile = galaxy::testing::FitsFolder;
using galaxy::testing::addImage;
using galaxy::testing::contains;
using galaxy::testing::height;
using galaxy::testing::messageOf;
using galaxy::testing::width;
} // namespace

TEST_F(FitsFile, EveryBitpix)
{
  const std::vector<double> values = { 0, 1, 2, 3, 100, 127 };
  for (const int bitpix : { BYTE_IMG, SBYTE_IMG, SHORT_IMG, USHORT_IMG, LONG_IMG, ULONG_IMG,
         LONGLONG_IMG, FLOAT_IMG, DOUBLE_IMG })
  {
    const std::string name = "bitpix" + std::to_string(bitpix) + ".fits";
    const Image image = readFitsImage(
      this->write(name, [&](fitsfile* f, int* status) { addImage(f, bitpix, values, status); }));
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.values, values) << "BITPIX " << bitpix;
    EXPECT_EQ(image.at(1, 1), 100);
  }
}

TEST_F(FitsFile, ScaleZeroBlankAndUnit)
{
  const Image image = readFitsImage(this->write("scaled.fits", [](fitsfile* f, int* status) {
    addImage(f, SHORT_IMG, { 0, 1, 2, -32768, 4, 5 }, status);
    fits_update_key_dbl(f, "BSCALE", 0.5, 10, nullptr, status);
    fits_update_key_dbl(f, "BZERO", 100, 10, nullptr, status);
    fits_update_key_lng(f, "BLANK", -32768, nullptr, status);
    fits_update_key_str(f, "BUNIT", "MJy/sr", nullptr, status);
  }));
  EXPECT_EQ(image.values[1], 100.5);
  EXPECT_EQ(image.values[5], 102.5);
  EXPECT_TRUE(std::isnan(image.values[3]));
  EXPECT_EQ(image.unit, "MJy/sr");
}

TEST_F(FitsFile, InfinityIsBlank)
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  for (const int bitpix : { FLOAT_IMG, DOUBLE_IMG })
  {
    const std::string name = "inf" + std::to_string(bitpix) + ".fits";
    const Image image = readFitsImage(this->write(name, [&](fitsfile* f, int* status) {
      addImage(f, bitpix, { 1, inf, -inf, std::nan(""), 2, 3 }, status);
    }));
    EXPECT_TRUE(std::isnan(image.values[1]) && std::isnan(image.values[2]));
    EXPECT_TRUE(std::isnan(image.values[3]));
    EXPECT_EQ(image.values[4], 2);
  }
}

TEST_F(FitsFile, CardsOfEightyCharactersWithoutEnd)
{
  const Image image = readFitsImage(this->write("cards.fits", [](fitsfile* f, int* status) {
    addImage(f, FLOAT_IMG, std::vector<double>(6), status);
    fits_write_history(f, "made for a test", status);
  }));
  EXPECT_EQ(image.cards.size() % 80, 0u);
  EXPECT_EQ(image.cards.compare(0, 9, "SIMPLE  ="), 0);
  const std::size_t history = image.cards.find("HISTORY made for a test");
  ASSERT_NE(history, std::string::npos);
  EXPECT_EQ(history % 80, 0u);
  EXPECT_FALSE(contains(image.cards, "END     "));
}

TEST_F(FitsFile, HduByNumberAndName)
{
  const std::string file = this->write("hdus.fits", [](fitsfile* f, int* status) {
    fits_create_img(f, BYTE_IMG, 0, nullptr, status);
    addImage(f, FLOAT_IMG, { 7 }, status, { 1 });
    addImage(f, FLOAT_IMG, std::vector<double>(6, 2), status);
    addImage(f, FLOAT_IMG, std::vector<double>(6, 3), status);
    fits_update_key_str(f, "EXTNAME", "R BAND", nullptr, status);
  });
  EXPECT_EQ(readFitsImage(file).values[0], 2) << "the first image of two axes";
  FitsSelection selection;
  selection.hdu = 3;
  EXPECT_EQ(readFitsImage(file, selection).values[0], 3);
  selection.hdu = 2;
  selection.extension = "R BAND";
  EXPECT_EQ(readFitsImage(file, selection).values[0], 3) << "the name wins";
  selection.extension = "nobody";
  EXPECT_TRUE(contains(messageOf(file, selection), "extension 'nobody'"));
  selection = {};
  selection.hdu = 9;
  EXPECT_TRUE(contains(messageOf(file, selection), "HDU 9"));
  selection.hdu = 0;
  EXPECT_TRUE(contains(messageOf(file, selection), "HDU 0: holds no image of two or more axes"));
}

TEST_F(FitsFile, PlanesOverAllFurtherAxes)
{
  std::vector<double> values(width * height * 4 * 5);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<double>(i);
  }
  const std::string file = this->write("cube.fits", [&](fitsfile* f, int* status) {
    addImage(f, LONG_IMG, values, status, { 3, 2, 4, 5 });
  });
  FitsSelection selection;
  for (int plane = 0; plane < 20; ++plane)
  {
    selection.plane = plane;
    EXPECT_EQ(readFitsImage(file, selection).at(0, 0), plane * width * height);
    EXPECT_EQ(readFitsImage(file, selection).at(2, 1), plane * width * height + 5);
  }
  selection.plane = 20;
  EXPECT_TRUE(contains(messageOf(file, selection), "20 planes"));
  selection.plane = -1;
  EXPECT_TRUE(contains(messageOf(file, selection), "20 planes"));
}

TEST_F(FitsFile, TileCompressed)
{
  for (const int method : { RICE_1, GZIP_1, GZIP_2, HCOMPRESS_1, PLIO_1 })
  {
    std::vector<double> values(40 * 30);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = static_cast<double>(i * 7 % 100);
    }
    const std::string name = "tiled" + std::to_string(method) + ".fits.fz";
    const Image image = readFitsImage(this->write(name, [&](fitsfile* f, int* status) {
      fits_set_compression_type(f, method, status);
      addImage(f, LONG_IMG, values, status, { 40, 30 });
    }));
    EXPECT_EQ(image.values, values) << "method " << method;
    EXPECT_TRUE(contains(image.cards, "NAXIS1  =                   40"));
  }
}

TEST_F(FitsFile, Gzipped)
{
  this->write("plain.fits", [](fitsfile* f, int* status) {
    addImage(f, LONG_IMG, { 1, 2, 3, 4, 5, 6 }, status);
  });
  fitsfile* in = nullptr;
  fitsfile* out = nullptr;
  int status = 0;
  fits_open_diskfile(&in, this->path("plain.fits").c_str(), READONLY, &status);
  fits_create_file(&out, this->path("small.fits.gz").c_str(), &status);
  fits_copy_file(in, out, 1, 1, 1, &status);
  fits_close_file(in, &status);
  fits_close_file(out, &status);
  ASSERT_EQ(status, 0);
  std::ifstream stream(this->path("small.fits.gz"), std::ios::binary);
  ASSERT_EQ(stream.get(), 0x1f) << "gzip's magic number";
  EXPECT_EQ(readFitsImage(this->path("small.fits.gz")).at(2, 1), 6);
  EXPECT_NE(messageOf(this->path("small.fits")), "") << "no other file in place of a missing one";
}

TEST_F(FitsFile, PathIsLiteral)
{
  const std::string file = this->write("odd[1:2,1:1] +1 (x).fits", [](fitsfile* f, int* status) {
    addImage(f, LONG_IMG, { 1, 2, 3, 4, 5, 6 }, status);
  });
  EXPECT_EQ(readFitsImage(file).width, width);
}

TEST_F(FitsFile, TruncatedIsNeverHalfAnImage)
{
  const std::string file = this->write("big.fits", [](fitsfile* f, int* status) {
    addImage(f, DOUBLE_IMG, std::vector<double>(100 * 100, 1), status, { 100, 100 });
  });
  for (const std::uintmax_t size : { 2880 + 79999, 2880 + 40000, 2880 })
  {
    std::filesystem::resize_file(file, size);
    EXPECT_TRUE(contains(messageOf(file), "truncated")) << messageOf(file);
  }
  std::filesystem::resize_file(file, 2000);
  EXPECT_TRUE(contains(messageOf(file), file + ": not readable as FITS: "));
}

// A header alone, promising 2^31 by 2^31 pixels.
TEST_F(FitsFile, AbsurdSizeIsRefused)
{
  const std::string file = this->write("huge.fits",
    [](fitsfile* f, int* status) { addImage(f, DOUBLE_IMG, std::vector<double>(6), status); });
  std::string text;
  {
    std::ifstream in(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(in), {});
  }
  for (const std::string axis : { "NAXIS1  = ", "NAXIS2  = " })
  {
    text.replace(text.find(axis) + 10, 20, "          2147483647");
  }
  std::ofstream(this->path("absurd.fits"), std::ios::binary) << text;
  EXPECT_TRUE(contains(messageOf(this->path("absurd.fits")), "NAXIS"));
}

TEST_F(FitsFile, NothingToRead)
{
  EXPECT_TRUE(contains(messageOf(this->path("missing.fits")), "no such file"));
  EXPECT_TRUE(contains(messageOf(this->folder.string()), "is a folder, must be a file"));
  std::ofstream(this->path("empty.fits"));
  EXPECT_TRUE(contains(messageOf(this->path("empty.fits")), "not readable as FITS: "));
  std::ofstream(this->path("text.fits")) << "I am\nnot FITS\n" << std::string(5000, 'x');
  const std::string message = messageOf(this->path("text.fits"));
  EXPECT_TRUE(contains(message, "not readable as FITS: "));
  EXPECT_FALSE(contains(message, "\n")) << "one line";
  const std::string table = this->write("table.fits", [](fitsfile* f, int* status) {
    char name[] = "X", form[] = "1E";
    char* names[] = { name };
    char* forms[] = { form };
    fits_create_tbl(f, BINARY_TBL, 4, 1, names, forms, nullptr, nullptr, status);
  });
  EXPECT_EQ(messageOf(table),
    table + ": holds no image of two or more axes: HDU 1 is a table; choose another file");
}

TEST_F(FitsFile, ExtremesOfEveryTypeAreExact)
{
  const std::string integers = this->write("integers.fits", [](fitsfile* f, int* status) {
    long axes[] = { 3, 1 };
    fits_create_img(f, LONGLONG_IMG, 2, axes, status);
    LONGLONG values[] = { std::numeric_limits<LONGLONG>::min(), 9007199254740993,
      std::numeric_limits<LONGLONG>::max() };
    fits_write_img(f, TLONGLONG, 1, 3, values, status);
  });
  EXPECT_EQ(readFitsImage(integers).values,
    (std::vector<double>{ -9223372036854775808., 9007199254740992., 9223372036854775808. }));
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double smallestFloat = std::numeric_limits<float>::denorm_min();
  const std::string doubles = this->write("doubles.fits", [=](fitsfile* f, int* status) {
    addImage(f, DOUBLE_IMG, { smallest, -0.0, 1e308 }, status, { 3, 1 });
    addImage(f, FLOAT_IMG, { smallestFloat, -0.0, -smallestFloat }, status, { 3, 1 });
  });
  FitsSelection selection;
  EXPECT_EQ(readFitsImage(doubles, selection).values, (std::vector<double>{ smallest, 0, 1e308 }));
  EXPECT_TRUE(std::signbit(readFitsImage(doubles, selection).values[1]));
  selection.hdu = 1;
  EXPECT_EQ(readFitsImage(doubles, selection).values,
    (std::vector<double>{ smallestFloat, 0, -smallestFloat }));
}

TEST_F(FitsFile, MaskValuesInTheImagesOwnPrecision)
{
  FitsSelection selection;
  selection.maskValues = { -99.9, 0 };
  for (const int bitpix : { FLOAT_IMG, DOUBLE_IMG })
  {
    const std::string name = "mask" + std::to_string(bitpix) + ".fits";
    const Image image = readFitsImage(this->write(name,
                                        [&](fitsfile* f, int* status) {
                                          addImage(f, bitpix, { 1, -99.9, 0, -0.0, 2, 3 }, status);
                                        }),
      selection);
    EXPECT_TRUE(std::isnan(image.values[1]) && std::isnan(image.values[2]));
    EXPECT_TRUE(std::isnan(image.values[3]));
    EXPECT_EQ(image.values[4], 2);
  }
  // A sentinel of a wide integer is that number alone.
  selection.maskValues = { -2147483647 };
  const Image image =
    readFitsImage(this->write("sentinel.fits",
                    [](fitsfile* f, int* status) {
                      addImage(f, LONG_IMG, { -2147483647, -2147483646, 0, 1, 2, 3 }, status);
                    }),
      selection);
  EXPECT_TRUE(std::isnan(image.values[0]));
  EXPECT_EQ(image.values[1], -2147483646);
}

TEST_F(FitsFile, BrokenGzipIsNeverHalfAnImage)
{
  const std::string plain = this->write("whole.fits", [](fitsfile* f, int* status) {
    std::vector<double> values(10000);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = std::sin(static_cast<double>(i));
    }
    addImage(f, DOUBLE_IMG, values, status, { 100, 100 });
  });
  ASSERT_EQ(std::system(("gzip -k '" + plain + "'").c_str()), 0);
  const std::string packed = plain + ".gz";
  EXPECT_EQ(readFitsImage(packed).values, readFitsImage(plain).values);
  const std::uintmax_t size = std::filesystem::file_size(packed);
  {
    std::fstream stream(packed, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(static_cast<std::streamoff>(size) - 6); // the checksum
    stream << 'x';
  }
  EXPECT_TRUE(contains(messageOf(packed), "gzip stream is broken")) << messageOf(packed);
  std::filesystem::resize_file(packed, size / 2);
  EXPECT_TRUE(contains(messageOf(packed), "truncated")) << messageOf(packed);
}

TEST_F(FitsFile, UnpackingTellsItsProgressAndEnds)
{
  const std::string plain = this->write("large.fits", [](fitsfile* f, int* status) {
    std::vector<double> values(1000 * 600);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = std::sin(static_cast<double>(i));
    }
    addImage(f, DOUBLE_IMG, values, status, { 1000, 600 });
  });
  ASSERT_EQ(std::system(("gzip -1 '" + plain + "'").c_str()), 0);
  std::vector<double> fractions;
  readFitsImage(plain + ".gz", {}, [&fractions](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1);
  EXPECT_GT(std::count_if(fractions.begin(), fractions.end(), [](double f) { return f < 0.5; }), 2);
  EXPECT_THROW(readFitsImage(plain + ".gz", {}, [](double fraction) { return fraction < 0.3; }),
    galaxy::Aborted);
}
