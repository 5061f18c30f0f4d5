#ifndef galaxy_AtomicFile_h
#define galaxy_AtomicFile_h

#include "Readers/Formats/Error.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace galaxy
{
/// A file that the system does not let come into being.
class NotWritten : public Error
{
public:
  NotWritten(const std::string& file, const std::string& cause)
    : Error(
        file, "", "cannot be written: " + cause + "; check the folder, its permissions and room")
  {
  }
};

/// A file that appears whole or not at all. It is written under a temporary name beside its place,
/// and `commit` puts it there once it is safely on disk; without a commit the temporary file goes
/// with the object, and a file that was there before stays as it was; its owner and permissions
/// pass on to the new one. Every function throws Error naming the file and the system's cause.
class AtomicFile
{
public:
  /// A symbolic link is written through; what is there and no regular file is refused.
  explicit AtomicFile(const std::string& file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Takes the disk space of the first `bytes` now, so that a full disk is found before the work.
  void reserve(std::uint64_t bytes);
  /// Appends.
  void write(const void* data, std::size_t bytes);
  void writeAt(std::uint64_t offset, const void* data, std::size_t bytes);
  /// Brings all to the disk; nothing more can be written then. `commit` does so by itself.
  void sync();
  void commit();

  /// As the user gave it.
  const std::string& name() const { return this->file; }
  /// Where it will be: behind the symbolic links.
  const std::string& place() const { return this->target; }
  /// Where the bytes go until the commit.
  const std::string& temporaryName() const { return this->temporary; }

private:
  [[noreturn]] void fail(int code) const;
  void create();
  void takePermissions();

  std::string file;
  std::string target;
  std::string temporary;
  int descriptor = -1;
  std::uint64_t end = 0;
};
} // namespace galaxy

#endif
