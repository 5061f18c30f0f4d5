#include "Readers/Formats/FitsFile.h"

#include "Readers/Formats/Error.h"

#include <fitsio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <new>

namespace galaxy
{
namespace
{
// No tile compression of the FITS standard packs more pixels into a byte (an empty HCOMPRESS tile
// comes closest): a header that promises more lies, and is refused before memory is asked for.
constexpr LONGLONG maximumPixelsPerByte = 16384;
constexpr int maximumAxes = 99;

/// CFITSIO's word for the status, followed by its message stack, which is emptied.
std::string takeMessages(int status)
{
  char line[FLEN_ERRMSG];
  fits_get_errstatus(status, line);
  std::string messages = line;
  while (fits_read_errmsg(line))
  {
    messages += std::string("; ") + line;
  }
  // The messages quote the file, which may be anything.
  std::replace_if(
    messages.begin(), messages.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return messages;
}

/// An open FITS file; closes itself.
class FitsHandle
{
public:
  explicit FitsHandle(const std::string& file)
    : file(file)
  {
    // CFITSIO would try other endings for a missing file and read `~`, `-` and leading blanks in
    // its own way: an absolute path to a file that exists means only itself.
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
    {
      throw Error(file, "", "no such file");
    }
    const std::string path = std::filesystem::absolute(file).string();
    if (path.size() >= FLEN_FILENAME)
    {
      throw Error(file, "", "the path is longer than CFITSIO can take");
    }
    fits_clear_errmsg();
    int status = 0;
    fits_open_diskfile(&this->handle, path.c_str(), READONLY, &status);
    if (status != 0)
    {
      this->handle = nullptr;
      throw Error(file, "", "not readable as FITS: " + takeMessages(status));
    }
  }
  ~FitsHandle()
  {
    int status = 0;
    fits_close_file(this->handle, &status);
    fits_clear_errmsg();
  }
  FitsHandle(const FitsHandle&) = delete;
  FitsHandle& operator=(const FitsHandle&) = delete;

  operator fitsfile*() const { return this->handle; }

  /// Throws where `status` is an error.
  void check(int status, const std::string& where) const
  {
    if (status != 0)
    {
      throw Error(this->file, where, takeMessages(status));
    }
  }

  const std::string file;

private:
  fitsfile* handle = nullptr;
};

/// BITPIX and the axes of the current HDU; no axes where it is not an image.
struct ImageShape
{
  int bitpix = 0;
  std::vector<LONGLONG> axes;

  bool isImage() const
  {
    if (this->axes.size() < 2)
    {
      return false;
    }
    for (const LONGLONG n : this->axes)
    {
      if (n <= 0)
      {
        return false;
      }
    }
    return true;
  }
};

ImageShape currentShape(const FitsHandle& fits)
{
  int status = 0;
  int type = 0;
  fits_get_hdu_type(fits, &type, &status);
  fits.check(status, "");
  ImageShape shape;
  if (type != IMAGE_HDU)
  {
    return shape;
  }
  int count = 0;
  std::array<LONGLONG, maximumAxes> axes{};
  fits_get_img_paramll(fits, maximumAxes, &shape.bitpix, &count, axes.data(), &status);
  fits.check(status, "NAXIS");
  if (count > maximumAxes)
  {
    throw Error(fits.file, "NAXIS", "more than " + std::to_string(maximumAxes) + " axes");
  }
  shape.axes.assign(axes.begin(), axes.begin() + count);
  return shape;
}

ImageShape moveToFirstImage(const FitsHandle& fits)
{
  int status = 0;
  for (int hdu = 1;; ++hdu)
  {
    fits_movabs_hdu(fits, hdu, nullptr, &status);
    if (status == END_OF_FILE)
    {
      throw Error(fits.file, "", "holds no image of two or more axes");
    }
    fits.check(status, "HDU " + std::to_string(hdu - 1));
    const ImageShape shape = currentShape(fits);
    if (shape.isImage())
    {
      return shape;
    }
  }
}

ImageShape moveToSelected(const FitsHandle& fits, const FitsSelection& selection)
{
  int status = 0;
  std::string where;
  if (!selection.extension.empty())
  {
    where = "extension '" + selection.extension + "'";
    std::string name = selection.extension;
    fits_movnam_hdu(fits, ANY_HDU, name.data(), 0, &status);
  }
  else if (selection.hdu >= 0)
  {
    where = "HDU " + std::to_string(selection.hdu);
    fits_movabs_hdu(fits, selection.hdu + 1, nullptr, &status);
  }
  else
  {
    return moveToFirstImage(fits);
  }
  fits.check(status, where);
  const ImageShape shape = currentShape(fits);
  if (!shape.isImage())
  {
    throw Error(fits.file, where, "holds no image of two or more axes");
  }
  return shape;
}

/// Throws where the file is too short for the pixels that its header promises.
void checkSize(const FitsHandle& fits, const ImageShape& shape)
{
  constexpr LONGLONG most = std::numeric_limits<LONGLONG>::max() / 16;
  LONGLONG pixels = 1;
  for (const LONGLONG n : shape.axes)
  {
    if (n > most / pixels)
    {
      throw Error(fits.file, "NAXIS", "the header promises an impossible number of pixels");
    }
    pixels *= n;
  }
  int status = 0;
  LONGLONG dataStart = 0;
  fits_get_hduaddrll(fits, nullptr, &dataStart, nullptr, &status);
  const bool tiled = fits_is_compressed_image(fits, &status) != 0;
  fits.check(status, "");
  // The size after gunzip, where the file is gzipped as a whole.
  const LONGLONG fileSize = static_cast<fitsfile*>(fits)->Fptr->filesize;
  if (tiled ? pixels / maximumPixelsPerByte > fileSize
            : pixels * (std::abs(shape.bitpix) / 8) > fileSize - dataStart)
  {
    throw Error(fits.file, "NAXIS",
      "the file is truncated: its header promises " + std::to_string(pixels) + " pixels, its " +
        std::to_string(fileSize) + " bytes cannot hold them");
  }
}

/// The one-based first pixel of a plane, the planes counted along axis 3 fastest.
std::vector<long> firstPixel(const FitsHandle& fits, const ImageShape& shape, int plane)
{
  LONGLONG planes = 1;
  for (std::size_t axis = 2; axis < shape.axes.size(); ++axis)
  {
    planes *= shape.axes[axis];
  }
  if (plane < 0 || plane >= planes)
  {
    throw Error(fits.file, "plane " + std::to_string(plane),
      "out of range, the image has " + std::to_string(planes) +
        (planes == 1 ? " plane" : " planes") + " (0 to " + std::to_string(planes - 1) + ")");
  }
  std::vector<long> first(shape.axes.size(), 1);
  LONGLONG rest = plane;
  for (std::size_t axis = 2; axis < shape.axes.size(); ++axis)
  {
    first[axis] = 1 + static_cast<long>(rest % shape.axes[axis]);
    rest /= shape.axes[axis];
  }
  return first;
}

void readValues(const FitsHandle& fits, std::vector<long> first, Image& image)
{
  std::vector<long> last = first;
  last[0] = image.width;
  last[1] = image.height;
  std::vector<long> step(first.size(), 1);
  try
  {
    image.values.resize(static_cast<std::size_t>(image.width) * image.height);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(fits.file, "NAXIS", "not enough memory for the image");
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double blank = nan;
  int anyBlank = 0; // not optional, whatever the manual says: CFITSIO writes to it
  int status = 0;
  fits_read_subset(fits, TDOUBLE, first.data(), last.data(), step.data(), &blank,
    image.values.data(), &anyBlank, &status);
  fits.check(status, "");
  for (double& value : image.values)
  {
    value = std::isfinite(value) ? value : nan;
  }
}

std::string readCards(const FitsHandle& fits)
{
  char* header = nullptr;
  int count = 0;
  int status = 0;
  fits_convert_hdr2str(fits, 0, nullptr, 0, &header, &count, &status);
  if (status != 0)
  {
    // CFITSIO reads some tile-compressed images whose header it fails to translate; the table's
    // own header then serves, which has the same coordinates.
    status = 0;
    std::free(header);
    fits_clear_errmsg();
    fits_hdr2str(fits, 0, nullptr, 0, &header, &count, &status);
  }
  fits.check(status, "header");
  std::string cards(header);
  fits_free_memory(header, &status);
  constexpr std::size_t cardLength = 80;
  const std::size_t end = cards.size() / cardLength;
  if (end > 0 && cards.compare((end - 1) * cardLength, 8, "END     ") == 0)
  {
    cards.resize((end - 1) * cardLength);
  }
  return cards;
}

std::string readUnit(const FitsHandle& fits)
{
  char unit[FLEN_VALUE] = "";
  int status = 0;
  fits_read_key(fits, TSTRING, "BUNIT", unit, nullptr, &status);
  if (status != 0)
  {
    fits_clear_errmsg();
    return "";
  }
  return unit;
}
} // namespace

Image readFitsImage(const std::string& file, const FitsSelection& selection)
{
  const FitsHandle fits(file);
  const ImageShape shape = moveToSelected(fits, selection);
  checkSize(fits, shape);
  constexpr LONGLONG longest = std::numeric_limits<int>::max();
  if (shape.axes[0] > longest || shape.axes[1] > longest)
  {
    throw Error(file, "NAXIS", "an axis is longer than " + std::to_string(longest) + " pixels");
  }
  Image image;
  image.file = file;
  image.width = static_cast<int>(shape.axes[0]);
  image.height = static_cast<int>(shape.axes[1]);
  image.cards = readCards(fits);
  image.unit = readUnit(fits);
  readValues(fits, firstPixel(fits, shape, selection.plane), image);
  return image;
}
} // namespace galaxy
