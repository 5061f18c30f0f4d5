#ifndef galaxy_CommitTogether_h
#define galaxy_CommitTogether_h

#include "Filters/Export/AtomicFile.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Commits the files of one snapshot, all or none: the disk has the bytes of every one before the
/// first gets its place, and where one cannot get it, what was there before comes back. The
/// `obsolete` files go with them. Throws Error naming the file and the system's cause.
void commitTogether(
  const std::vector<AtomicFile*>& files, const std::vector<std::string>& obsolete = {});
} // namespace galaxy

#endif
