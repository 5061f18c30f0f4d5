#include "Readers/Formats/RingTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace galaxy
{
std::vector<TextLine> splitLines(const std::string& text)
{
  std::vector<TextLine> lines;
  std::size_t start = 0;
  while (start < text.size())
  {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    lines.push_back({ static_cast<int>(lines.size()) + 1, text.substr(start, end - start) });
    const bool dos = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    start = end + (dos ? 2 : 1);
  }
  return lines;
}

std::vector<std::string> splitCells(const std::string& text)
{
  constexpr const char* separators = " \t,";
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

void checkRing(
  const Ring& ring, const Ring* before, const std::string& file, const std::string& where)
{
  if (ring.radius < 0)
  {
    throw Error(file, where, "the radius is negative");
  }
  if (before != nullptr && ring.radius < before->radius)
  {
    throw Error(file, where, "the radius is smaller than that of the ring before");
  }
  if (ring.scaleHeight < 0)
  {
    throw Error(file, where, "the scale height is negative");
  }
}

RingTable parseRingTable(const std::string& text, const std::string& file)
{
  const std::vector<TextLine> lines = splitLines(text);
  const RingTable table =
    isTirific(lines) ? parseTirific(lines, file) : parseRingColumns(lines, file);
  if (table.rings.empty())
  {
    throw Error(file, "", "holds no rings");
  }
  return table;
}

RingTable readRingTable(const std::string& file)
{
  return parseRingTable(readText(file), file);
}
} // namespace galaxy
