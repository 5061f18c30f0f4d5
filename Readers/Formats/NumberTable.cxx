#include "Readers/Formats/NumberTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingUnits.h"
#include "Readers/Formats/Sexagesimal.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// 0 for the name, 1, 2, ... for the others; -1 where it is none of them.
int rankOf(const NumberColumn& column, const std::string& name)
{
  const auto other = std::find(column.otherNames.begin(), column.otherNames.end(), name);
  return name == column.name           ? 0
    : other == column.otherNames.end() ? -1
                                       : 1 + int(other - column.otherNames.begin());
}

TableWords wordsOf(
  const std::vector<NumberColumn>& columns, const std::vector<std::string>& unnamed)
{
  TableWords words;
  words.meaning = [&columns](const std::string& name) -> std::string {
    for (const NumberColumn& column : columns)
    {
      if (rankOf(column, name) >= 0)
      {
        return column.name;
      }
    }
    return "";
  };
  words.unnamed = unnamed;
  return words;
}

bool isHours(const std::string& unit)
{
  const std::string small = lowered(unit);
  return !small.empty() && (small[0] == 'h' || small == "\"h:m:s\"");
}

double factorTo(Measure measure, const TableColumn& column, const std::string& file, int line)
{
  const std::string where = (line > 0 ? lineName(line) + ": " : "") + "column '" +
    printable(shortened(column.text, 60)) + "'";
  const bool length = measure == Measure::Kpc || measure == Measure::Mpc;
  if (column.unit.empty() || measure == Measure::Number)
  {
    return 1;
  }
  if (length)
  {
    double kpc;
    if (!kpcOf(column.unit, kpc))
    {
      throw Error(file, where, "must be in pc, kpc or Mpc, not " + quoted(column.unit));
    }
    return measure == Measure::Kpc ? kpc : kpc / 1000;
  }
  if (measure == Measure::RightAscension && isHours(column.unit))
  {
    return 15;
  }
  const bool sexagesimal = column.unit.find(':') != std::string::npos;
  return sexagesimal ? 1 : unitFactor(Dimension::Angle, column.unit, {}, file, where);
}
} // namespace

NumberTable::NumberTable(const std::string& text, const std::string& file,
  const std::vector<NumberColumn>& columns, const std::vector<std::string>& unnamed)
  : columns(columns)
  , table(parseTextTable(splitLines(plainText(text, file)), file, wordsOf(this->columns, unnamed)))
{
  if (this->table.rows.empty())
  {
    throw Error(file, "", "must hold rows of numbers under a heading");
  }
  for (const NumberColumn& column : this->columns)
  {
    this->found.push_back(this->find(column));
  }
}

NumberTable::Found NumberTable::find(const NumberColumn& column) const
{
  Found best;
  int bestRank = -1;
  for (std::size_t k = 0; k < this->table.columns.size(); ++k)
  {
    const int rank = rankOf(column, plainName(this->table.columns[k].name));
    if (rank >= 0 && rank == bestRank)
    {
      throw Error(this->table.file, lineName(this->table.headingLine),
        "two columns are called " + quoted(this->table.columns[k].name) + "; leave one out");
    }
    if (rank >= 0 && (bestRank < 0 || rank < bestRank))
    {
      best.index = static_cast<int>(k);
      bestRank = rank;
    }
  }
  if (best.index >= 0)
  {
    const TableColumn& heading = this->table.columns[std::size_t(best.index)];
    best.factor = factorTo(column.measure, heading, this->table.file, this->table.unitLine);
    best.hours = column.measure == Measure::RightAscension &&
      (heading.unit.find(':') == std::string::npos || isHours(heading.unit));
  }
  return best;
}

int NumberTable::indexOf(const std::string& name) const
{
  return this->found[std::size_t(&this->column(name) - this->columns.data())].index;
}

const NumberColumn& NumberTable::column(const std::string& name) const
{
  return *std::find_if(this->columns.begin(), this->columns.end(),
    [&](const NumberColumn& column) { return column.name == name; });
}

void NumberTable::failAtMissing(const NumberColumn& column) const
{
  if (this->table.headingLine == 0)
  {
    const TableRow& row = this->table.rows[0];
    throw Error(this->table.file, lineName(row.line),
      "has " + std::to_string(row.cells.size()) +
        " columns without names, must stand under a heading that names a column " + column.name);
  }
  std::string names;
  for (const TableColumn& heading : this->table.columns)
  {
    names += (names.empty() ? "" : ", ") + quoted(heading.text);
  }
  throw Error(this->table.file, lineName(this->table.headingLine),
    "the heading must name a column " + column.name + ", and names " + names);
}

double NumberTable::number(std::size_t row, const std::string& name, const Range& range) const
{
  const NumberColumn& column = this->column(name);
  const Found& found = this->found[std::size_t(&column - this->columns.data())];
  if (found.index < 0)
  {
    this->failAtMissing(column);
  }
  std::string cell = this->table.rows[row].cells[std::size_t(found.index)];
  double number;
  const bool angle =
    column.measure == Measure::Degrees || column.measure == Measure::RightAscension;
  if (parseNumber(cell, number))
  {
    number *= found.factor;
  }
  else
  {
    std::replace(cell.begin(), cell.end(), ' ', ':');
    const std::optional<double> degrees =
      angle ? sexagesimalAngle(cell, found.hours) : std::nullopt;
    if (!degrees)
    {
      this->fail(row,
        name + " must be a finite number, not " +
          quoted(this->table.rows[row].cells[std::size_t(found.index)]));
    }
    number = *degrees;
  }
  if (!range.contains(number))
  {
    this->fail(row, name + " " + range.complaint(number));
  }
  return number;
}

double NumberTable::number(
  std::size_t row, const std::string& column, const Range& range, double otherwise) const
{
  return this->has(column) ? this->number(row, column, range) : otherwise;
}

void NumberTable::fail(std::size_t row, const std::string& what) const
{
  throw Error(this->table.file, lineName(this->table.rows[row].line), what);
}
} // namespace galaxy
