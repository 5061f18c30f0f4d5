#include "Filters/Export/AtomicFile.h"

#include "Filters/Export/Folder.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace galaxy
{
namespace
{
/// Of links to links; the system follows no more.
constexpr int mostLinks = 40;
} // namespace

AtomicFile::AtomicFile(const std::string& file)
  : file(file)
  , target(file)
{
  namespace fs = std::filesystem;
  std::error_code code;
  for (int depth = 0; fs::is_symlink(this->target, code); ++depth)
  {
    if (depth == mostLinks)
    {
      this->fail(ELOOP);
    }
    const fs::path link = this->target;
    this->target = (link.parent_path() / fs::read_symlink(link, code)).string();
  }
  const fs::file_status status = fs::status(this->target, code);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Error(file, "",
      (fs::is_directory(status) ? "is a folder" : "is not a regular file") +
        std::string("; choose another name"));
  }
  this->create();
  this->takePermissions();
}

void AtomicFile::create()
{
  // O_EXCL: two writers of one file must not share a temporary.
  // Its name is short, for that of the file itself may be as long as the system allows.
  const std::string stem = folderOf(this->target) + "/.galaxy-" + std::to_string(getpid()) + "-";
  const bool isThere = access(this->target.c_str(), F_OK) == 0;
  const mode_t mode = isThere ? 0600 : 0666; // until takePermissions
  for (int attempt = 0; this->descriptor < 0; ++attempt)
  {
    this->temporary = stem + std::to_string(attempt);
    this->descriptor = open(this->temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (this->descriptor < 0 && errno != EEXIST)
    {
      this->fail(errno);
    }
  }
}

/// Those of the file that is to be replaced, as far as the system lets one: only root can give a
/// file away, and some file systems have no permissions.
void AtomicFile::takePermissions()
{
  struct stat before;
  if (stat(this->target.c_str(), &before) == 0)
  {
    const bool isGiven = fchown(this->descriptor, before.st_uid, before.st_gid) == 0;
    const mode_t mode = before.st_mode & (isGiven ? 07777 : 0777);
    static_cast<void>(fchmod(this->descriptor, mode));
  }
}

AtomicFile::~AtomicFile()
{
  if (this->descriptor >= 0)
  {
    close(this->descriptor);
  }
  if (!this->temporary.empty())
  {
    unlink(this->temporary.c_str());
  }
}

void AtomicFile::reserve(std::uint64_t bytes)
{
  const int code = posix_fallocate(this->descriptor, 0, static_cast<off_t>(bytes));
  if (code == ENOSPC || code == EFBIG || code == EDQUOT)
  {
    this->fail(code);
  }
}

void AtomicFile::write(const void* data, std::size_t bytes)
{
  this->writeAt(this->end, data, bytes);
  this->end += bytes;
}

void AtomicFile::writeAt(std::uint64_t offset, const void* data, std::size_t bytes)
{
  const char* from = static_cast<const char*>(data);
  while (bytes > 0)
  {
    const ssize_t written = pwrite(this->descriptor, from, bytes, static_cast<off_t>(offset));
    if (written < 0 && errno != EINTR)
    {
      this->fail(errno);
    }
    const std::size_t done = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    from += done;
    offset += done;
    bytes -= done;
  }
}

void AtomicFile::sync()
{
  if (this->descriptor < 0)
  {
    return;
  }
  if (fsync(this->descriptor) != 0)
  {
    this->fail(errno);
  }
  const int closed = close(this->descriptor);
  this->descriptor = -1;
  if (closed != 0)
  {
    this->fail(errno);
  }
}

void AtomicFile::commit()
{
  this->sync();
  if (rename(this->temporary.c_str(), this->target.c_str()) != 0)
  {
    this->fail(errno);
  }
  this->temporary.clear();
  syncFolder(folderOf(this->target)); // with which the rename reaches the disk; whole it is anyway
}

void AtomicFile::fail(int code) const
{
  throw NotWritten(this->file, std::generic_category().message(code));
}
} // namespace galaxy
