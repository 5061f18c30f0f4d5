#include "Readers/Formats/FitsBytes.h"

#include "Readers/Formats/AvailableMemory.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/RegularFile.h"

#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>

namespace galaxy
{
namespace
{
using GzipFile = std::unique_ptr<gzFile_s, int (*)(gzFile)>;

constexpr std::size_t unpackedAtOnce = std::size_t(1) << 20;
// Deflate writes a byte for at most this many.
constexpr std::uint64_t largestRatio = 1032;

const char* const unopened = "cannot be opened; check that it may be read";
} // namespace

FitsBytes::FitsBytes(const std::string& file, const Progress& progress)
  : file(file)
{
  requireRegularFile(file);
  std::error_code failed;
  this->stream.open(file, std::ios::binary);
  this->length = std::filesystem::file_size(file, failed);
  if (!this->stream || failed)
  {
    throw Error(file, "", unopened);
  }
  if (this->read(0, 2) == "\x1f\x8b")
  {
    this->unpack(progress);
  }
}

std::string FitsBytes::read(std::uint64_t offset, std::size_t count)
{
  if (!this->memory.empty())
  {
    return offset < this->length ? this->memory.substr(offset, count) : std::string();
  }
  std::string bytes(count, '\0');
  this->stream.clear();
  this->stream.seekg(static_cast<std::streamoff>(offset));
  this->stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(this->stream.gcount(), 0)));
  return bytes;
}

void FitsBytes::unpack(const Progress& progress)
{
  const GzipFile gzip(gzopen(this->file.c_str(), "rb"), gzclose);
  if (!gzip)
  {
    throw Error(this->file, "", unopened);
  }
  const auto limit = static_cast<std::uint64_t>(std::min(availableMemory(), 0x1p62));
  // The last four bytes of a gzip file are its length, as far as they can hold it.
  const std::string end = this->read(std::max<std::uint64_t>(this->length, 4) - 4, 4);
  std::uint64_t expected = 0;
  for (std::size_t i = end.size(); i-- > 0;)
  {
    expected = expected << 8 | static_cast<unsigned char>(end[i]);
  }
  try
  {
    this->memory.reserve(std::min({ expected, limit, this->length * largestRatio }));
    std::size_t filled = 0;
    for (int count = 1; count > 0; filled += static_cast<std::size_t>(std::max(count, 0)))
    {
      if (filled > limit)
      {
        throw Error(this->file, "", "unpacks to more than the memory that is free; cut out a part");
      }
      if (progress &&
        !progress(static_cast<double>(gzoffset(gzip.get())) / static_cast<double>(this->length)))
      {
        throw Aborted(this->file, "", "reading was ended");
      }
      this->memory.resize(filled + unpackedAtOnce);
      count = gzread(gzip.get(), this->memory.data() + filled, unpackedAtOnce);
    }
    this->memory.resize(filled);
  }
  catch (const std::bad_alloc&)
  {
    throw Error(this->file, "", "not enough memory to unpack it; use gunzip first");
  }
  int code = Z_OK;
  gzerror(gzip.get(), &code);
  if (code != Z_OK && code != Z_STREAM_END)
  {
    throw DamagedFile(this->file, "",
      code == Z_BUF_ERROR ? "truncated: its gzip stream ends early" : "its gzip stream is broken");
  }
  if (this->memory.empty())
  {
    throw DamagedFile(this->file, "", "not readable as FITS: unpacks to nothing");
  }
  this->length = this->memory.size();
}
} // namespace galaxy
