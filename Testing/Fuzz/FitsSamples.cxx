#include "Testing/Fuzz/FitsSamples.h"

#include <fitsio.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>

namespace galaxy
{
namespace
{
using Fill = std::function<void(fitsfile*, int*)>;

std::string written(const std::string& folder, const Fill& fill)
{
  const std::string path = folder + "/sample.fits";
  std::filesystem::remove(path);
  fitsfile* file = nullptr;
  int status = 0;
  fits_create_diskfile(&file, path.c_str(), &status);
  fill(file, &status);
  fits_close_file(file, &status);
  std::ifstream in(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  std::filesystem::remove(path);
  if (status != 0 || bytes.empty())
  {
    throw std::runtime_error(
      "a sample could not be written, CFITSIO status " + std::to_string(status));
  }
  return bytes;
}

template <class Pixel>
void writeAs(fitsfile* file, int type, const std::vector<double>& values, int* status)
{
  std::vector<Pixel> pixels(values.begin(), values.end());
  fits_write_img(file, type, 1, static_cast<LONGLONG>(pixels.size()), pixels.data(), status);
}

void addImage(fitsfile* file, int bitpix, std::vector<long> axes, int* status)
{
  long pixels = 1;
  for (const long n : axes)
  {
    pixels *= n;
  }
  std::vector<double> values(static_cast<std::size_t>(pixels));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] =
      std::round(60 + 50 * std::sin(static_cast<double>(i / 20))) + (bitpix < 0 ? 0.25 : 0);
  }
  fits_create_img(file, bitpix, static_cast<int>(axes.size()), axes.data(), status);
  // CFITSIO compresses an image from pixels of its own type alone.
  switch (bitpix)
  {
    case BYTE_IMG:
      writeAs<unsigned char>(file, TBYTE, values, status);
      break;
    case SHORT_IMG:
      writeAs<short>(file, TSHORT, values, status);
      break;
    case LONG_IMG:
      writeAs<int>(file, TINT, values, status);
      break;
    default:
      writeAs<double>(file, TDOUBLE, values, status);
  }
}

void setSpectrum(fitsfile* file, const char* type, int* status)
{
  fits_update_key_str(file, "CTYPE1", "RA---SIN", nullptr, status);
  fits_update_key_str(file, "CTYPE2", "DEC--SIN", nullptr, status);
  fits_update_key_str(file, "CTYPE3", type, nullptr, status);
  fits_update_key_dbl(file, "CRVAL3", 1000, 10, nullptr, status);
  fits_update_key_dbl(file, "CDELT3", 5000, 10, nullptr, status);
  fits_update_key_dbl(file, "RESTFRQ", 1.42e9, 10, nullptr, status);
  fits_update_key_lng(file, "BLANK", 60, nullptr, status);
  fits_update_key_dbl(file, "BSCALE", 0.5, 10, nullptr, status);
}

void addTable(fitsfile* file, int* status)
{
  char name[] = "X";
  char form[] = "1PE";
  char* names[] = { name };
  char* forms[] = { form };
  fits_create_tbl(file, BINARY_TBL, 4, 1, names, forms, nullptr, nullptr, status);
}

std::string gzipped(const std::string& bytes)
{
  z_stream stream{};
  constexpr int gzipWindow = 15 + 16;
  deflateInit2(&stream, 9, Z_DEFLATED, gzipWindow, 8, Z_DEFAULT_STRATEGY);
  std::string packed(bytes.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}
} // namespace

std::vector<std::string> fitsSamples(const std::string& folder)
{
  std::vector<std::string> samples;
  for (const int bitpix :
    { BYTE_IMG, SHORT_IMG, USHORT_IMG, LONG_IMG, LONGLONG_IMG, FLOAT_IMG, DOUBLE_IMG })
  {
    samples.push_back(written(folder, [&](fitsfile* f, int* status) {
      addImage(f, bitpix, { 9, 7 }, status);
    }));
  }
  for (const char* type : { "VELO-LSR", "FREQ", "VOPT-F2W" })
  {
    samples.push_back(written(folder, [&](fitsfile* f, int* status) {
      addImage(f, SHORT_IMG, { 5, 4, 3, 2 }, status);
      setSpectrum(f, type, status);
    }));
  }
  samples.push_back(written(folder, [](fitsfile* f, int* status) {
    fits_create_img(f, BYTE_IMG, 0, nullptr, status);
    addTable(f, status);
    addImage(f, FLOAT_IMG, { 6, 5 }, status);
    fits_update_key_str(f, "EXTNAME", "SCI", nullptr, status);
  }));
  for (const int method : { RICE_1, GZIP_1, GZIP_2, HCOMPRESS_1, PLIO_1 })
  {
    for (const int bitpix : { BYTE_IMG, SHORT_IMG, LONG_IMG, FLOAT_IMG, DOUBLE_IMG })
    {
      const bool floats = bitpix < 0;
      if (floats && method == PLIO_1)
      {
        continue;
      }
      samples.push_back(written(folder, [&](fitsfile* f, int* status) {
        fits_set_compression_type(f, method, status);
        long tile[] = { 24, 6 };
        fits_set_tile_dim(f, 2, tile, status);
        fits_set_quantize_dither(f, floats ? SUBTRACTIVE_DITHER_1 : NO_DITHER, status);
        addImage(f, bitpix, { 24, 17 }, status);
      }));
    }
  }
  samples.push_back(gzipped(samples.front()));
  samples.push_back(gzipped(samples.back().substr(0, 40)));
  return samples;
}
} // namespace galaxy
