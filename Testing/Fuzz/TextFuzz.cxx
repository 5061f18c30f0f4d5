#include "Testing/Fuzz/TextFuzz.h"

#include "Readers/Formats/TextFile.h"
#include "Testing/Instruction.h"

#include <sanitizer/common_interface_defs.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <utility>

// Not a byte more than any text here could need.
extern "C" const char* __asan_default_options()
{
  return "max_allocation_size_mb=256:allocator_may_return_null=0";
}

namespace galaxy
{
namespace
{
constexpr unsigned mostSeconds = 20;

/// The text that is being read, for the report of one that ends the process.
std::string current;

void printCurrent()
{
  std::fprintf(stderr, "%s\n", current.c_str());
}

void endAtAlarm(int)
{
  std::fprintf(stderr, "takes longer than %u s:\n", mostSeconds);
  printCurrent();
  _exit(EXIT_FAILURE);
}

std::string oddWord(Random& random, const std::vector<std::string>& words)
{
  static const std::vector<std::string> odd = { "1e308", "-1e308", "1e-320", "-0", "nan", "inf",
    "0x10", "2147483647", "2147483648", "-2147483648", "9223372036854775808", "1e999", "1D5", "--",
    "\"", "'", "{", "}", "[", "]", "[[", "=", ",", ",,,,", ";", ";;", "|", "&", "#", "!", "%", "\\",
    "\\\\", "//", "\t", "\r", "\n", "\xff", "\xef\xbb\xbf", "\xe2\x88\x92", "\xc2\xb0", "_2", "_",
    "(", ")", "1,5", "1,000", "*****", "1979-05-27", "\"\"\"", "-----\n", "true", "1_000",
    "12:60:1", "-0:0:1", "1:2:3", "/", ":" };
  const std::size_t at = below(random, odd.size() + words.size());
  return at < odd.size() ? odd[at] : words[at - odd.size()];
}

/// Where the cell that holds `at` begins and how long it is.
std::pair<std::size_t, std::size_t> cellAt(const std::string& text, std::size_t at)
{
  constexpr const char* ends = " \t\n,;|&=()[]";
  const std::size_t before = text.find_last_of(ends, at);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  return { start, std::min(text.find_first_of(ends, start), text.size()) - start };
}

void change(Random& random, const std::vector<std::string>& words, std::string& text)
{
  const std::size_t at = below(random, text.size());
  const auto [start, length] = cellAt(text, at);
  const std::size_t lineEnd = std::min(text.find('\n', at), text.size());
  constexpr std::size_t longest = 2000, kinds = 10;
  switch (below(random, kinds))
  {
    case 0:
      text[at] = static_cast<char>(random());
      break;
    case 1:
    case 2:
      text.replace(start, length, oddWord(random, words));
      break;
    case 3:
      text.insert(at, oddWord(random, words));
      break;
    case 4:
      text.erase(at, 1 + below(random, 9));
      break;
    case 5:
      text.resize(at);
      break;
    case 6: // a line again, or a part of one
      text.insert(at, text.substr(below(random, text.size()), 1 + below(random, 80)));
      break;
    case 7:
      text.erase(at, lineEnd - at);
      break;
    case 8: // another separator everywhere
      std::replace(text.begin(), text.end(), ' ', ";,\t|&"[below(random, 5)]);
      break;
    default: // very many cells
      text.insert(start, std::string(below(random, longest), random() % 2 ? ',' : '9'));
  }
}

/// Reads the current text; false where what came back is neither a result nor an Error.
bool tryText(const TextKind& kind, Random& random, int& read)
{
  alarm(mostSeconds);
  try
  {
    const bool sound = kind.read(current, random);
    ++read;
    return sound;
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    return saysWhatToDo(error) && printable(message) == message;
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "%s\n", exception.what());
    return false;
  }
}

bool fuzz(const TextKind& kind, int count, unsigned long long seed)
{
  int read = 0;
  for (int i = 0; i < count; ++i)
  {
    Random random(seed * 1000003 + static_cast<unsigned long long>(i));
    current = kind.samples[static_cast<std::size_t>(i) % kind.samples.size()];
    mutate(random, kind.words, current);
    if (!tryText(kind, random, read))
    {
      std::fprintf(stderr, "%s, text %d of seed %llu:\n", kind.name, i, seed);
      printCurrent();
      return false;
    }
  }
  std::printf("%s: %d texts, %d read, the others refused\n", kind.name, count, read);
  return true;
}
} // namespace

std::size_t below(Random& random, std::size_t count)
{
  return count == 0 ? 0 : random() % count;
}

void mutate(Random& random, const std::vector<std::string>& words, std::string& text)
{
  constexpr std::size_t most = 6;
  for (std::size_t changes = below(random, most); changes > 0 && !text.empty(); --changes)
  {
    change(random, words, text);
  }
}

int fuzzTexts(int argc, char* argv[], std::vector<TextKind> kinds)
{
  __sanitizer_set_death_callback(printCurrent);
  std::signal(SIGALRM, endAtAlarm);
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const unsigned long long seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  for (TextKind& kind : kinds)
  {
    for (int i = 3; i < argc; ++i)
    {
      if (std::string(argv[i]) != "none")
      {
        kind.samples.push_back(readText(argv[i]));
      }
    }
    if (!fuzz(kind, count * kind.share, seed))
    {
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}
} // namespace galaxy
