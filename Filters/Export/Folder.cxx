#include "Filters/Export/Folder.h"

#include <filesystem>
#include <memory>

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

namespace galaxy
{
std::string folderOf(const std::string& path)
{
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// Not by std::filesystem, whose iterator ends the program where memory runs out.
std::vector<std::string> namesIn(const std::string& folder)
{
  struct Close
  {
    void operator()(DIR* stream) const { closedir(stream); }
  };
  std::vector<std::string> names;
  const std::unique_ptr<DIR, Close> stream(opendir(folder.c_str()));
  for (const dirent* entry; stream && (entry = readdir(stream.get()));)
  {
    names.emplace_back(entry->d_name);
  }
  return names;
}

void syncFolder(const std::string& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0)
  {
    fsync(descriptor);
    close(descriptor);
  }
}
} // namespace galaxy
