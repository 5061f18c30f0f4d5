#include "Filters/Export/AtomicFile.h"

#include "Filters/Export/Folder.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace galaxy
{
namespace
{
/// Of links to links; the system follows no more.
constexpr int mostLinks = 40;
const std::string temporaryStart = ".galaxy-";

/// A name of this process's and of nothing else's. It is short, for that of the file itself may be
/// as long as the system allows.
std::string temporaryIn(const std::string& folder)
{
  static std::atomic<unsigned> count{ 0 };
  return folder + "/" + temporaryStart + std::to_string(getpid()) + "-" + std::to_string(count++);
}

bool isTemporary(const std::string& name)
{
  const std::size_t start = temporaryStart.size(), dash = name.find('-', start);
  const auto isNumber = [&name](std::size_t first, std::size_t last) {
    return first < last && std::all_of(name.begin() + first, name.begin() + last, [](char c) {
      return c >= '0' && c <= '9';
    });
  };
  return name.compare(0, start, temporaryStart) == 0 && dash != std::string::npos &&
    isNumber(start, dash) && isNumber(dash + 1, name.size());
}

bool isLinked(int descriptor)
{
  struct stat status;
  return fstat(descriptor, &status) == 0 && status.st_nlink > 0;
}

/// Removes what writers that were killed have left in a folder: nobody holds its lock.
void sweep(const std::string& folder)
{
  for (const std::string& name : namesIn(folder))
  {
    const std::string path = folder + "/" + name;
    const int left = isTemporary(name) ? open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC) : -1;
    if (left >= 0)
    {
      if (flock(left, LOCK_EX | LOCK_NB) == 0)
      {
        unlink(path.c_str());
      }
      close(left);
    }
  }
}
} // namespace

AtomicFile::AtomicFile(const std::string& file, Until until)
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
  this->create(until);
  this->takePermissions();
}

void AtomicFile::create(Until until)
{
  sweep(folderOf(this->target));
  const bool isThere = access(this->target.c_str(), F_OK) == 0;
  const mode_t mode = isThere ? 0600 : 0666; // until takePermissions
  if (until == Until::Named || !this->createUnnamed(mode))
  {
    this->createNamed(mode);
  }
}

/// False where the file system does not know such files, or nothing shows them.
bool AtomicFile::createUnnamed(unsigned mode)
{
#ifdef O_TMPFILE
  const std::string folder = folderOf(this->target);
  this->descriptor = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, mode);
  this->temporary = temporaryIn(folder);
  if (this->descriptor >= 0 && access(this->path().c_str(), F_OK) == 0)
  {
    return true;
  }
  if (this->descriptor >= 0)
  {
    close(this->descriptor);
    this->descriptor = -1;
  }
#endif
  return false;
}

void AtomicFile::createNamed(unsigned mode)
{
  // O_EXCL: two writers of one file must not share a temporary.
  while (!this->isNamed)
  {
    this->temporary = temporaryIn(folderOf(this->target));
    this->descriptor = open(this->temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (this->descriptor >= 0)
    {
      // Who swept the folder may have taken it before it was locked.
      flock(this->descriptor, LOCK_EX);
      this->isNamed = isLinked(this->descriptor);
      if (!this->isNamed)
      {
        close(this->descriptor);
        this->descriptor = -1;
      }
    }
    else if (errno != EEXIST)
    {
      this->fail(errno);
    }
  }
}

/// What has no name gets the temporary one.
void AtomicFile::nameIt()
{
  flock(this->descriptor, LOCK_EX);
  while (!this->isNamed)
  {
    this->isNamed = linkat(AT_FDCWD, this->path().c_str(), AT_FDCWD, this->temporary.c_str(),
                      AT_SYMLINK_FOLLOW) == 0;
    if (!this->isNamed && errno != EEXIST)
    {
      this->fail(errno);
    }
    this->temporary = this->isNamed ? this->temporary : temporaryIn(folderOf(this->target));
  }
}

std::string AtomicFile::path() const
{
  return this->isNamed ? this->temporary : "/proc/self/fd/" + std::to_string(this->descriptor);
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
  if (this->isNamed)
  {
    unlink(this->temporary.c_str());
  }
  if (this->descriptor >= 0)
  {
    close(this->descriptor); // and with it the lock
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
  if (fsync(this->descriptor) != 0)
  {
    this->fail(errno);
  }
}

void AtomicFile::commit()
{
  this->sync();
  this->nameIt();
  if (rename(this->temporary.c_str(), this->target.c_str()) != 0)
  {
    this->fail(errno);
  }
  this->isNamed = false;
  close(this->descriptor);
  this->descriptor = -1;
  syncFolder(folderOf(this->target)); // with which the rename reaches the disk; whole it is anyway
}

void AtomicFile::fail(int code) const
{
  throw NotWritten(this->file, std::generic_category().message(code));
}
} // namespace galaxy
