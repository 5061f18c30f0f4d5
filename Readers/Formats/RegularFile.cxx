#include "Readers/Formats/RegularFile.h"

#include "Readers/Formats/Error.h"

#include <filesystem>

namespace galaxy
{
namespace
{
namespace fs = std::filesystem;

/// Why a file that `status` does not find is not found.
std::string absence(const std::string& file, const std::error_code& failed)
{
  if (failed == std::errc::too_many_symbolic_link_levels)
  {
    return "is a symbolic link that leads back to itself; correct the link";
  }
  if (failed == std::errc::permission_denied)
  {
    return "may not be looked at; check the permissions of its folder";
  }
  std::error_code ignored;
  return fs::is_symlink(fs::symlink_status(file, ignored))
    ? "is a symbolic link to a file that is not there; correct the link"
    : "no such file; correct its name";
}

const char* kindOf(fs::file_type type)
{
  switch (type)
  {
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::fifo:
      return "a pipe (FIFO)";
    case fs::file_type::socket:
      return "a socket";
    case fs::file_type::block:
    case fs::file_type::character:
      return "a device";
    default:
      return "nothing that can be read";
  }
}
} // namespace

void requireRegularFile(const std::string& file)
{
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (status.type() == fs::file_type::regular)
  {
    return;
  }
  if (status.type() == fs::file_type::none || status.type() == fs::file_type::not_found)
  {
    throw Error(file, "", absence(file, failed));
  }
  throw Error(file, "", std::string("is ") + kindOf(status.type()) + ", must be a file");
}

std::string foreignFormat(const std::string& beginning)
{
  static const struct
  {
    std::string start;
    const char* name;
  } formats[] = {
    { "\x1f\x8b", "compressed by gzip; unpack it with gunzip" },
    { "BZh", "compressed by bzip2; unpack it with bunzip2" },
    { std::string("\xfd"
                  "7zXZ"),
      "compressed by xz; unpack it with unxz" },
    { "\x28\xb5\x2f\xfd", "compressed by zstd; unpack it with unzstd" },
    { "PK\x03\x04", "a zip archive or a spreadsheet (.xlsx, .ods); unpack it, or save it as CSV" },
    { "\xd0\xcf\x11\xe0", "an Office file; save it as CSV" },
    { "SIMPLE  =", "a FITS file; save its table as CSV or text" },
    { "\x89HDF", "an HDF5 file; save its table as CSV or text" },
    { "%PDF", "a PDF; save its table as CSV or text" },
    { "{\\rtf", "an RTF document; save it as plain text" },
    { "<?xml", "XML, such as a VOTable; save its table as CSV or text" },
    { "<VOTABLE", "a VOTable; save its table as CSV or text" },
    { "<!DOCTYPE", "a web page; save its table as CSV or text" },
    { "<html", "a web page; save its table as CSV or text" },
  };
  for (const auto& [start, name] : formats)
  {
    if (beginning.compare(0, start.size(), start) == 0)
    {
      return name;
    }
  }
  return "";
}
} // namespace galaxy
