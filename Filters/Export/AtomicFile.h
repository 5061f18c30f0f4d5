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

/// A file that appears whole or not at all. Until `commit` puts it in its place, once it is safely
/// on disk, it has no name, where the file system knows such files, and goes with the process that
/// writes it, however that ends. Elsewhere it has a temporary name beside its place, under a lock;
/// what is not locked there, because its writer was killed, is removed by the next one. Without a
/// commit a file that was there before stays as it was; its owner and permissions pass on to the
/// new one. Every function throws Error naming the file and the system's cause.
class AtomicFile
{
public:
  enum class Until
  {
    Unnamed, ///< where the file system knows such files
    Named,
  };

  /// A symbolic link is written through; what is there and no regular file is refused.
  explicit AtomicFile(const std::string& file, Until until = Until::Unnamed);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Takes the disk space of the first `bytes` now, so that a full disk is found before the work.
  void reserve(std::uint64_t bytes);
  /// Appends.
  void write(const void* data, std::size_t bytes);
  void writeAt(std::uint64_t offset, const void* data, std::size_t bytes);
  /// Brings all to the disk. `commit` does so by itself.
  void sync();
  void commit();

  /// As the user gave it.
  const std::string& name() const { return this->file; }
  /// Where it will be: behind the symbolic links.
  const std::string& place() const { return this->target; }
  /// A name beside its place that nobody else has; until the commit the file may have it.
  const std::string& temporaryName() const { return this->temporary; }
  /// By which the file can be opened until the commit.
  std::string path() const;

private:
  [[noreturn]] void fail(int code) const;
  void create(Until until);
  bool createUnnamed(unsigned mode);
  void createNamed(unsigned mode);
  void nameIt();
  void takePermissions();

  std::string file;
  std::string target;
  std::string temporary;
  bool isNamed = false;
  int descriptor = -1;
  std::uint64_t end = 0;
};
} // namespace galaxy

#endif
