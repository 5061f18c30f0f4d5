#include "Readers/Formats/WidthTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>

namespace galaxy
{
namespace
{
bool hasNumber(const std::vector<std::string>& cells)
{
  return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
    double number;
    return parseNumber(cell, number);
  });
}
} // namespace

std::vector<WidthAtRadius> readWidthTable(const std::string& file)
{
  return parseWidthTable(readText(file), file);
}

std::vector<WidthAtRadius> parseWidthTable(const std::string& text, const std::string& file)
{
  std::vector<WidthAtRadius> rows;
  bool mayBeHeading = true;
  for (const TextLine& line : splitLines(text))
  {
    const std::vector<std::string> cells = splitCells(line.text.substr(0, line.text.find('#')));
    if (cells.empty())
    {
      continue;
    }
    const bool isHeading = mayBeHeading && !hasNumber(cells);
    mayBeHeading = false;
    if (isHeading)
    {
      continue;
    }
    const auto fail = [&](const std::string& what) {
      throw Error(file, "line " + std::to_string(line.number), what);
    };
    WidthAtRadius row;
    if (cells.size() != 2 || !parseNumber(cells[0], row.radius) || !parseNumber(cells[1], row.fwhm))
    {
      fail("must be two numbers, radius and full width in kpc");
    }
    if (!(row.radius >= 0) || !(row.fwhm >= 0))
    {
      fail("radius and full width must not be negative");
    }
    if (!rows.empty() && !(row.radius > rows.back().radius))
    {
      fail("the radius must be greater than in the row before");
    }
    rows.push_back(row);
  }
  if (rows.empty())
  {
    throw Error(file, "", "must hold rows of radius and full width in kpc");
  }
  return rows;
}
} // namespace galaxy
