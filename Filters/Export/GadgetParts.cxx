#include "Filters/Export/GadgetParts.h"

#include "Filters/Export/Folder.h"
#include "Filters/Export/GadgetBinary.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace galaxy
{
namespace
{
namespace fs = std::filesystem;

/// The number of files that a file's header tells of; 0 where it is no binary snapshot.
std::int64_t filesToldBy(const fs::path& file)
{
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored)))
  {
    return 0;
  }
  char start[16 + 4 + sizeof(GadgetHeader)] = {};
  std::ifstream stream(file, std::ios::binary);
  stream.read(start, sizeof(start));
  const bool isNamed = std::memcmp(start + 4, "HEAD", 4) == 0;
  const char* record = start + (isNamed ? 16 : 0);
  std::uint32_t length = 0;
  std::memcpy(&length, record, sizeof(length));
  if (stream.gcount() < record - start + 4 + std::int64_t{ sizeof(GadgetHeader) } ||
    length != sizeof(GadgetHeader))
  {
    return 0;
  }
  GadgetHeader header;
  std::memcpy(&header, record + 4, sizeof(header));
  return header.numFiles;
}

/// The number in a name such as "model.g1.12" of part 12 of "model.g1"; -1 for other names.
std::int64_t partOf(const std::string& name, const std::string& snapshot)
{
  const std::string start = snapshot + ".";
  const std::string digits = name.substr(std::min(start.size(), name.size()));
  const bool isPart = name.compare(0, start.size(), start) == 0 && !digits.empty() &&
    digits.size() < 10 &&
    std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
    (digits.size() == 1 || digits[0] != '0');
  return isPart ? std::stoll(digits) : -1;
}
} // namespace

std::string gadgetPartName(const std::string& file, std::uint64_t part, std::uint64_t files)
{
  return files == 1 ? file : file + "." + std::to_string(part);
}

std::vector<std::string> staleGadgetParts(const std::string& file, std::uint64_t files)
{
  std::vector<std::string> stale;
  if (files > 1 && filesToldBy(file) == 1)
  {
    stale.push_back(file);
  }
  const fs::path path(file);
  const fs::path folder = folderOf(file);
  const std::int64_t firstStale = files == 1 ? 0 : static_cast<std::int64_t>(files);
  for (const std::string& name : namesIn(folder))
  {
    const std::int64_t part = partOf(name, path.filename().string());
    const std::int64_t told = part >= firstStale ? filesToldBy(folder / name) : 0;
    if (told > 1 && part < told)
    {
      stale.push_back((folder / name).string());
    }
  }
  return stale;
}
} // namespace galaxy
