#include "Readers/Formats/TextFile.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RegularFile.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

namespace galaxy
{
namespace
{
constexpr const char* blanks = " \t\f\v";

bool startsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

[[noreturn]] void failAtNull(const std::string& bytes, std::size_t at, const std::string& file)
{
  // Latin letters have every other byte 0 in UTF-16.
  const std::size_t pairs = std::min<std::size_t>(bytes.size() / 2, 32);
  for (const std::size_t first : { 0, 1 })
  {
    std::size_t zeros = 0;
    for (std::size_t i = 0; i < pairs; ++i)
    {
      zeros += bytes[2 * i + first] == '\0';
    }
    if (2 * zeros > pairs && zeros < bytes.size() / 2 + 1 && bytes[1 - first] != '\0')
    {
      throw Error(file, "", "is UTF-16 text; save it as UTF-8");
    }
  }
  const auto line = std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(at), '\n') + 1;
  throw Error(
    file, lineName(int(line)), "holds a NUL byte, as no text does; check which file it is");
}

/// What a sign stands for where ASCII has one that means the same; null where none does.
const char* asciiFor(const std::string& text, std::size_t at, std::size_t& length)
{
  static const struct
  {
    const char* sign;
    const char* ascii;
  } signs[] = { { "\xc2\xa0", " " }, { "\xe2\x80\xaf", " " }, { "\xe3\x80\x80", " " },
    { "\xe2\x88\x92", "-" }, { "\xe2\x80\xb2", "'" }, { "\xe2\x80\xb3", "\"" },
    { "\xe2\x80\x98", "'" }, { "\xe2\x80\x99", "'" }, { "\xe2\x80\x9c", "\"" },
    { "\xe2\x80\x9d", "\"" }, { "\xe2\x80\xa6", "..." }, { "\xef\xbb\xbf", "" },
    { "\xc2\xba", "\xc2\xb0" } };
  for (const auto& [sign, ascii] : signs)
  {
    length = std::char_traits<char>::length(sign);
    if (text.compare(at, length, sign) == 0)
    {
      return ascii;
    }
  }
  length = 3;
  if (text.compare(at, 2, "\xe2\x80") == 0 && at + 2 < text.size())
  {
    const auto last = static_cast<unsigned char>(text[at + 2]);
    return last >= 0x80 && last <= 0x8a ? " " : last >= 0x90 && last <= 0x95 ? "-" : nullptr;
  }
  return nullptr;
}

std::string withAsciiSigns(const std::string& line)
{
  std::string plain;
  for (std::size_t at = 0; at < line.size();)
  {
    std::size_t length = 1;
    const char* ascii =
      static_cast<unsigned char>(line[at]) < 0x80 ? nullptr : asciiFor(line, at, length);
    plain += ascii != nullptr ? std::string(ascii) : std::string(1, line[at]);
    at += ascii != nullptr ? length : 1;
  }
  return plain;
}
} // namespace

std::string readText(const std::string& file)
{
  requireRegularFile(file);
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    throw Error(file, "", "cannot be opened; check that it may be read");
  }
  std::string bytes;
  std::string part(std::size_t(1) << 16, '\0');
  while (stream.read(part.data(), std::streamsize(part.size())) || stream.gcount() > 0)
  {
    bytes.append(part, 0, static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > mostTextBytes)
    {
      throw Error(file, "",
        "is larger than a text may be, must have at most " + std::to_string(mostTextBytes >> 20) +
          " MB; check which file it is");
    }
  }
  if (stream.bad())
  {
    throw DamagedFile(file, "", "cannot be read to its end");
  }
  return plainText(std::move(bytes), file);
}

std::string plainText(std::string bytes, const std::string& file)
{
  if (startsWith(bytes, "\xff\xfe") || startsWith(bytes, "\xfe\xff"))
  {
    throw Error(file, "", "is UTF-16 text; save it as UTF-8");
  }
  if (startsWith(bytes, "\xef\xbb\xbf"))
  {
    bytes.erase(0, 3);
  }
  const std::string format = foreignFormat(bytes);
  if (!format.empty())
  {
    throw Error(file, "", "is " + format);
  }
  const std::size_t null = bytes.find('\0');
  if (null != std::string::npos)
  {
    failAtNull(bytes, null, file);
  }
  std::size_t filled = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const bool dos = bytes[i] == '\r' && i + 1 < bytes.size() && bytes[i + 1] == '\n';
    if (!dos)
    {
      bytes[filled++] = bytes[i] == '\r' ? '\n' : bytes[i];
    }
  }
  bytes.resize(filled);
  return bytes;
}

std::vector<TextLine> splitLines(const std::string& text)
{
  std::vector<TextLine> lines;
  int number = 0;
  for (std::size_t start = 0; start < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    ++number;
    if (end > start)
    {
      lines.push_back({ number, withAsciiSigns(text.substr(start, end - start)) });
    }
    start = end + 1;
  }
  return lines;
}

std::string lineName(int number)
{
  return "line " + std::to_string(number);
}

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  return text;
}

std::vector<std::string> splitCells(const std::string& text)
{
  constexpr const char* separators = " \t\f\v,";
  std::vector<std::string> cells;
  std::size_t start = text.find_first_not_of(separators);
  while (start != std::string::npos)
  {
    const std::size_t end = text.find_first_of(separators, start);
    cells.push_back(text.substr(start, end - start));
    start = text.find_first_not_of(separators, end);
  }
  return cells;
}

bool parseNumber(std::string cell, double& number)
{
  std::replace_if(
    cell.begin(), cell.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  const char* first = cell.data();
  const char* const last = first + cell.size();
  if (first != last && *first == '+' && last - first > 1 && first[1] != '-')
  {
    ++first;
  }
  const auto [end, error] = std::from_chars(first, last, number);
  return error == std::errc() && end == last && std::isfinite(number);
}
} // namespace galaxy
