#include "Readers/Formats/FitsRefusal.h"

#include <algorithm>

namespace galaxy
{
namespace
{
using namespace std::string_literals;

struct Format
{
  std::string start;
  const char* what;
};

const char* formatOf(const std::string& bytes)
{
  static const Format formats[] = {
    { "BZh", "compressed by bzip2; unpack it with `bunzip2`" },
    { "\xfd"s + "7zXZ\0"s, "compressed by xz; unpack it with `unxz`" },
    { "PK\3\4", "a zip archive; unpack it with `unzip`" },
    { "\x1f\x9d", "compressed by compress (.Z); unpack it with `uncompress`" },
    { "\x1f\xa0", "compressed by LZH; unpack it with `gunzip`" },
    { "\x1f\x8b", "gzipped twice; unpack it with `gunzip` first" },
    { "\x28\xb5\x2f\xfd", "compressed by zstd; unpack it with `unzstd`" },
    { "\x04\x22\x4d\x18", "compressed by lz4; unpack it with `unlz4`" },
    { "\x5d\0\0"s, "compressed by lzma; unpack it with `unlzma`" },
    { "LZIP", "compressed by lzip; unpack it with `lzip -d`" },
    { "7z\xbc\xaf\x27\x1c", "a 7z archive; unpack it with `7z x`" },
    { "Rar!", "a rar archive; unpack it with `unrar x`" },
    { "\x89HDF", "an HDF5 file; save its image as FITS, with astropy for example" },
    { "CDF\1", "a netCDF file; save its image as FITS, with astropy for example" },
    { "CDF\2", "a netCDF file; save its image as FITS, with astropy for example" },
    { "#ASDF", "an ASDF file; save its image as FITS, with astropy for example" },
    { "\x93NUMPY", "a NumPy array; save it as FITS, with astropy for example" },
    { "XISF", "an XISF file; save its image as FITS" },
    { "\x89PNG", "a PNG picture; use the FITS file that it was made from" },
    { "\xff\xd8\xff", "a JPEG picture; use the FITS file that it was made from" },
    { "\0\0\0\x0cjP"s, "a JPEG 2000 picture; use the FITS file that it was made from" },
    { "GIF8", "a GIF picture; use the FITS file that it was made from" },
    { "RIFF", "a WebP picture; use the FITS file that it was made from" },
    { "II*\0"s, "a TIFF picture; use the FITS file that it was made from" },
    { "MM\0*"s, "a TIFF picture; use the FITS file that it was made from" },
    { "\x76\x2f\x31\x01", "an OpenEXR picture; use the FITS file that it was made from" },
    { "%PDF", "a PDF document; use the FITS file of its data" },
    { "%!PS", "a PostScript document; use the FITS file of its data" },
    { "version https://git-lfs",
      "a pointer to a file that Git has not fetched; use `git lfs pull`" },
  };
  for (const Format& format : formats)
  {
    if (bytes.compare(0, format.start.size(), format.start) == 0)
    {
      return format.what;
    }
  }
  constexpr std::size_t tarMark = 257;
  return bytes.size() > tarMark && bytes.compare(tarMark, 5, "ustar") == 0
    ? "a tar archive; unpack it with `tar xf`"
    : nullptr;
}

bool isPrint(char c)
{
  return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t';
}

/// The words that a text begins with.
std::string opening(const std::string& text)
{
  constexpr std::size_t longest = 40;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  std::string words = start == std::string::npos ? "" : text.substr(start, longest);
  return words.substr(0, words.find_first_of("\r\n\t"));
}
} // namespace

std::string notFits(const std::string& start)
{
  const std::string is = "not readable as FITS: it is ";
  if (const char* format = formatOf(start))
  {
    return is + format;
  }
  if (start.find_first_not_of('\0') == std::string::npos)
  {
    return is + (start.empty() ? "empty" : "filled with zeros") +
      ", as after a download that failed; use another copy";
  }
  const std::string words = opening(start);
  const std::string capitals = upperCase(words);
  if (capitals.rfind("<!DOCTYPE HTML", 0) == 0 || capitals.rfind("<HTML", 0) == 0)
  {
    return is +
      "a web page (HTML), as when a download wants a login; use the link of the file itself";
  }
  if (capitals.rfind("<?XML", 0) == 0 || capitals.rfind("<VOTABLE", 0) == 0)
  {
    return is + "an XML document or VOTable; use the FITS file of its data";
  }
  if (!words.empty() && std::all_of(start.begin(), start.end(), isPrint))
  {
    return "not readable as FITS: it does not begin with SIMPLE but is a text that begins with '" +
      words + "'; choose a FITS file";
  }
  return "not readable as FITS: it does not begin with SIMPLE; choose a FITS file";
}

namespace
{
bool isHealpix(const FitsHdu& hdu)
{
  return upperCase(hdu.header.text("PIXTYPE").value_or("")) == "HEALPIX" ||
    (hdu.header.text("NSIDE") && hdu.header.text("ORDERING"));
}

bool isEvents(const FitsHdu& hdu)
{
  return upperCase(hdu.header.text("EXTNAME").value_or("")).rfind("EVENTS", 0) == 0;
}

bool isTable(const FitsHdu& hdu)
{
  const std::string kind = hdu.header.text("XTENSION").value_or("");
  return kind == "TABLE" || kind == "BINTABLE";
}
} // namespace

std::string otherContent(const FitsHdu& hdu)
{
  if (isHealpix(hdu))
  {
    return "a HEALPix map (NSIDE = " + hdu.header.text("NSIDE").value_or("?") + ")";
  }
  if (isEvents(hdu))
  {
    return "a list of events";
  }
  if (isTable(hdu))
  {
    return "a table";
  }
  if (hdu.header.flag("GROUPS"))
  {
    return "visibilities (random groups)";
  }
  const bool hasData = !hdu.axes.empty() &&
    std::all_of(hdu.axes.begin(), hdu.axes.end(), [](long long n) { return n > 0; });
  return hasData ? "of one axis, a spectrum or the like" : "";
}

std::string cureOf(const FitsHdu& hdu)
{
  if (isHealpix(hdu))
  {
    return "; use reproject or healpy to project the sky about the galaxy onto an image first";
  }
  if (isEvents(hdu))
  {
    return "; use the mission's software to bin them into an image first";
  }
  if (hdu.header.flag("GROUPS"))
  {
    return "; use CASA or AIPS to make an image of them first";
  }
  return "; choose another file";
}
} // namespace galaxy
