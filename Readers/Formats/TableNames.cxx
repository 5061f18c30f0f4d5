#include "Readers/Formats/TableHeading.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingUnits.h"
#include "Readers/Formats/TableCells.h"

#include <algorithm>
#include <cctype>

namespace galaxy
{
namespace
{
constexpr char separators[] = { ';', '|', '&', '\t', ',', wideSeparator, blankSeparator };

/// A line read as names of columns.
struct Names
{
  std::vector<TableColumn> columns;
  std::size_t known = 0;

  bool fits(std::size_t count) const { return this->columns.size() == count; }
  /// Better: with as many names as a row has cells, or with more that are known.
  bool isBetter(const Names& other, std::size_t count) const
  {
    return this->fits(count) != other.fits(count) ? this->fits(count) : this->known > other.known;
  }
};

Names namesIn(const std::vector<std::string>& cells, const TableWords& words)
{
  Names names;
  const bool ends = cells.size() > 1 && cells.back().empty();
  for (const std::string& cell : std::vector<std::string>(cells.begin(), cells.end() - ends))
  {
    names.columns.push_back(columnOf(cell, words));
    names.known += words.isName(plainName(names.columns.back().name));
  }
  return names;
}

/// The best reading of a line as a heading.
Names headingIn(const HeadLine& line, std::size_t count, char separator, const TableWords& words)
{
  const std::string text = behindLabel(line.text, { "column", "cols", "field", "names" });
  Names best = namesIn(namesOf(text, separator), words);
  for (const char other : separators)
  {
    if (other == blankSeparator || text.find(other) != std::string::npos || other == wideSeparator)
    {
      Names names = namesIn(namesOf(text, other), words);
      best = names.isBetter(best, count) ? names : best;
    }
  }
  // "r vrot Z0 i PA, all made up"
  const Names begun =
    namesIn(namesOf(text.substr(0, text.find_first_of(",;:(")), blankSeparator), words);
  return !best.fits(count) && begun.fits(count) && begun.known == count ? begun : best;
}

/// Whether a comment means its words as names of columns.
bool isHeading(const Names& names, std::size_t count, const TableWords& words)
{
  if (!names.fits(count))
  {
    return false;
  }
  const bool units = std::count_if(names.columns.begin(), names.columns.end(),
                       [](const TableColumn& column) { return isAnyUnit(column.unit); }) > 1;
  const std::string first = plainName(names.columns[0].name);
  const std::string second = count > 1 ? plainName(names.columns[1].name) : "";
  const bool prose = second == "is" || second == "in" || second == "and" || second == "=";
  return names.known > 1 || names.known == count || units ||
    ((first.size() > 2 || count == 2) && words.isName(first) && !prose);
}

/// "3: PA (deg)", "Column 3 = ...", "(3) ...": the number, and the text behind it; 0 where the line
/// reads otherwise.
std::size_t numberedColumn(const std::string& line, std::string& text)
{
  std::string small = lowered(line);
  std::size_t at = 0;
  for (const char* word : { "column", "col", "field" })
  {
    const std::string label = word;
    if (at == 0 && small.compare(0, label.size(), label) == 0)
    {
      at = label.size();
    }
  }
  at = small.find_first_not_of(" .([#", at);
  std::size_t number = 0;
  std::size_t end = std::min(at, small.size());
  for (;
       end < small.size() && std::isdigit(static_cast<unsigned char>(small[end])) && number < 1000;
       ++end)
  {
    number = 10 * number + static_cast<std::size_t>(small[end] - '0');
  }
  const std::size_t name = small.find_first_not_of(" \t)].:=-", end);
  const bool range = end + 1 < small.size() && small[end] == '-' &&
    std::isdigit(static_cast<unsigned char>(small[end + 1]));
  if (number == 0 || name == std::string::npos || name == end || range)
  {
    return 0;
  }
  text = trimmed(line.substr(name));
  return number;
}

/// A column from its line in a list: all that stands before a unit or a comma is its name where
/// that is known, else the first word.
TableColumn listedColumn(const std::string& text, const TableWords& words)
{
  const std::size_t end = std::min(text.find_first_of(",;"), text.size());
  TableColumn whole = columnOf(text.substr(0, end), words);
  if (words.isName(plainName(whole.name)))
  {
    const std::string behind = trimmed(text.substr(std::min(end + 1, text.size())));
    whole.unit = whole.unit.empty() && isAnyUnit(behind) ? behind : whole.unit;
    return whole;
  }
  const std::vector<std::string> cells = splitCells(text);
  TableColumn first = columnOf(cells.empty() ? "" : cells[0], words);
  first.text = text;
  first.unit = first.unit.empty() ? whole.unit : first.unit;
  return words.isName(plainName(first.name)) ? first : whole;
}

/// Comments that list the columns, one a line; their line is the first's.
Names listedHeading(
  const std::vector<HeadLine>& head, std::size_t count, const TableWords& words, int& lineNumber)
{
  Names names;
  names.columns.resize(count);
  std::size_t next = 1;
  for (const HeadLine& line : head)
  {
    std::string text;
    if (line.commented && next <= count && numberedColumn(line.text, text) == next)
    {
      lineNumber = next == 1 ? line.number : lineNumber;
      names.columns[next - 1] = listedColumn(text, words);
      names.known += words.isName(plainName(names.columns[next - 1].name));
      ++next;
    }
  }
  return next == count + 1 && count > 1 ? names : Names();
}

/// Comments that say what each column is, one a line: "r: radius in kpc".
Names namedHeading(const TableHead& head, int& lineNumber)
{
  Names names;
  for (const HeadLine& line : head.lines)
  {
    TableColumn column;
    if (line.commented && takeNamedColumn(line.text, head.words, column))
    {
      lineNumber = names.known == 0 ? line.number : lineNumber;
      names.columns.push_back(column);
      ++names.known;
    }
  }
  return names.fits(head.count) ? names : Names();
}

/// A line that names columns, but more or fewer than there are, or one in the open that names
/// none.
void failAtMisfit(const TableHead& head, const std::string& file)
{
  for (const HeadLine& line : head.lines)
  {
    const Names names = headingIn(line, head.count, head.separator, head.words);
    const bool means = names.known > 2 && 2 * names.known > names.columns.size();
    if (line.commented ? means : !areUnits(head, line))
    {
      throw Error(file, lineName(line.number),
        means || names.known > 1 ? "the heading names " + std::to_string(names.columns.size()) +
            " columns and the rows have " + std::to_string(head.count) +
            "; give each column its name, or put a # before what is none"
                                 : "must be a row of numbers or names of the " +
            std::to_string(head.count) + " columns, or begin with #, not " + quoted(line.text));
    }
  }
}

void useUnnamed(const TableHead& head, TextTable& table)
{
  table.columns.clear();
  for (const std::string& name : head.words.unnamed)
  {
    table.columns.push_back({ name, name, "" });
  }
  if (table.columns.size() != head.count)
  {
    table.columns.clear();
  }
}

} // namespace

std::string behindLabel(
  const std::string& text, const std::vector<std::string>& labels, bool* found)
{
  const std::string small = lowered(text);
  for (const std::string& label : labels)
  {
    const std::size_t end = small.find_first_of(":=", label.size());
    if (small.compare(0, label.size(), label) == 0 && end != std::string::npos &&
      end <= label.size() + 12)
    {
      if (found != nullptr)
      {
        *found = true;
      }
      return trimmed(text.substr(end + 1));
    }
  }
  return text;
}

bool takeNamedColumn(const std::string& line, const TableWords& words, TableColumn& column)
{
  const std::size_t mark = line.find_first_of(":=");
  if (mark == std::string::npos)
  {
    return false;
  }
  column = columnOf(line.substr(0, mark), words);
  const std::string rest = trimmed(line.substr(mark + 1));
  const std::size_t comma = rest.rfind(',');
  for (const std::string& unit : { rest, columnOf(rest, words).unit,
         comma == std::string::npos ? "" : trimmed(rest.substr(comma + 1)) })
  {
    column.unit = column.unit.empty() && isAnyUnit(unit) ? unit : column.unit;
  }
  return words.isName(plainName(column.name));
}

void findNames(const TableHead& head, TextTable& table)
{
  Names best;
  const HeadLine* at = nullptr;
  for (const HeadLine& line : head.lines)
  {
    const Names names = headingIn(line, head.count, head.separator, head.words);
    const bool may = line.commented ? isHeading(names, head.count, head.words)
                                    : names.fits(head.count) && !areUnits(head, line);
    // Names in the open rather than a comment's; of equals the first of those in the open, the last
    // of comments.
    const bool both = at != nullptr && at->commented != line.commented;
    const bool better = both && std::max(names.known, best.known) > 1
      ? names.known > 1 && (!line.commented || best.known < 2)
      : names.known > best.known || (names.known == best.known && line.commented && !both);
    if (may && (at == nullptr || better))
    {
      best = names;
      at = &line;
    }
  }
  int listLine = 0;
  Names listed = listedHeading(head.lines, head.count, head.words, listLine);
  if (listed.known == 0 && best.known == 0)
  {
    listed = namedHeading(head, listLine);
  }
  if (listed.known > 1 && listed.known >= best.known)
  {
    best = listed;
    at = nullptr;
    table.headingLine = listLine;
  }
  table.headingLine = at != nullptr ? at->number : table.headingLine;
  table.columns = best.columns;
  if (table.headingLine == 0)
  {
    failAtMisfit(head, table.file);
    useUnnamed(head, table);
  }
}

std::string plainName(const std::string& name)
{
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    if (name[i] == '\\')
    {
      while (i + 1 < name.size() && std::isalpha(static_cast<unsigned char>(name[i + 1])))
      {
        ++i;
      }
      continue;
    }
    if (std::string("${}.").find(name[i]) == std::string::npos)
    {
      plain += name[i];
    }
  }
  plain = lowered(trimmed(plain));
  std::replace_if(
    plain.begin(), plain.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  plain.erase(
    std::unique(plain.begin(), plain.end(), [](char a, char b) { return a == '_' && b == '_'; }),
    plain.end());
  return plain;
}

TableColumn columnOf(const std::string& cell, const TableWords& words)
{
  TableColumn column;
  column.text = trimmed(cell);
  column.name = column.text;
  const std::size_t open = column.text.find_first_of("([");
  const std::size_t close = column.text.find_last_of(")]");
  if (open != std::string::npos && close != std::string::npos && close > open)
  {
    column.name = trimmed(column.text.substr(0, open));
    column.unit = trimmed(column.text.substr(open + 1, close - open - 1));
    if (!column.name.empty() && column.name.back() == '/')
    {
      column.name = trimmed(column.name.substr(0, column.name.size() - 1));
    }
    return column;
  }
  const std::size_t in = column.text.find(" in ");
  if (in != std::string::npos && isAnyUnit(trimmed(column.text.substr(in + 4))))
  {
    column.name = trimmed(column.text.substr(0, in));
    column.unit = trimmed(column.text.substr(in + 4));
    return column;
  }
  // "vrot_km_s" has its unit from the second last underscore; "vrot_err" none.
  const std::string& text = column.text;
  for (std::size_t at = text.find_first_of("_/"); at != std::string::npos;
       at = text.find_first_of("_/", at + 1))
  {
    std::string unit = lowered(trimmed(text.substr(at + 1)));
    unit = unit.compare(0, 3, "in_") == 0 ? unit.substr(3) : unit;
    unit = unit == "km_s" ? "km/s" : unit;
    if (!words.isName(plainName(text)) && words.isName(plainName(text.substr(0, at))) &&
      isAnyUnit(unit))
    {
      column.name = trimmed(text.substr(0, at));
      column.unit = unit;
      break;
    }
  }
  return column;
}

} // namespace galaxy
