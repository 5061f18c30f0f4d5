#ifndef galaxy_FitsBytes_h
#define galaxy_FitsBytes_h

#include "Readers/Formats/Progress.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace galaxy
{
/// The bytes of a FITS file: those on the disk, or those that a file gzipped as a whole unpacks to.
class FitsBytes
{
public:
  /// The path is taken literally. Throws Error where the file is missing or unreadable, its gzip
  /// stream broken or ended early, or where it unpacks to more than availableMemory().
  /// `progress` is told the part unpacked; Aborted is thrown where it ends that.
  explicit FitsBytes(const std::string& file, const Progress& progress = {});

  std::uint64_t size() const { return this->length; }

  /// The bytes from `offset`, at most `count`; fewer at the end of the file.
  std::string read(std::uint64_t offset, std::size_t count);

  /// What was unpacked; empty where the file is read from the disk.
  std::string& unpacked() { return this->memory; }

  const std::string file;

private:
  void unpack(const Progress& progress);

  std::ifstream stream;
  std::string memory;
  std::uint64_t length = 0;
};
} // namespace galaxy

#endif
