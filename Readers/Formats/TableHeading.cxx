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

/// The text behind a word such as "Columns:", or all of it.
std::string behindLabel(
  const std::string& text, const std::vector<std::string>& labels, bool* found = nullptr)
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

std::string withoutBrackets(const std::string& cell)
{
  const std::size_t last = cell.size() - 1;
  const bool bracketed = cell.size() > 1 &&
    ((cell[0] == '(' && cell[last] == ')') || (cell[0] == '[' && cell[last] == ']'));
  return bracketed ? trimmed(cell.substr(1, last - 1)) : cell;
}

std::string withoutDash(const std::string& unit)
{
  return isMissing(unit) || unit == "1" ? "" : unit;
}

/// Words as units: a bracket holds together what stands in it, and km the s-1 behind it.
std::vector<std::string> unitWords(const std::string& text)
{
  std::vector<std::string> units;
  bool open = false;
  for (const std::string& word : cellsOf(text, blankSeparator))
  {
    const bool perSecond =
      !units.empty() && !open && lowered(units.back()) == "km" && isAnyUnit("km " + word);
    if (!units.empty() && (open || perSecond))
    {
      units.back() += " " + word;
    }
    else
    {
      units.push_back(word);
    }
    const std::string& all = units.back();
    open = std::count(all.begin(), all.end(), '(') + std::count(all.begin(), all.end(), '[') >
      std::count(all.begin(), all.end(), ')') + std::count(all.begin(), all.end(), ']');
  }
  return units;
}

/// A line as units, one a column; empty where it is none.
std::vector<std::string> unitsIn(const std::string& text, std::size_t count, char separator)
{
  for (const char cut : { separator, '|', ';', '&', '\t', ',', wideSeparator, blankSeparator })
  {
    std::vector<std::string> cells = cut == blankSeparator ? unitWords(text) : cellsOf(text, cut);
    cells.resize(cells.size() - (cells.size() == count + 1 && cells.back().empty() ? 1 : 0));
    std::transform(cells.begin(), cells.end(), cells.begin(), withoutBrackets);
    if (cells.size() == count)
    {
      return cells;
    }
  }
  return {};
}

std::size_t knownUnits(const std::vector<std::string>& units)
{
  return static_cast<std::size_t>(std::count_if(units.begin(), units.end(), isAnyUnit));
}

/// Most cells that say something say a unit.
bool areUnits(const std::vector<std::string>& units)
{
  const auto said = std::count_if(
    units.begin(), units.end(), [](const std::string& unit) { return !isMissing(unit); });
  return 2 * knownUnits(units) > static_cast<std::size_t>(said);
}

bool isTypes(const std::string& text, std::size_t count, char separator)
{
  static const std::vector<std::string> types = { "real", "double", "char", "int", "long", "float",
    "string", "bool", "boolean", "short", "r", "d", "c", "i", "l", "f", "date", "float64",
    "float32", "int64", "int32", "str", "text", "integer", "number", "numeric" };
  const std::vector<std::string> cells = unitsIn(text, count, separator);
  return !cells.empty() && std::all_of(cells.begin(), cells.end(), [](const std::string& cell) {
    return isMissing(cell) || std::find(types.begin(), types.end(), lowered(cell)) != types.end();
  });
}

/// (1) (2) (3) under the names.
bool isNumbering(const std::string& text, char separator)
{
  std::size_t next = 1;
  for (const std::string& cell : cellsOf(text, separator))
  {
    if (withoutBrackets(cell) != std::to_string(next++))
    {
      return false;
    }
  }
  return next > 2;
}

/// Finds the heading and its units.
class HeadingSearch
{
public:
  HeadingSearch(const std::vector<HeadLine>& head, std::size_t count, char separator,
    const TableWords& words, TextTable& table)
    : head(head)
    , count(count)
    , separator(separator)
    , words(words)
    , table(table)
  {
  }

  void findNames()
  {
    Names best;
    for (const HeadLine& line : this->head)
    {
      const Names names = headingIn(line, this->count, this->separator, this->words);
      const bool may = line.commented ? isHeading(names, this->count, this->words)
                                      : names.fits(this->count) && !this->isUnitLine(line);
      // Of equals the first of those in the open, the last of comments; names in the open are
      // those of the columns wherever any is known.
      const bool equal = names.known == best.known;
      if (may &&
        (this->at == nullptr || names.known > best.known ||
          (equal && line.commented && this->at->commented)))
      {
        best = names;
        this->at = &line;
      }
    }
    int listLine = 0;
    const Names listed = listedHeading(this->head, this->count, this->words, listLine);
    if (listed.known > 1 && listed.known >= best.known)
    {
      best = listed;
      this->at = nullptr;
      this->table.headingLine = listLine;
    }
    this->table.headingLine = this->at != nullptr ? this->at->number : this->table.headingLine;
    this->table.columns = best.columns;
    if (this->table.headingLine == 0)
    {
      this->failAtMisfit();
      this->useUnnamed();
    }
  }

  void findUnits()
  {
    this->splitSharedUnit();
    bool found = !this->head.empty() && this->head[0].text.compare(0, 4, "ECSV") == 0;
    if (found)
    {
      return;
    }
    for (const HeadLine& line : this->head)
    {
      if (&line == this->at)
      {
        continue;
      }
      if (line.commented ? this->isUnitComment(line) : this->mustBeUnits(line))
      {
        this->takeUnits(line);
        found = true;
      }
    }
    for (std::size_t k = 0; !found && k < this->head.size(); ++k)
    {
      this->readRemark(this->head[k]);
    }
  }

private:
  bool isUnitLine(const HeadLine& line) const
  {
    return areUnits(unitsIn(line.text, this->count, this->separator));
  }

