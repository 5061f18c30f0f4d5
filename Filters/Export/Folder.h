#ifndef galaxy_Folder_h
#define galaxy_Folder_h

#include <string>
#include <vector>

namespace galaxy
{
/// The folder that a path lies in.
std::string folderOf(const std::string& path);

/// What lies in a folder; nothing where it cannot be read.
std::vector<std::string> namesIn(const std::string& folder);

/// Brings the folder's list of names to the disk. Not every file system can do so.
void syncFolder(const std::string& folder);
} // namespace galaxy

#endif
