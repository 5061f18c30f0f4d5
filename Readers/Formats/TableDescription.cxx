// Tables that describe their columns by a standard: ECSV (astropy APE 6) and the byte-by-byte
// description of CDS and AAS (http://cdsarc.u-strasbg.fr/doc/catstd.htx, section 3.2).

#include "Readers/Formats/TableCells.h"
#include "Readers/Formats/TableHeading.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace galaxy
{
namespace
{
/// The value of `key` in a line of YAML's flow style, {key: value, ...}, or block style, key:
/// value.
std::string yamlValue(const std::string& line, const std::string& key)
{
  std::size_t at = line.find(key + ":");
  while (at != std::string::npos && at > 0 && line[at - 1] != ' ' && line[at - 1] != '{')
  {
    at = line.find(key + ":", at + 1);
  }
  if (at == std::string::npos)
  {
    return "";
  }
  const std::size_t start = std::min(line.find_first_not_of(' ', at + key.size() + 1), line.size());
  const bool quotes = start < line.size() && (line[start] == '"' || line[start] == '\'');
  const std::size_t end = quotes ? std::min(line.find(line[start], start + 1), line.size())
                                 : std::min(line.find_first_of(",}", start), line.size());
  return trimmed(line.substr(start + (quotes ? 1 : 0), end - start - (quotes ? 1 : 0)));
}

/// A column of the description, its bytes counted from 1.
struct ByteColumn
{
  std::size_t first = 0;
  std::size_t last = 0;
  TableColumn column;
  std::string null; ///< what stands for no value
};

std::string nullIn(const std::string& explanation)
{
  const std::size_t at = explanation.find("?=");
  const std::vector<std::string> cells =
    splitCells(at == std::string::npos ? "" : explanation.substr(at + 2));
  return cells.empty() ? "" : cells[0];
}

/// "   1-  5 F5.1 arcsec r  Radius"; false where the line is none of these.
bool takeByteColumn(const std::string& line, ByteColumn& out)
{
  std::istringstream in(line);
  char dash = 0;
  std::string format, rest;
  if (!(in >> out.first) || out.first == 0)
  {
    return false;
  }
  out.last = out.first;
  in >> std::ws;
  if (in.peek() == '-' && !(in >> dash >> out.last))
  {
    return false;
  }
  constexpr std::size_t longestLine = 100000;
  if (!(in >> format >> out.column.unit >> out.column.name) || out.last < out.first ||
    out.last > longestLine || std::string("AIFEDaifed").find(format[0]) == std::string::npos)
  {
    return false;
  }
  std::getline(in, rest);
  out.null = nullIn(rest);
  out.column.text = out.column.name;
  out.column.unit = isMissing(out.column.unit) ? "" : out.column.unit;
  return true;
}

bool isDashes(const std::string& line)
{
  constexpr std::size_t least = 10;
  const std::string text = trimmed(line);
  return text.size() >= least && text.find_first_not_of("-=") == std::string::npos;
}

std::vector<std::string> cutBytes(const std::string& line, const std::vector<ByteColumn>& columns)
{
  std::vector<std::string> cells;
  for (const ByteColumn& column : columns)
  {
    const std::size_t first = std::min(column.first - 1, line.size());
    std::string cell = trimmed(line.substr(first, column.last - first));
    double value = 0, null = 0;
    const bool isNull = !column.null.empty() &&
      (cell == column.null ||
        (parseNumber(cell, value) && parseNumber(column.null, null) && value == null));
    cells.push_back(isNull ? "" : cell);
  }
  return cells;
}
} // namespace

void readEcsvUnits(const std::vector<HeadLine>& head, TextTable& table)
{
  std::string name;
  for (const HeadLine& line : head)
  {
    const bool starts = line.text.compare(0, 2, "- ") == 0;
    if (!line.commented || (name.empty() && !starts))
    {
      continue;
    }
    name = starts ? yamlValue(line.text, "name") : name;
    const std::string unit = yamlValue(line.text, "unit");
    for (TableColumn& column : table.columns)
    {
      if (column.text == name && !unit.empty())
      {
        column.name = name;
        column.unit = unit;
      }
    }
  }
}

bool readDescribedBytes(const std::vector<TextLine>& lines, TextTable& table)
{
  const auto title = std::find_if(lines.begin(), lines.end(), [](const TextLine& line) {
    return lowered(line.text).find("byte-by-byte") != std::string::npos;
  });
  if (title == lines.end())
  {
    return false;
  }
  const auto last = std::find_if(
    lines.rbegin(), lines.rend(), [](const TextLine& line) { return isDashes(line.text); });
  const auto data = last.base();
  std::vector<ByteColumn> columns;
  for (auto line = title; line < data; ++line)
  {
    ByteColumn column;
    if (takeByteColumn(line->text, column))
    {
      columns.push_back(column);
      table.columns.push_back(column.column);
    }
  }
  table.headingLine = title->number;
  for (auto line = data; line != lines.end() && data > title; ++line)
  {
    if (!trimmed(line->text).empty())
    {
      table.rows.push_back({ line->number, cutBytes(line->text, columns) });
    }
  }
  return !columns.empty();
}
} // namespace galaxy
