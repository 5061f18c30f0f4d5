#include "Filters/Export/CommitTogether.h"

#include "Filters/Export/AtomicFile.h"

#include <cerrno>
#include <cstdio>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace galaxy
{
namespace
{
/// What stood at the places that are being changed, which comes back unless `finish` is called.
class Before
{
public:
  Before() = default;
  Before(const Before&) = delete;
  Before& operator=(const Before&) = delete;
  ~Before()
  {
    for (auto change = this->changes.rbegin(); change != this->changes.rend(); ++change)
    {
      if (change->aside.empty())
      {
        unlink(change->place.c_str());
        continue;
      }
      rename(change->aside.c_str(), change->place.c_str());
      unlink(change->aside.c_str()); // of two names of one file rename leaves both
    }
  }

  /// Keeps what is at `place`, if anything, as `aside` until the end. There it stays, as a second
  /// name, where the file system has such.
  void keep(const std::string& place, const std::string& aside)
  {
    struct stat there;
    if (stat(place.c_str(), &there) != 0)
    {
      this->changes.push_back({ place, "" });
    }
    else if (!S_ISREG(there.st_mode))
    {
      throw Error(place, "", "is not a regular file; choose another name");
    }
    else if (link(place.c_str(), aside.c_str()) == 0 || rename(place.c_str(), aside.c_str()) == 0)
    {
      this->changes.push_back({ place, aside });
    }
    else
    {
      throw NotWritten(place, std::generic_category().message(errno));
    }
  }

  void finish()
  {
    for (const Change& change : this->changes)
    {
      if (!change.aside.empty())
      {
        unlink(change.aside.c_str());
      }
    }
    this->changes.clear();
  }

private:
  struct Change
  {
    std::string place;
    std::string aside; ///< empty where there was nothing
  };
  std::vector<Change> changes;
};
} // namespace

void commitTogether(const std::vector<AtomicFile*>& files, const std::vector<std::string>& obsolete)
{
  if (files.size() == 1 && obsolete.empty())
  {
    files.front()->commit();
    return;
  }
  for (AtomicFile* file : files)
  {
    file->sync();
  }
  const std::string aside = files.front()->temporaryName() + "-";
  Before before;
  for (std::size_t k = 0; k < obsolete.size(); ++k)
  {
    before.keep(obsolete[k], aside + "old-" + std::to_string(k));
    unlink(obsolete[k].c_str());
  }
  for (AtomicFile* file : files)
  {
    before.keep(file->place(), file->temporaryName() + "-before");
    file->commit();
  }
  before.finish();
}
} // namespace galaxy
