#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingUnits.h"
#include "Readers/Formats/TableCells.h"
#include "Readers/Formats/TableHeading.h"

#include <algorithm>

namespace galaxy
{
namespace
{
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

/// Gives units to the columns of a table whose names are known.
class UnitSearch
{
public:
  UnitSearch(const TableHead& head, TextTable& table)
    : head(head)
    , table(table)
  {
  }

  void find()
  {
    this->splitSharedUnit();
    bool found = !this->head.lines.empty() && this->head.lines[0].text.compare(0, 4, "ECSV") == 0;
    if (found)
    {
      return;
    }
    for (const HeadLine& line : this->head.lines)
    {
      if (line.number == this->table.headingLine)
      {
        continue;
      }
      if (line.commented ? this->isUnitComment(line) : this->mustBeUnits(line))
      {
        this->takeUnits(line);
        found = true;
      }
    }
    for (std::size_t k = 0; !found && k < this->head.lines.size(); ++k)
    {
      if (this->head.lines[k].commented)
      {
        this->readRemark(this->head.lines[k]);
      }
    }
  }

private:
  /// "r vrot Z0 i PA (kpc, km/s, kpc, deg, deg)": the last name has everybody's units.
  void splitSharedUnit()
  {
    if (this->table.columns.empty())
    {
      return;
    }
    const std::vector<std::string> units =
      unitsIn(this->table.columns.back().unit, this->head.count, blankSeparator);
    if (this->head.count > 1 && areUnits(units))
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
    const std::vector<std::string> units = unitsIn(text, this->head.count, this->head.separator);
    if (!units.empty() && areUnits(units) &&
      (labelled || knownUnits(units) > 1 || this->head.count < 3))
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
        "the units must be " + std::to_string(this->head.count) + ", one a column, not " +
          quoted(text));
    }
    return false;
  }

  /// What stands in the open beside the heading is units, unless it can be passed over.
  bool mustBeUnits(const HeadLine& line) const
  {
    const bool before = line.number < this->table.headingLine || this->table.headingLine == 0;
    return areUnits(this->head, line) ||
      (!before && !isTypes(line.text, this->head.count, this->head.separator) &&
        !isNumbering(line.text, this->head.separator));
  }

  void takeUnits(const HeadLine& line)
  {
    bool ignored = false;
    const std::string text = behindLabel(line.text, { "unit" }, &ignored);
    const std::vector<std::string> units = unitsIn(text, this->head.count, this->head.separator);
    if (units.empty())
    {
      throw Error(this->table.file, lineName(line.number),
        "must be a row of " + std::to_string(this->head.count) + " numbers, or their units, not " +
          quoted(line.text));
    }
    this->assign(units);
    this->table.unitLine = line.number;
  }

  /// "radii in kpc", "Z0: height [pc]", "all lengths in kpc"
  void readRemark(const HeadLine& line)
  {
    static const std::vector<std::string> fill = { "is", "are", "in", "given", "measured", "units",
      "unit", "of", ":", "=" };
    TableColumn named;
    if (takeNamedColumn(line.text, this->head.words, named))
    {
      this->assign(this->head.words.meaning(plainName(named.name)), named.unit);
    }
    const std::vector<std::string> cells = splitCells(line.text);
    constexpr std::size_t longest = 100;
    for (std::size_t k = 0; k < std::min(cells.size(), longest); ++k)
    {
      const TableColumn own = columnOf(cells[k], this->head.words);
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
      const std::string word = plainName(own.name);
      const bool lengths = word == "lengths" || word == "distances" || word == "sizes";
      for (const std::string& meaning : lengths
          ? this->head.words.lengths
          : std::vector<std::string>{ this->head.words.meaning(word) })
      {
        this->assign(meaning, unit);
      }
    }
  }

  /// To the columns of a meaning that have none.
  void assign(const std::string& meaning, const std::string& unit)
  {
    for (TableColumn& column : this->table.columns)
    {
      if (!meaning.empty() && column.unit.empty() && isAnyUnit(unit) &&
        meaning == this->head.words.meaning(plainName(column.name)))
      {
        column.unit = unit;
      }
    }
  }

  const TableHead& head;
  TextTable& table;
};
} // namespace

bool areUnits(const TableHead& head, const HeadLine& line)
{
  return areUnits(unitsIn(line.text, head.count, head.separator));
}

void findUnits(const TableHead& head, TextTable& table)
{
  UnitSearch(head, table).find();
}
} // namespace galaxy
