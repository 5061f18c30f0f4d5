#include "Readers/Formats/FitsTiles.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsHandle.h"
#include "Readers/Formats/FitsHdu.h"
#include "Readers/Formats/FitsRice.h"

#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace galaxy
{
namespace
{
// As many as CFITSIO has room for.
constexpr std::size_t mostAxes = 6;

/// How an image is cut into tiles, one a row of its table, the tiles along axis 1 first.
class Tiling
{
public:
  explicit Tiling(const FitsHdu& hdu)
    : axes(hdu.axes)
  {
    for (std::size_t i = 0; i < this->axes.size(); ++i)
    {
      const std::string keyword = fitsKeyword("ZTILE", i + 1);
      this->tile.push_back(hdu.header.text(keyword) ? hdu.header.integer(keyword).value_or(0)
                                                    : (i == 0 ? this->axes[0] : 1));
    }
  }

  /// Pixels of a whole tile, 0 where that is impossible or too many for CFITSIO's integers.
  long long largest() const
  {
    long long pixels = 1;
    for (const long long n : this->tile)
    {
      if (n < 1 || n > std::numeric_limits<int>::max() / pixels)
      {
        return 0;
      }
      pixels *= n;
    }
    return pixels;
  }
  long long count() const
  {
    long long product = 1;
    for (std::size_t i = 0; i < this->axes.size(); ++i)
    {
      if (__builtin_mul_overflow(product, this->along(i), &product))
      {
        return std::numeric_limits<long long>::max();
      }
    }
    return product;
  }
  /// Pixels of the tile of this row, from 0; those at the image's end are cut.
  long long pixels(long long row) const
  {
    long long product = 1;
    for (std::size_t i = 0; i < this->axes.size(); ++i)
    {
      const long long start = row % this->along(i) * this->tile[i];
      product *= std::min(this->tile[i], this->axes[i] - start);
      row /= this->along(i);
    }
    return product;
  }

private:
  long long along(std::size_t i) const { return (this->axes[i] - 1) / this->tile[i] + 1; }

  std::vector<long long> axes;
  std::vector<long long> tile;
};

void requireRange(const std::string& file, const FitsHdu& hdu, const std::string& keyword,
  long long lowest, long long highest)
{
  const long long value = hdu.header.integer(keyword).value_or(lowest - 1);
  if (hdu.header.text(keyword) && (value < lowest || value > highest))
  {
    throw DamagedFile(file, keyword,
      "no parameter of a compression: must be from " + std::to_string(lowest) + " to " +
        std::to_string(highest));
  }
}

bool isRice(const FitsHdu& hdu)
{
  return hdu.header.text("ZCMPTYPE").value_or("").compare(0, 4, "RICE") == 0;
}

/// The bytes of every tile in one column of the table.
class TileColumn
{
public:
  TileColumn(const FitsHandle& fits, const FitsHdu& hdu, const std::string& name, long long rows)
    : fits(fits)
    , name(name)
  {
    int status = 0;
    std::string pattern = name;
    fits_get_colnum(fits, CASEINSEN, pattern.data(), &this->column, &status);
    if (status == COL_NOT_FOUND)
    {
      fits_clear_errmsg();
      return;
    }
    int type = 0;
    fits_get_coltypell(fits, this->column, &type, nullptr, nullptr, &status);
    this->lengths.resize(static_cast<std::size_t>(rows));
    std::vector<LONGLONG> offsets(this->lengths.size());
    fits_read_descriptsll(
      fits, this->column, 1, rows, this->lengths.data(), offsets.data(), &status);
    fits.check(status, name);
    const long long width = elementWidth(-type);
    const long long heap = static_cast<fitsfile*>(fits)->Fptr->heapstart;
    const long long room = static_cast<long long>(hdu.dataBytes) - heap;
    for (std::size_t i = 0; i < offsets.size(); ++i)
    {
      if (offsets[i] < 0 || offsets[i] > room || this->lengths[i] < 0 ||
        this->lengths[i] > (room - offsets[i]) / width)
      {
        this->fail(i, "lies outside the table's heap");
      }
    }
  }

  std::size_t size() const { return this->lengths.size(); }
  /// Elements of a tile.
  long long length(std::size_t row) const { return this->lengths[row]; }

  /// Elements of a tile, from `first` counted from 0.
  std::vector<long> read(std::size_t row, long long first, long long count) const
  {
    std::vector<long> elements(static_cast<std::size_t>(count));
    int anyBlank = 0;
    int status = 0;
    fits_read_col(this->fits, TLONG, this->column, static_cast<LONGLONG>(row) + 1, first + 1, count,
      nullptr, elements.data(), &anyBlank, &status);
    this->fits.check(status, this->name);
    return elements;
  }

  std::vector<unsigned char> readBytes(std::size_t row) const
  {
    std::vector<unsigned char> bytes(static_cast<std::size_t>(this->lengths[row]));
    int anyBlank = 0;
    int status = 0;
    fits_read_col(this->fits, TBYTE, this->column, static_cast<LONGLONG>(row) + 1, 1,
      static_cast<LONGLONG>(bytes.size()), nullptr, bytes.data(), &anyBlank, &status);
    this->fits.check(status, this->name);
    return bytes;
  }

  [[noreturn]] void fail(std::size_t row, const std::string& what) const
  {
    throw DamagedFile(this->fits.file, this->name, "tile " + std::to_string(row + 1) + " " + what);
  }

private:
  static int elementWidth(int type)
  {
    return type == TBYTE ? 1 : type == TSHORT ? 2 : type == TLONG || type == TFLOAT ? 4 : 8;
  }

  const FitsHandle& fits;
  const std::string name;
  int column = 0;
  std::vector<LONGLONG> lengths;
};

/// The big-endian number of these bytes.
template <class Iterator>
long long joined(Iterator begin, Iterator end)
{
  long long number = 0;
  for (; begin != end; ++begin)
  {
    number = number << 8 | (*begin & 0xff);
  }
  return number;
}

/// The number of bytes that a gzip stream unpacks to, -1 where it is broken or they are more than
/// `most`.
long long unpackedBytes(std::vector<unsigned char> packed, long long most)
{
  constexpr int gzipWindow = 15 + 16;
  std::vector<unsigned char> out(static_cast<std::size_t>(most) + 1);
  z_stream stream{};
  if (packed.size() > std::numeric_limits<uInt>::max() ||
    out.size() > std::numeric_limits<uInt>::max() || inflateInit2(&stream, gzipWindow) != Z_OK)
  {
    return -1;
  }
  stream.next_in = packed.data();
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  const int code = inflate(&stream, Z_FINISH);
  const auto bytes = static_cast<long long>(stream.total_out);
  inflateEnd(&stream);
  return code == Z_STREAM_END ? bytes : -1;
}

/// CFITSIO never comes to the end of some broken streams.
void checkGzipTile(
  const TileColumn& column, std::size_t row, long long pixels, const std::vector<int>& widths)
{
  const long long bytes =
    unpackedBytes(column.readBytes(row), pixels * *std::max_element(widths.begin(), widths.end()));
  if (std::none_of(
        widths.begin(), widths.end(), [=](int width) { return bytes == pixels * width; }))
  {
    column.fail(row, "does not unpack to its pixels");
  }
}

void checkHcompressTile(const TileColumn& column, std::size_t row, long long pixels)
{
  constexpr long long header = 25;
  if (column.length(row) < header)
  {
    column.fail(row, "is shorter than any HCOMPRESS stream");
  }
  const std::vector<long> start = column.read(row, 0, header);
  const long long nx = joined(start.begin() + 2, start.begin() + 6);
  const long long ny = joined(start.begin() + 6, start.begin() + 10);
  if (nx < 1 || ny < 1 || nx > pixels || nx * ny != pixels)
  {
    column.fail(row, "does not unpack to its pixels");
  }
}

void checkRiceTile(const TileColumn& column, std::size_t row, long long pixels, const FitsHdu& hdu)
{
  const std::vector<unsigned char> bytes = column.readBytes(row);
  // What CFITSIO takes where the header does not say.
  const long long blockSize = hdu.header.integer("ZVAL1").value_or(32);
  const long long pixelBytes = hdu.header.integer("ZVAL2").value_or(4);
  if (!riceStreamHolds(std::string(bytes.begin(), bytes.end()), pixels, pixelBytes, blockSize))
  {
    column.fail(row, "ends before its last pixel");
  }
}

/// The line list of IRAF begins with its own length, in either of two forms of header.
void checkPlioTile(const TileColumn& column, std::size_t row)
{
  constexpr long long shortHeader = 3;
  constexpr long long longHeader = 7;
  const long long words = column.length(row);
  if (words < longHeader)
  {
    column.fail(row, "is shorter than any PLIO line list");
  }
  const std::vector<long> start = column.read(row, 0, longHeader);
  const bool isShort = start[2] > 0;
  const long long length = isShort ? start[2] : start[4] * 32768 + start[3];
  const long long first = isShort ? shortHeader : start[1];
  if (first < shortHeader || length < 0 || length > words)
  {
    column.fail(row, "is longer than its bytes");
  }
}
/// Floats are packed as they are by GZIP alone; any other method packs the integers, of 32 bits,
/// that ZSCALE quantises them to.
void checkQuantisation(const std::string& file, const FitsHdu& hdu)
{
  const std::string method = hdu.header.text("ZCMPTYPE").value_or("");
  if (hdu.bitpix > 0 || method.compare(0, 4, "GZIP") == 0)
  {
    return;
  }
  bool scaled = hdu.header.text("ZSCALE").has_value();
  const long long columns = hdu.header.integer("TFIELDS").value_or(0);
  for (long long i = 1; i <= columns; ++i)
  {
    const std::string keyword = fitsKeyword("TTYPE", static_cast<std::size_t>(i));
    scaled = scaled || upperCase(hdu.header.text(keyword).value_or("")) == "ZSCALE";
  }
  if (!scaled || hdu.header.text("ZQUANTIZ").value_or("") == "NONE" ||
    (isRice(hdu) && hdu.header.integer("ZVAL2").value_or(4) != 4))
  {
    throw DamagedFile(
      file, "ZQUANTIZ", "floats that are not quantised are compressed by GZIP alone");
  }
}

} // namespace

void checkTileParameters(const std::string& file, const FitsHdu& hdu)
{
  const std::string repeated = hdu.header.repeated("Z");
  if (!repeated.empty())
  {
    throw DamagedFile(file, repeated, "stands more than once in the header of a compressed image");
  }
  if (hdu.axes.size() > mostAxes || hdu.bitpix == LONGLONG_IMG)
  {
    throw Error(file, hdu.bitpix == LONGLONG_IMG ? "ZBITPIX" : "ZNAXIS",
      "tile-compressed 64-bit integers and images of more than 6 axes cannot be read; unpack the "
      "image first, with funpack");
  }
  if (!hdu.isImage())
  {
    return;
  }
  const Tiling tiling(hdu);
  if (tiling.largest() == 0)
  {
    throw DamagedFile(file, "ZTILE", "the header promises impossible tiles");
  }
  if (tiling.count() > hdu.header.integer("NAXIS2").value_or(0))
  {
    throw DamagedFile(
      file, "NAXIS2", "the table of the compressed image has fewer rows than tiles");
  }
  if (isRice(hdu))
  {
    requireRange(file, hdu, "ZVAL1", 1, 1024);
    requireRange(file, hdu, "ZVAL2", 1, 8);
  }
  requireRange(file, hdu, "ZDITHER0", 1, 10000);
  checkQuantisation(file, hdu);
}

void checkTiles(const FitsHandle& fits, const FitsHdu& hdu)
{
  const Tiling tiling(hdu);
  const std::string method = hdu.header.text("ZCMPTYPE").value_or("");
  const int width = std::abs(hdu.bitpix) / 8;
  // Integers may be packed in any size; floats are packed as they are, or as 32-bit integers.
  const std::vector<int> widths =
    hdu.bitpix > 0 ? std::vector<int>{ 1, 2, 4 } : std::vector<int>{ 4, width };
  const auto tiles = [&](const char* name, auto check) {
    const TileColumn column(fits, hdu, name, tiling.count());
    for (std::size_t row = 0; row < column.size(); ++row)
    {
      if (column.length(row) > 0)
      {
        check(column, row, tiling.pixels(static_cast<long long>(row)));
      }
    }
  };
  tiles("COMPRESSED_DATA", [&](const TileColumn& column, std::size_t row, long long pixels) {
    if (method.compare(0, 4, "GZIP") == 0)
    {
      checkGzipTile(column, row, pixels, widths);
    }
    else if (isRice(hdu))
    {
      checkRiceTile(column, row, pixels, hdu);
    }
    else if (method == "HCOMPRESS_1")
    {
      checkHcompressTile(column, row, pixels);
    }
    else if (method == "PLIO_1")
    {
      checkPlioTile(column, row);
    }
  });
  tiles("GZIP_COMPRESSED_DATA", [&](const TileColumn& column, std::size_t row, long long pixels) {
    checkGzipTile(column, row, pixels, { width });
  });
  tiles("UNCOMPRESSED_DATA", [&](const TileColumn& column, std::size_t row, long long pixels) {
    if (column.length(row) != pixels)
    {
      column.fail(row, "does not have its pixels");
    }
  });
}
} // namespace galaxy
