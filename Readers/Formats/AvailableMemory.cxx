#include "Readers/Formats/AvailableMemory.h"

#include "Readers/Formats/Error.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <vector>

namespace galaxy
{
namespace
{
constexpr double unlimited = std::numeric_limits<double>::infinity();
/// So little is not asked for, lest a picture that fits anywhere waits for files to be read.
constexpr double littleMemory = 1 << 24;

/// The number that follows a word in a file of words; `fallback` where there is none.
double numberAfter(const std::string& file, const std::string& word, double fallback)
{
  std::ifstream stream(file);
  for (std::string next; stream >> next;)
  {
    double value;
    if (next == word && stream >> value)
    {
      return value;
    }
  }
  return fallback;
}

/// A file's first word as a number; `fallback` where it is none, such as "max".
double numberIn(const std::string& file, double fallback)
{
  std::ifstream stream(file);
  double value;
  return stream >> value ? value : fallback;
}

/// A hierarchy of memory groups: where it is to be seen, and the names of its files.
struct Hierarchy
{
  std::string mount; ///< folder
  std::string shown; ///< the group that is seen there
  bool isOld = false;
};

std::vector<std::string> wordsOf(const std::string& line, char between)
{
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, between);)
  {
    words.push_back(word);
  }
  return words;
}

bool has(const std::string& list, const std::string& name)
{
  const std::vector<std::string> names = wordsOf(list, ',');
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// See proc(5), /proc/pid/mountinfo.
std::vector<Hierarchy> hierarchiesIn(const std::string& mountInfo)
{
  std::vector<Hierarchy> found;
  std::ifstream stream(mountInfo);
  for (std::string line; std::getline(stream, line);)
  {
    const std::vector<std::string> words = wordsOf(line, ' ');
    const auto dash = std::find(words.begin(), words.end(), "-");
    if (words.size() < 5 || words.end() - dash < 4)
    {
      continue;
    }
    const bool isOld = dash[1] == "cgroup" && has(dash[3], "memory");
    if (isOld || dash[1] == "cgroup2")
    {
      found.push_back({ words[4], words[3], isOld });
    }
  }
  return found;
}

/// The process's own group in a hierarchy, "/a/b"; see cgroups(7), /proc/pid/cgroup.
std::string groupIn(const std::string& cgroups, bool isOld)
{
  std::ifstream stream(cgroups);
  for (std::string line; std::getline(stream, line);)
  {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
    {
      continue;
    }
    const std::string controllers = line.substr(first + 1, second - first - 1);
    if (isOld ? has(controllers, "memory") : controllers.empty())
    {
      return line.substr(second + 1);
    }
  }
  return "/";
}

/// What one group's limit leaves; what it has of files' content goes when it is needed.
double leftIn(const std::string& folder, bool isOld)
{
  const std::string prefix = isOld ? "total_" : "";
  const double limit =
    numberIn(folder + (isOld ? "/memory.limit_in_bytes" : "/memory.max"), unlimited);
  const double used = numberIn(folder + (isOld ? "/memory.usage_in_bytes" : "/memory.current"), 0);
  if (!(limit < 0x1p60)) // cgroup v1 writes a number all the same
  {
    return unlimited;
  }
  const std::string details = folder + "/memory.stat";
  const double files = numberAfter(details, prefix + "inactive_file", 0) +
    numberAfter(details, prefix + "active_file", 0);
  return limit - std::max(0.0, used - files);
}

/// The group and all that it lies in, as far as they are to be seen.
double leftInGroups(const std::string& root)
{
  double least = unlimited;
  for (const Hierarchy& hierarchy : hierarchiesIn(root + "/proc/self/mountinfo"))
  {
    std::string group = groupIn(root + "/proc/self/cgroup", hierarchy.isOld);
    const std::string shown = hierarchy.shown == "/" ? "" : hierarchy.shown;
    const bool isBelow = group.compare(0, shown.size(), shown) == 0;
    group = isBelow && group.find("..") == std::string::npos ? group.substr(shown.size()) : "";
    for (;;)
    {
      least = std::min(least, leftIn(root + hierarchy.mount + group, hierarchy.isOld));
      if (group.empty())
      {
        break;
      }
      group.resize(group.rfind('/'));
    }
  }
  return least;
}

/// What a limit of the process leaves, of which it has so many kB.
double leftOf(int resource, double used)
{
  rlimit limit;
  const bool isLimited = getrlimit(static_cast<__rlimit_resource>(resource), &limit) == 0 &&
    limit.rlim_cur != RLIM_INFINITY;
  return isLimited ? static_cast<double>(limit.rlim_cur) - 1024 * used : unlimited;
}

std::string inWords(double bytes)
{
  std::ostringstream text;
  text.precision(3);
  bytes >= 1e12    ? text << bytes / 1e12 << " TB"
    : bytes >= 1e9 ? text << bytes / 1e9 << " GB"
                   : text << bytes / 1e6 << " MB";
  return text.str();
}
} // namespace

double availableMemory(const std::string& root)
{
  const std::string status = root + "/proc/self/status";
  const double machine = 1024 * numberAfter(root + "/proc/meminfo", "MemAvailable:", unlimited);
  return std::max(0.0,
    std::min({ machine, leftInGroups(root), leftOf(RLIMIT_AS, numberAfter(status, "VmSize:", 0)),
      leftOf(RLIMIT_DATA, numberAfter(status, "VmData:", 0)) }));
}

void requireMemory(double bytes, const std::string& file, const std::string& where,
  const std::string& what, const std::string& cure)
{
  const double available = bytes > littleMemory ? availableMemory() : unlimited;
  if (!(bytes <= available))
  {
    throw Error(file, where,
      what + " takes " + inWords(bytes) + " of memory, but only " + inWords(available) +
        " are available; " + cure);
  }
}
} // namespace galaxy
