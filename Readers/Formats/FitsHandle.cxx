#include "Readers/Formats/FitsHandle.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsHdu.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

namespace galaxy
{
namespace
{
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
} // namespace

FitsHandle::FitsHandle(FitsBytes& bytes)
  : file(bytes.file)
{
  // CFITSIO reads `~`, `-` and leading blanks in its own way: an absolute path means only itself.
  const std::string path = std::filesystem::absolute(this->file).string();
  if (path.size() >= FLEN_FILENAME)
  {
    throw Error(this->file, "", "the path is longer than CFITSIO can take; move the file");
  }
  fits_clear_errmsg();
  int status = 0;
  if (bytes.unpacked().empty())
  {
    fits_open_diskfile(&this->handle, path.c_str(), READONLY, &status);
  }
  else
  {
    this->memory = bytes.unpacked().data();
    this->memorySize = bytes.unpacked().size();
    fits_open_memfile(
      &this->handle, "unpacked", READONLY, &this->memory, &this->memorySize, 0, nullptr, &status);
  }
  if (status != 0)
  {
    this->handle = nullptr;
    this->check(status, "not readable as FITS");
  }
}

FitsHandle::~FitsHandle()
{
  int status = 0;
  fits_close_file(this->handle, &status);
  fits_clear_errmsg();
}

void FitsHandle::check(int status, const std::string& where) const
{
  if (status != 0)
  {
    throw DamagedFile(this->file, where, takeMessages(status));
  }
}

void FitsHandle::moveTo(const FitsHdu& hdu)
{
  const std::string where = "HDU " + std::to_string(hdu.number);
  int status = 0;
  fits_movabs_hdu(this->handle, hdu.number + 1, nullptr, &status);
  int bitpix = 0;
  int count = 0;
  std::array<LONGLONG, maximumAxes> axes{};
  fits_get_img_paramll(this->handle, maximumAxes, &bitpix, &count, axes.data(), &status);
  LONGLONG start = 0;
  fits_get_hduaddrll(this->handle, nullptr, &start, nullptr, &status);
  const bool compressed = fits_is_compressed_image(this->handle, &status) != 0;
  this->check(status, where);
  if (bitpix != hdu.bitpix || compressed != hdu.compressed ||
    start != static_cast<LONGLONG>(hdu.dataStart) || count != static_cast<int>(hdu.axes.size()) ||
    !std::equal(hdu.axes.begin(), hdu.axes.end(), axes.begin()))
  {
    throw DamagedFile(
      this->file, where, "the header contradicts itself about the size of its data");
  }
}
} // namespace galaxy
