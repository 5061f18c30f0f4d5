// FuzzFits COUNT SEED FILES...|none
//
// Makes COUNT broken FITS files, from small ones of every kind that it writes itself and from
// FILES, and reads each. An image or a galaxy::Error that says what to do is right; a crash,
// another exception, a sanitizer's report, more memory or more time than a small file needs is not,
// and ends the run. The file at fault stays, and its path is printed.

#include "Readers/Formats/FitsFile.h"
#include "Testing/Fuzz/FitsSamples.h"
#include "Testing/Instruction.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr std::size_t mostBytesAtOnce = std::size_t(1) << 30;
constexpr unsigned mostSeconds = 20;
constexpr std::size_t cardLength = 80;
constexpr std::size_t blockLength = 2880;

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count)
{
  return count == 0 ? 0 : random() % count;
}

const char* pick(Random& random, const std::vector<const char*>& choices)
{
  return choices[below(random, choices.size())];
}

/// The starts of the cards of all headers.
std::vector<std::size_t> cardsOf(const std::string& bytes)
{
  std::vector<std::size_t> cards;
  bool inHeader = false;
  for (std::size_t at = 0; at + cardLength <= bytes.size(); at += cardLength)
  {
    const bool starts = at % blockLength == 0 &&
      (bytes.compare(at, 8, "XTENSION") == 0 || bytes.compare(at, 8, "SIMPLE  ") == 0);
    inHeader = inHeader || starts;
    if (inHeader)
    {
      cards.push_back(at);
      inHeader = bytes.compare(at, 8, "END     ") != 0;
    }
  }
  return cards;
}

void changeValue(Random& random, std::string& bytes, std::size_t card)
{
  static const std::vector<const char*> values = { "0", "-1", "1", "2", "3", "7", "8", "16", "-32",
    "-64", "64", "99", "100", "999", "1000", "65536", "2147483647", "2147483648", "4294967297",
    "9223372036854775807", "-9223372036854775808", "1E400", "-1.5D300", "NaN", "T", "F", "''",
    "'RA---SIN'", "'DEC--SIN'", "'FREQ    '", "'VELO-LSR'", "'VOPT-F2W'", "'m/s     '",
    "'BINTABLE'", "'IMAGE   '", "'RICE_1  '", "'GZIP_1  '", "'GZIP_2  '", "'PLIO_1  '",
    "'HCOMPRESS_1'", "'1PB(0)  '", "'1QI(9)  '", "'8A      '", "'NONE    '",
    "'SUBTRACTIVE_DITHER_1'", "'no end of text", "/", "" };
  std::string value = pick(random, values);
  value.resize(std::max<std::size_t>(value.size(), 20), ' ');
  bytes.replace(card + 10, std::min(value.size(), cardLength - 10), value, 0, cardLength - 10);
}

void changeKeyword(Random& random, std::string& bytes, std::size_t card)
{
  static const std::vector<const char*> names = { "END     ", "        ", "NAXIS   ", "NAXIS1  ",
    "NAXIS3  ", "BITPIX  ", "PCOUNT  ", "GCOUNT  ", "GROUPS  ", "THEAP   ", "BSCALE  ", "BZERO   ",
    "BLANK   ", "ZIMAGE  ", "ZBITPIX ", "ZNAXIS  ", "ZNAXIS1 ", "ZTILE1  ", "ZTILE2  ", "ZVAL1   ",
    "ZVAL2   ", "ZCMPTYPE", "ZBLANK  ", "ZDITHER0", "ZSCALE  ", "ZQUANTIZ", "TFORM1  ", "TTYPE1  ",
    "CTYPE3  ", "CDELT3  ", "CONTINUE", "XTENSION", "HIERARCH" };
  bytes.replace(card, 8, pick(random, names));
}

void changeData(Random& random, std::string& bytes)
{
  static const std::vector<const char*> words = { "\xff\xff\xff\xff", "\x7f\xff\xff\xff",
    "\x80\x01\x01\x01", "\x1f\x8b\x08\x01", "\xdd\x99\x01\x01" };
  const std::size_t at = below(random, bytes.size());
  switch (below(random, 4))
  {
    case 0:
      bytes[at] = static_cast<char>(random());
      break;
    case 1:
      bytes.replace(at, 4, pick(random, words));
      break;
    case 2:
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
        std::min<std::size_t>(bytes.size() - at, 1 + below(random, 64)), '\0');
      break;
    default:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(random, 8)));
  }
}

void changeLength(Random& random, std::string& bytes)
{
  const std::size_t at = below(random, bytes.size());
  switch (below(random, 4))
  {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      bytes.erase(at / cardLength * cardLength, cardLength);
      break;
    case 2:
      bytes.insert(at / cardLength * cardLength, bytes.substr(0, cardLength));
      break;
    default:
      bytes.resize(at / blockLength * blockLength);
  }
}

