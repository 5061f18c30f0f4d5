#include "Readers/Formats/FitsFile.h"
#include "Testing/Cxx/FitsFixtures.h"

#include <fitsio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

using galaxy::Image;
using galaxy::readFitsImage;

namespace
{
using galaxy::testing::addImage;
using galaxy::testing::contains;
using galaxy::testing::messageOf;

constexpr long side = 40;
constexpr double blankValue = -1e9; // written as a blank pixel

std::vector<double> waves()
{
  std::vector<double> values(side * side);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = std::round(100 + 90 * std::sin(static_cast<double>(i) / 7));
  }
  return values;
}

/// Tile-compressed images, and what becomes of them where their bytes are changed.
class FitsTiles : public galaxy::testing::FitsFolder
{
protected:
  std::string compressed(int method, int bitpix, const std::vector<double>& values) const
  {
    const std::string name =
      "tiles" + std::to_string(method) + "_" + std::to_string(bitpix) + ".fits";
    return this->write(name, [&](fitsfile* f, int* status) {
      fits_set_compression_type(f, method, status);
      if (bitpix < 0)
      {
        fits_set_quantize_dither(f, SUBTRACTIVE_DITHER_2, status);
        fits_set_quantize_level(f, 16, status);
      }
      long axes[] = { side, side };
      fits_create_img(f, bitpix, 2, axes, status);
      std::vector<double> copy = values;
      double blank = blankValue;
      fits_write_imgnull(f, TDOUBLE, 1, side * side, copy.data(), &blank, status);
    });
  }

  /// The file again, with `change` done to its bytes.
  template <class Change>
  std::string changed(const std::string& file, const Change& change) const
  {
    std::ifstream in(file, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    change(bytes);
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }

  /// The file again, with another value on a card.
  std::string withValue(
    const std::string& file, const std::string& keyword, const std::string& value) const
  {
    return this->changed(file, [&](std::string& bytes) {
      std::string card = keyword;
      card.resize(8, ' ');
      const std::size_t at = bytes.find(card + "= ");
      ASSERT_NE(at, std::string::npos);
      bytes.replace(at + 10, 20, std::string(20 - value.size(), ' ') + value);
    });
  }
};
} // namespace

TEST_F(FitsTiles, QuantisedFloatsWithDitherKeepBlanksAndZeros)
{
  std::vector<double> values = waves();
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] += 0.37 * std::sin(static_cast<double>(i * i));
  }
  values[50] = blankValue;
  values[60] = 0;
  for (const int bitpix : { FLOAT_IMG, DOUBLE_IMG })
  {
    for (const int method : { RICE_1, GZIP_1, GZIP_2 })
    {
      const Image image = readFitsImage(this->compressed(method, bitpix, values));
      EXPECT_TRUE(std::isnan(image.values[50])) << method;
      EXPECT_EQ(image.values[60], 0) << "dither 2 keeps zeros";
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_EQ(std::isnan(image.values[i]), i == 50);
        EXPECT_TRUE(i == 50 || std::abs(image.values[i] - values[i]) < 1) << i;
      }
      if (bitpix == FLOAT_IMG)
      {
        EXPECT_EQ(image.values[7], static_cast<float>(image.values[7])) << "a float stays one";
      }
    }
  }
}

// CFITSIO divides by the block size, and takes a dither's seed for an index.
TEST_F(FitsTiles, ImpossibleParametersAreRefused)
{
  for (const std::string value : { "0", "-1", "1.5", "'a'" })
  {
    const std::string file =
      this->withValue(this->compressed(RICE_1, LONG_IMG, waves()), "ZVAL1", value);
    EXPECT_TRUE(contains(messageOf(file), "ZVAL1")) << value << messageOf(file);
    std::filesystem::remove(file);
  }
  const auto message = [this](int bitpix, const std::string& keyword, const std::string& value) {
    const std::string file =
      this->withValue(this->compressed(GZIP_2, bitpix, waves()), keyword, value);
    const std::string text = messageOf(file);
    std::filesystem::remove(file);
    return text;
  };
  EXPECT_TRUE(contains(message(LONG_IMG, "ZTILE1", "0"), "impossible tiles"));
  EXPECT_TRUE(contains(message(LONG_IMG, "ZTILE2", "4294967296"), "impossible tiles"));
  EXPECT_TRUE(contains(message(LONG_IMG, "ZTILE1", "1"), "fewer rows than tiles"));
  EXPECT_TRUE(contains(message(LONG_IMG, "ZNAXIS2", "41"), "fewer rows than tiles"));
  EXPECT_TRUE(contains(message(LONG_IMG, "ZNAXIS1", "0"), "no image"));
  EXPECT_TRUE(contains(message(LONG_IMG, "PCOUNT", "99999999"), "truncated"));
  EXPECT_TRUE(contains(message(LONG_IMG, "PCOUNT", "1"), "outside the table's heap"));
}

// An HCOMPRESS stream says its own size, which CFITSIO writes into a buffer of the header's.
TEST_F(FitsTiles, TileThatUnpacksToMoreThanItsPixelsIsRefused)
{
  const std::string file =
    this->changed(this->compressed(HCOMPRESS_1, LONG_IMG, waves()), [](std::string& bytes) {
      const std::size_t at = bytes.find("\xdd\x99");
      ASSERT_NE(at, std::string::npos);
      bytes[at + 3] = 64; // nx from 40 to over four million
    });
  EXPECT_TRUE(contains(messageOf(file), "tile 1 does not unpack to its pixels")) << messageOf(file);
}

// CFITSIO would look for the next set bit beyond the stream's end, and unpack without one.
TEST_F(FitsTiles, StreamThatEndsBeforeItsPixelsIsRefused)
{
  const std::string rice =
    this->changed(this->compressed(RICE_1, LONG_IMG, waves()), [](std::string& bytes) {
      const std::size_t heap = bytes.size() - 2880 + side * 8;
      std::fill(bytes.begin() + static_cast<long>(heap) + 8, bytes.end(), '\0');
    });
  EXPECT_TRUE(contains(messageOf(rice), "ends before its last pixel")) << messageOf(rice);
  const std::string gzip =
    this->changed(this->compressed(GZIP_1, LONG_IMG, waves()), [](std::string& bytes) {
      bytes[bytes.find("\x1f\x8b\x08") + 3] = 8; // a name that does not end
    });
  EXPECT_TRUE(contains(messageOf(gzip), "does not unpack to its pixels")) << messageOf(gzip);
}

TEST_F(FitsTiles, MessagesOfCfitsioStandOnce)
{
  const std::string file =
    this->withValue(this->compressed(GZIP_1, LONG_IMG, waves()), "TFORM1", "'1Z'");
  const std::string message = messageOf(file);
  ASSERT_TRUE(contains(message, "TFORM")) << message;
  std::set<std::string> parts;
  std::size_t count = 0;
  for (std::istringstream stream(message); stream.good(); ++count)
  {
    std::string part;
    std::getline(stream, part, ';');
    parts.insert(part);
  }
  EXPECT_EQ(parts.size(), count) << message;
  EXPECT_EQ(messageOf(file), message) << "no message of the first reading is left for the second";
}