  /// A line that names columns, but more or fewer than there are, or one in the open that names
  /// none.
  void failAtMisfit() const
  {
    for (const HeadLine& line : this->head)
    {
      const Names names = headingIn(line, this->count, this->separator, this->words);
      const bool means = names.known > 2 && 2 * names.known > names.columns.size();
      if (line.commented ? means : !this->isUnitLine(line))
      {
        throw Error(this->table.file, lineName(line.number),
          means || names.known > 1 ? "the heading names " + std::to_string(names.columns.size()) +
              " columns and the rows have " + std::to_string(this->count) +
              "; give each column its name, or put a # before what is none"
                                   : "must be a row of numbers or names of the " +
              std::to_string(this->count) + " columns, or begin with #, not " + quoted(line.text));
      }
    }
  }

  void useUnnamed()
  {
    this->table.columns.clear();
    for (const std::string& name : this->words.unnamed)
    {
      this->table.columns.push_back({ name, name, "" });
    }
    if (this->table.columns.size() != this->count)
    {
      this->table.columns.clear();
    }
  }

  /// "r vrot Z0 i PA (kpc, km/s, kpc, deg, deg)": the last name has everybody's units.
  void splitSharedUnit()
  {
    if (this->table.columns.empty())
    {
      return;
    }
    const std::vector<std::string> units =
      unitsIn(this->table.columns.back().unit, this->count, blankSeparator);
    if (this->count > 1 && areUnits(units))
    {
      this->assign(units);
    }
  }

  void assign(const std::vector<std::string>& units)
  {
    for (std::size_t k = 0; k < units.size() && k < this->table.columns.size(); ++k)
    {
      TableColumn& column = this->table.columns[k];
      const std::string unit = withoutDash(units[k]);
      column.unit = unit.empty() ? column.unit : unit;
    }
  }

  bool isUnitComment(const HeadLine& line) const
  {
    bool labelled = false;
    const std::string text = behindLabel(line.text, { "unit" }, &labelled);
    const std::vector<std::string> units = unitsIn(text, this->count, this->separator);
    if (!units.empty() && areUnits(units) && (labelled || knownUnits(units) > 1 || this->count < 3))
    {
      return true;
    }
    // Units that cannot be told to the columns may be passed over only where nothing hangs on them.
    std::vector<std::string> cells = unitWords(text);
    std::transform(cells.begin(), cells.end(), cells.begin(), withoutBrackets);
    const bool usual = std::all_of(cells.begin(), cells.end(),
      [](const std::string& unit) { return !isAnyUnit(unit) || isUsualUnit(unit); });
    const bool means = labelled || (knownUnits(cells) > 2 && areUnits(cells));
    if (means && !usual && !this->table.columns.empty())
    {
      throw Error(this->table.file, lineName(line.number),
        "the units must be " + std::to_string(this->count) + ", one a column, not " + quoted(text));
    }
    return false;
  }

  /// What stands in the open beside the heading is units, unless it can be passed over.
  bool mustBeUnits(const HeadLine& line) const
  {
    const bool before = this->at == nullptr || line.number < this->at->number;
    return this->isUnitLine(line) ||
      (!before && !isTypes(line.text, this->count, this->separator) &&
        !isNumbering(line.text, this->separator));
  }

  void takeUnits(const HeadLine& line)
  {
    bool ignored = false;
    const std::string text = behindLabel(line.text, { "unit" }, &ignored);
    const std::vector<std::string> units = unitsIn(text, this->count, this->separator);
    if (units.empty())
    {
      throw Error(this->table.file, lineName(line.number),
        "must be a row of " + std::to_string(this->count) + " numbers, or their units, not " +
          quoted(line.text));
    }
    this->assign(units);
    this->table.unitLine = line.number;
  }

  /// "radii in kpc"
  void readRemark(const HeadLine& line)
  {
    static const std::vector<std::string> fill = { "is", "are", "in", "given", "measured", "units",
      "unit", "of", ":", "=" };
    const std::vector<std::string> cells = splitCells(line.text);
    constexpr std::size_t longest = 100;
    for (std::size_t k = 0; line.commented && k < std::min(cells.size(), longest); ++k)
    {
      const TableColumn own = columnOf(cells[k], this->words);
      const std::string meaning = this->words.meaning(plainName(own.name));
      std::size_t next = k + 1;
      while (next < cells.size() &&
        std::find(fill.begin(), fill.end(), lowered(cells[next])) != fill.end())
      {
        ++next;
      }
      const bool says =
        next < cells.size() && (next > k + 1 || cells[next][0] == '(' || cells[next][0] == '[');
      std::string unit = !own.unit.empty() ? own.unit : says ? withoutBrackets(cells[next]) : "";
      unit.erase(std::min(unit.find_last_not_of(".;:") + 1, unit.size()));
      for (TableColumn& column : this->table.columns)
      {
        if (!meaning.empty() && column.unit.empty() && isAnyUnit(unit) &&
          meaning == this->words.meaning(plainName(column.name)))
        {
          column.unit = unit;
        }
      }
    }
  }

  const std::vector<HeadLine>& head;
  std::size_t count;
  char separator;
  const TableWords& words;
  TextTable& table;
  const HeadLine* at = nullptr; ///< the heading, where it is a line
};
} // namespace

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

void readHeading(const std::vector<HeadLine>& head, std::size_t count, char separator,
  const TableWords& words, TextTable& table)
{
  HeadingSearch search(head, count, separator, words, table);
  search.findNames();
  readEcsvUnits(head, table);
  search.findUnits();
}
} // namespace galaxy
