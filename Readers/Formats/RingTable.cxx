#include "Readers/Formats/RingTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace galaxy
{
namespace
{
/// Folds each angle to within half a turn of the one before.
void unwrap(std::vector<Ring>& rings, double Ring::*angle)
{
  for (std::size_t k = 1; k < rings.size(); ++k)
  {
    const double turns = (rings[k].*angle - rings[k - 1].*angle) / 360;
    rings[k].*angle -= 360 * std::rint(turns);
  }
}

RingTable parse(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options)
{
  if (isDiskFit(lines))
  {
    return parseDiskFit(lines, file, options);
  }
  return isTirific(lines) ? parseTirific(lines, file, options)
                          : parseRingColumns(lines, file, options);
}
} // namespace

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

std::string trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

std::string lowered(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
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
  constexpr double halfSky = 180 * 3600;
  constexpr double lightSpeed = 299792.458;
  const auto fail = [&](const char* what) { throw Error(file, where, what); };
  if (ring.radius < 0)
  {
    fail("the radius must be at least 0");
  }
  if (before != nullptr && ring.radius < before->radius)
  {
    fail("the radius must not be smaller than that of the ring before");
  }
  if (ring.scaleHeight < 0)
  {
    fail("the scale height must be at least 0");
  }
  if (!(ring.radius <= halfSky && ring.scaleHeight <= halfSky))
  {
    fail("the ring is larger than the sky; check the units of radius and scale height");
  }
  for (const double velocity : { ring.rotationVelocity, ring.expansionVelocity })
  {
    if (!(std::abs(velocity) <= lightSpeed))
    {
      fail("a velocity is greater than that of light; check its unit");
    }
  }
  for (const double angle : { ring.inclination, ring.positionAngle })
  {
    if (!(std::abs(angle) <= 3600))
    {
      fail("an angle is more than ten turns; check the columns' order");
    }
  }
}

void addRing(RingTable& table, const Ring& ring, const std::string& where)
{
  checkRing(ring, table.rings.empty() ? nullptr : &table.rings.back(), table.file, where);
  table.rings.push_back(ring);
}

RingTable parseRingTable(
  const std::string& text, const std::string& file, const RingOptions& options)
{
  RingTable table = parse(splitLines(text), file, options);
  if (table.rings.empty())
  {
    throw Error(file, "", "holds no rings; give a row for each: r vrot Z0 i PA");
  }
  unwrap(table.rings, &Ring::positionAngle);
  unwrap(table.rings, &Ring::inclination);
  if (options.layerLaw != LayerLaw::FromFile)
  {
    table.layerLaw = options.layerLaw;
  }
  return table;
}

RingTable readRingTable(const std::string& file, const RingOptions& options)
{
  return parseRingTable(readText(file), file, options);
}
} // namespace galaxy