void mutate(Random& random, std::string& bytes)
{
  const std::size_t changes = 1 + below(random, 4);
  for (std::size_t i = 0; i < changes && !bytes.empty(); ++i)
  {
    const std::vector<std::size_t> cards = cardsOf(bytes);
    const std::size_t kind = below(random, 10);
    if (kind < 5 && !cards.empty())
    {
      changeValue(random, bytes, cards[below(random, cards.size())]);
    }
    else if (kind == 5 && !cards.empty())
    {
      changeKeyword(random, bytes, cards[below(random, cards.size())]);
    }
    else if (kind < 9)
    {
      changeData(random, bytes);
    }
    else
    {
      changeLength(random, bytes);
    }
  }
}

galaxy::FitsSelection someSelection(Random& random)
{
  galaxy::FitsSelection selection;
  switch (below(random, 8))
  {
    case 0:
      selection.hdu = static_cast<int>(below(random, 3));
      break;
    case 1:
      selection.extension = "SCI";
      break;
    case 2:
      selection.planes = { 0, static_cast<int>(below(random, 4)) };
      break;
    case 3:
      selection.velocityRange = { -1e4, 1e4 };
      break;
    case 4:
      selection.maskValues = { 0, 3 };
      break;
    default:;
  }
  return selection;
}

/// 0 where the file is read, 1 where it is refused with an instruction; anything else ends the
/// process.
int readOne(const std::string& path, const galaxy::FitsSelection& selection)
{
  alarm(mostSeconds);
  try
  {
    const galaxy::Image image = galaxy::readFitsImage(path, selection);
    return image.values.size() == static_cast<std::size_t>(image.width) * image.height ? 0 : 3;
  }
  catch (const galaxy::Error& error)
  {
    return galaxy::saysWhatToDo(error) ? 1 : 3;
  }
}

std::string contentOf(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(in), {} };
}

/// Reads files first to last in a process of its own; tells the number read by its exit status.
int readShare(const std::vector<std::string>& samples, const std::string& path, unsigned long seed,
  long first, long last, long& read)
{
  int tube[2];
  if (pipe(tube) != 0)
  {
    return 2;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    long count = 0;
    for (long i = first; i < last; ++i)
    {
      Random random(seed * 1000003 + static_cast<unsigned long>(i));
      std::string bytes = samples[below(random, samples.size())];
      mutate(random, bytes);
      std::ofstream(path, std::ios::binary) << bytes;
      const int outcome = readOne(path, someSelection(random));
      if (outcome > 1)
      {
        _exit(outcome);
      }
      count += outcome == 0;
    }
    const bool told = write(tube[1], &count, sizeof count) == sizeof count;
    _exit(told ? 0 : 2);
  }
  close(tube[1]);
  long count = 0;
  const bool told = ::read(tube[0], &count, sizeof count) == sizeof count;
  close(tube[0]);
  read += count;
  int status = 0;
  waitpid(child, &status, 0);
  return told && WIFEXITED(status) ? WEXITSTATUS(status) : std::max(status, 1);
}
} // namespace

// Counts as a crash what a small file cannot need.
void* operator new(std::size_t size)
{
  void* memory = size > mostBytesAtOnce ? nullptr : std::malloc(size);
  if (memory == nullptr)
  {
    std::fprintf(stderr, "asks for %zu bytes at once\n", size);
    std::abort();
  }
  return memory;
}
void operator delete(void* memory) noexcept
{
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

int main(int argc, char** argv)
{
  if (argc < 4)
  {
    std::cerr << "usage: FuzzFits COUNT SEED FILES...|none\n";
    return 2;
  }
  const long count = std::atol(argv[1]);
  const unsigned long seed = std::strtoul(argv[2], nullptr, 10);
  std::string folder = (std::filesystem::temp_directory_path() / "fuzz-fits-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr)
  {
    std::cerr << "no folder for the files\n";
    return 2;
  }
  std::vector<std::string> samples = galaxy::fitsSamples(folder);
  for (int i = 3; i < argc && std::string(argv[i]) != "none"; ++i)
  {
    samples.push_back(contentOf(argv[i]));
  }
  const std::string path = folder + "/broken.fits";
  constexpr long share = 100;
  long read = 0;
  for (long first = 0; first < count; first += share)
  {
    const int outcome = readShare(samples, path, seed, first, std::min(first + share, count), read);
    if (outcome != 0)
    {
      std::cerr << "FuzzFits: failed (" << outcome << ") on " << path << ", seed " << seed
                << ", among files " << first << " to " << first + share - 1 << "\n";
      return 1;
    }
  }
  std::filesystem::remove_all(folder);
  std::cout << "FuzzFits: " << count << " files, " << read << " read, " << count - read
            << " refused\n";
  return 0;
}
