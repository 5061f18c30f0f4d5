#include "Readers/Formats/NumberTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingHeading.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>

namespace galaxy
{
NumberTable::NumberTable(const std::string& text, const std::string& file)
  : file(file)
{
  for (const TextLine& line : splitLines(text))
  {
    const std::vector<std::string> cells =
      splitRow(trimmed(line.text.substr(0, line.text.find('#'))));
    if (cells.empty())
    {
      continue;
    }
    if (this->names.empty())
    {
      for (const std::string& cell : cells)
      {
        this->names.push_back(lowered(cell));
      }
      continue;
    }
    this->rows.push_back({ line.number, cells });
    if (cells.size() != this->names.size())
    {
      this->fail(this->rows.size() - 1,
        "has " + std::to_string(cells.size()) + " columns, must have " +
          std::to_string(this->names.size()) + ", as the heading has");
    }
  }
  if (this->rows.empty())
  {
    throw Error(file, "", "must hold rows under a heading");
  }
}

bool NumberTable::has(const std::string& column) const
{
  return std::find(this->names.begin(), this->names.end(), column) != this->names.end();
}

double NumberTable::number(std::size_t row, const std::string& column, const Range& range) const
{
  const auto name = std::find(this->names.begin(), this->names.end(), column);
  if (name == this->names.end())
  {
    throw Error(this->file, "", "the heading must name a column " + column);
  }
  const std::string& cell = this->rows[row].cells[name - this->names.begin()];
  double number;
  if (!parseNumber(cell, number))
  {
    this->fail(row, column + " must be a finite number, not '" + cell + "'");
  }
  if (!range.contains(number))
  {
    this->fail(row, column + " must be " + range.text());
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
  throw Error(this->file, "line " + std::to_string(this->rows[row].line), what);
}
} // namespace galaxy
