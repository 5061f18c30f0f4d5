#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsFile.h"

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
/// A folder of FITS files that is gone after the test.
class FitsFile : public ::testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "galaxy-fits-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    this->folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(this->folder); }

  std::string path(const std::string& name) const { return (this->folder / name).string(); }

  /// Writes a file through CFITSIO; `fill` does the rest after its creation.
  std::string write(const std::string& name, const std::function<void(fitsfile*, int*)>& fill) const
  {
    fitsfile* file = nullptr;
    int status = 0;
    fits_create_diskfile(&file, this->path(name).c_str(), &status);
    fill(file, &status);
    fits_close_file(file, &status);
    EXPECT_EQ(status, 0) << name;
    return this->path(name);
  }

  std::filesystem::path folder;
};

constexpr long width = 3, height = 2;

/// An image of these values in HDU order, stored as they are.
void addImage(fitsfile* file, int bitpix, std::vector<double> values, int* status,
  std::vector<long> axes = { width, height })
{
  fits_create_img(file, bitpix, static_cast<int>(axes.size()), axes.data(), status);
  fits_write_img(file, TDOUBLE, 1, static_cast<LONGLONG>(values.size()), values.data(), status);
}

std::string messageOf(const std::string& file, const FitsSelection& selection = {})
{
  try
  {
    readFitsImage(file, selection);
  }
  catch (const galaxy::Error& error)
  {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
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
  EXPECT_TRUE(contains(messageOf(this->folder.string()), "no such file"));
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
  EXPECT_EQ(messageOf(table), table + ": holds no image of two or more axes");
}
