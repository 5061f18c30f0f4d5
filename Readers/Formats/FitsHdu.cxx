#include "Readers/Formats/FitsHdu.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/FitsRefusal.h"
#include "Readers/Formats/FitsTiles.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>

namespace galaxy
{
namespace
{
constexpr std::uint64_t blockLength = 2880;
// No header that anyone wrote comes near; a file of blanks would be read to its end.
constexpr std::uint64_t longestHeader = 64 << 20;
constexpr long long mostAxes = 99;
constexpr long long mostColumns = 999;

std::string nameOf(int number)
{
  return "HDU " + std::to_string(number);
}

/// An integer that must be there and in range.
long long required(
  const FitsBytes& bytes, const FitsHdu& hdu, const std::string& keyword, long long most)
{
  const std::optional<long long> value = hdu.header.integer(keyword);
  if (!value || *value < 0 || *value > most)
  {
    throw DamagedFile(bytes.file, nameOf(hdu.number) + ": " + keyword,
      "missing, or not a whole number from 0 to " + std::to_string(most));
  }
  return *value;
}

int readBitpix(const FitsBytes& bytes, const FitsHdu& hdu, const std::string& keyword)
{
  const long long value = hdu.header.integer(keyword).value_or(0);
  for (const int known : { 8, 16, 32, 64, -32, -64 })
  {
    if (value == known)
    {
      return known;
    }
  }
  throw DamagedFile(
    bytes.file, nameOf(hdu.number) + ": " + keyword, "is not 8, 16, 32, 64, -32 or -64");
}

std::vector<long long> readAxes(
  const FitsBytes& bytes, const FitsHdu& hdu, const std::string& keyword)
{
  constexpr long long longest = std::numeric_limits<long long>::max();
  std::vector<long long> axes(static_cast<std::size_t>(required(bytes, hdu, keyword, mostAxes)));
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    axes[i] = required(bytes, hdu, fitsKeyword(keyword, i + 1), longest);
  }
  return axes;
}

/// |BITPIX| / 8 * GCOUNT * (PCOUNT + the product of the axes); a random group's first axis is 0.
std::uint64_t promisedBytes(
  const FitsBytes& bytes, const FitsHdu& hdu, int bitpix, const std::vector<long long>& axes)
{
  const bool groups = !axes.empty() && axes[0] == 0 && hdu.header.flag("GROUPS");
  long long size = axes.empty() ? 0 : 1;
  bool overflows = false;
  for (std::size_t i = groups ? 1 : 0; i < axes.size(); ++i)
  {
    overflows |= __builtin_mul_overflow(size, axes[i], &size);
  }
  const long long parameters = hdu.header.integer("PCOUNT").value_or(0);
  const long long count = hdu.header.integer("GCOUNT").value_or(1);
  overflows |= __builtin_add_overflow(size, parameters, &size);
  overflows |= __builtin_mul_overflow(size, count, &size);
  overflows |= __builtin_mul_overflow(size, std::abs(bitpix) / 8, &size);
  if (overflows || parameters < 0 || count < 0 || size > std::numeric_limits<long long>::max() / 2)
  {
    throw DamagedFile(bytes.file, nameOf(hdu.number) + ": NAXIS",
      "the header promises an impossible number of pixels");
  }
  return static_cast<std::uint64_t>(size);
}

/// Reads the cards up to END; false where no HDU begins here.
bool readCards(FitsBytes& bytes, std::uint64_t start, FitsHdu& hdu)
{
  const std::string opening = hdu.number == 0 ? "SIMPLE  =" : "XTENSION=";
  for (std::uint64_t offset = start; offset - start < longestHeader; offset += blockLength)
  {
    const std::string block = bytes.read(offset, blockLength);
    if (offset == start && block.compare(0, opening.size(), opening) != 0)
    {
      return false;
    }
    for (std::size_t at = 0; at + FitsHeader::cardLength <= block.size();
         at += FitsHeader::cardLength)
    {
      const std::string card = block.substr(at, FitsHeader::cardLength);
      if (card.compare(0, 8, "END     ") == 0 && block.size() == blockLength)
      {
        hdu.dataStart = offset + blockLength;
        return true;
      }
      hdu.header.add(card);
    }
    if (block.size() < blockLength)
    {
      break;
    }
  }
  throw DamagedFile(bytes.file, "",
    "not readable as FITS: the header of " + nameOf(hdu.number) +
      " does not end, the file is truncated or no FITS file");
}

/// CFITSIO 4.2 quotes what is no number in a message that is too short for a long text.
void requireNumbers(const FitsBytes& bytes, const FitsHdu& hdu)
{
  constexpr std::size_t longestNumber = 30;
  for (const char* keyword : { "BSCALE", "BZERO", "BLANK", "THEAP", "PCOUNT", "GCOUNT", "ZBLANK",
         "ZSCALE", "ZZERO", "ZDITHER0", "ZVAL1", "ZVAL2", "ZVAL3", "ZPCOUNT", "ZGCOUNT" })
  {
    const std::optional<std::string> text = hdu.header.text(keyword);
    if (text &&
      (text->size() > longestNumber || hdu.header.isUnclosed(keyword) ||
        !hdu.header.number(keyword)))
    {
      throw DamagedFile(bytes.file, nameOf(hdu.number) + ": " + keyword, "not a number");
    }
  }
}

bool readHdu(FitsBytes& bytes, std::uint64_t start, FitsHdu& hdu)
{
  if (start >= bytes.size() || !readCards(bytes, start, hdu))
  {
    return false;
  }
  requireNumbers(bytes, hdu);
  const int bitpix = readBitpix(bytes, hdu, "BITPIX");
  const std::vector<long long> axes = readAxes(bytes, hdu, "NAXIS");
  hdu.dataBytes = promisedBytes(bytes, hdu, bitpix, axes);
  const std::string kind = hdu.header.text("XTENSION").value_or("IMAGE");
  if (kind == "TABLE" || kind == "BINTABLE")
  {
    required(bytes, hdu, "TFIELDS", mostColumns);
  }
  hdu.compressed = kind == "BINTABLE" && hdu.header.flag("ZIMAGE");
  if (hdu.compressed)
  {
    hdu.bitpix = readBitpix(bytes, hdu, "ZBITPIX");
    hdu.axes = readAxes(bytes, hdu, "ZNAXIS");
    checkTileParameters(bytes.file, hdu);
  }
  else if (kind == "IMAGE" || kind == "IUEIMAGE")
  {
    hdu.bitpix = bitpix;
    hdu.axes = axes;
  }
  return true;
}

bool isSelected(const FitsHdu& hdu, const FitsSelection& selection)
{
  if (!selection.extension.empty())
  {
    return upperCase(hdu.header.text("EXTNAME").value_or("")) == upperCase(selection.extension);
  }
  return selection.hdu >= 0 ? hdu.number == selection.hdu : hdu.isImage();
}

/// Throws where the file is too short for what the header promises.
void checkPromise(const FitsBytes& bytes, const FitsHdu& hdu)
{
  // No tile compression of the standard packs more pixels into a byte; an empty HCOMPRESS tile
  // comes closest.
  constexpr std::uint64_t mostPixelsPerByte = 16384;
  const std::uint64_t available =
    bytes.size() - std::min<std::uint64_t>(hdu.dataStart, bytes.size());
  const auto pixels = static_cast<std::uint64_t>(hdu.pixels());
  if (hdu.dataBytes > available || (hdu.compressed && pixels / mostPixelsPerByte > hdu.dataBytes))
  {
    throw DamagedFile(bytes.file, nameOf(hdu.number) + ": NAXIS",
      "the file is truncated: its header promises " + std::to_string(pixels) + " pixels, its " +
        std::to_string(bytes.size()) + " bytes cannot hold them");
  }
}

/// "HDU 1 'EVENTS'"
std::string nameOf(const FitsHdu& hdu)
{
  const std::string extension = hdu.header.text("EXTNAME").value_or("");
  return nameOf(hdu.number) + (extension.empty() ? "" : " '" + extension + "'");
}

/// The extensions that the file has, for messages.
std::string extensionsOf(const std::vector<FitsHdu>& hdus)
{
  std::string names;
  for (const FitsHdu& hdu : hdus)
  {
    const std::string name = hdu.header.text("EXTNAME").value_or("");
    names += name.empty() ? "" : (names.empty() ? "'" : ", '") + name + "'";
  }
  return names.empty() ? "the file has none" : "choose from " + names;
}

[[noreturn]] void failWithoutImage(const FitsBytes& bytes, const std::vector<FitsHdu>& hdus)
{
  for (const FitsHdu& hdu : hdus)
  {
    if (const std::string content = otherContent(hdu); !content.empty())
    {
      throw Error(bytes.file, "",
        "holds no image of two or more axes: " + nameOf(hdu) + " is " + content + cureOf(hdu));
    }
  }
  throw Error(bytes.file, "", "holds no image of two or more axes; choose another file");
}

[[noreturn]] void failAtMissingHdu(
  FitsBytes& bytes, const FitsSelection& selection, const std::vector<FitsHdu>& hdus)
{
  constexpr std::size_t opening = 512;
  if (hdus.empty())
  {
    throw Error(bytes.file, "", notFits(bytes.read(0, opening)));
  }
  if (!selection.extension.empty())
  {
    throw Error(bytes.file, "extension '" + selection.extension + "'",
      "not found; choose an EXTNAME that the file has, " + extensionsOf(hdus));
  }
  if (selection.hdu >= 0)
  {
    throw Error(bytes.file, nameOf(selection.hdu),
      "not found; choose from 0 to " + std::to_string(hdus.size() - 1));
  }
  failWithoutImage(bytes, hdus);
}

[[noreturn]] void failAtNoImage(
  const FitsBytes& bytes, const FitsSelection& selection, const FitsHdu& hdu)
{
  const std::string content = otherContent(hdu);
  throw Error(bytes.file,
    selection.extension.empty() ? nameOf(hdu.number) : "extension '" + selection.extension + "'",
    "holds no image of two or more axes" + (content.empty() ? "" : ", it is " + content) +
      (content.empty() || cureOf(hdu) == "; choose another file" ? "; choose another HDU"
                                                                 : cureOf(hdu)));
}
} // namespace

bool FitsHdu::isImage() const
{
  return this->axes.size() >= 2 &&
    std::all_of(this->axes.begin(), this->axes.end(), [](long long n) { return n > 0; });
}

long long FitsHdu::pixels() const
{
  long long product = 1;
  for (const long long n : this->axes)
  {
    if (__builtin_mul_overflow(product, n, &product))
    {
      return std::numeric_limits<long long>::max();
    }
  }
  return product;
}

FitsHdu findFitsImage(FitsBytes& bytes, const FitsSelection& selection)
{
  std::uint64_t start = 0;
  std::vector<FitsHdu> others;
  for (;;)
  {
    FitsHdu hdu;
    hdu.number = static_cast<int>(others.size());
    if (!readHdu(bytes, start, hdu))
    {
      failAtMissingHdu(bytes, selection, others);
    }
    if (isSelected(hdu, selection))
    {
      if (!hdu.isImage())
      {
        failAtNoImage(bytes, selection, hdu);
      }
      checkPromise(bytes, hdu);
      return hdu;
    }
    start = hdu.dataStart + (hdu.dataBytes + blockLength - 1) / blockLength * blockLength;
    others.push_back(std::move(hdu));
  }
}
} // namespace galaxy
