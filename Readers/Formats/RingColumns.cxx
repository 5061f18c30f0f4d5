#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace galaxy
{
namespace
{
/// One quantity of a ring: the headings it goes by, in small letters without dots.
struct Quantity
{
  const char* symbol;
  double Ring::*member;
  bool required;
  std::vector<std::string> names;
};

const std::vector<Quantity>& quantities()
{
  static const std::vector<Quantity> all = {
    { "r", &Ring::radius, true, { "r", "rad", "radi", "radius" } },
    { "vrot", &Ring::rotationVelocity, true, { "vrot", "rotation_velocity", "rotationvelocity" } },
    { "Z0", &Ring::scaleHeight, false, { "z0", "scale_height", "scaleheight" } },
    { "i", &Ring::inclination, true, { "i", "inc", "incl", "inclination" } },
    { "PA", &Ring::positionAngle, true, { "pa", "position_angle", "positionangle" } },
    { "SBR", &Ring::surfaceBrightness, false, { "sbr", "surface_brightness" } },
    { "vrad", &Ring::expansionVelocity, false, { "vrad", "expansion_velocity" } },
    { "vsys", &Ring::systemicVelocity, false, { "vsys", "systemic_velocity" } },
  };
  return all;
}

struct Column
{
  std::size_t index;
  const Quantity* quantity;
};

/// Which column holds what.
struct Layout
{
  RingCode code = RingCode::Plain;
  std::size_t count = 0; // columns a row has at least
  bool exact = false;    // and at most
  std::string expected;  // for messages
  std::vector<Column> columns;
};

Layout plainLayout()
{
  const std::vector<Quantity>& all = quantities();
  return { RingCode::Plain, 5, true, "5 columns (r vrot Z0 i PA)",
    { { 0, &all[0] }, { 1, &all[1] }, { 2, &all[2] }, { 3, &all[3] }, { 4, &all[4] } } };
}

Layout rotcurLayout()
{
  const std::vector<Quantity>& all = quantities();
  return { RingCode::Rotcur, 11, false, "a ROTCUR row of at least 11 columns",
    { { 0, &all[0] }, { 2, &all[7] }, { 4, &all[1] }, { 6, &all[6] }, { 8, &all[4] },
      { 10, &all[3] } } };
}

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A heading cell without dots and unit; empty where the unit is a length other than arcsec.
std::string headingName(const std::string& cell)
{
  std::string name = lower(cell);
  const std::size_t unit = name.find_first_of("([");
  if (unit != std::string::npos)
  {
    const std::string inside = name.substr(unit + 1);
    if (inside.find("pc") != std::string::npos)
    {
      return "";
    }
    name.resize(unit);
  }
  name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == '.' || c == '"'; }),
    name.end());
  return name;
}

/// The layout that a heading of as many cells as the rows have names; false where it is no heading.
bool headingLayout(const std::vector<std::string>& cells, Layout& layout)
{
  Layout named;
  named.count = cells.size();
  named.expected = std::to_string(cells.size()) + " columns, as the heading has";
  for (const Quantity& quantity : quantities())
  {
    const auto& names = quantity.names;
    const auto at = std::find_if(cells.begin(), cells.end(), [&](const std::string& cell) {
      return std::find(names.begin(), names.end(), headingName(cell)) != names.end();
    });
    if (at != cells.end())
    {
      named.columns.push_back({ static_cast<std::size_t>(at - cells.begin()), &quantity });
    }
    else if (quantity.required)
    {
      return false;
    }
  }
  layout = named;
  return true;
}

/// The text of a line in front of its comment, and the comment.
struct Line
{
  int number;
  std::vector<std::string> cells;
  std::string comment;
};

Line splitComment(const TextLine& line)
{
  const std::size_t mark = std::min(line.text.find_first_of("#!"), line.text.size());
  const std::size_t comment = line.text.find_first_not_of("#! \t", mark);
  return { line.number, splitCells(line.text.substr(0, mark)),
    comment == std::string::npos ? "" : line.text.substr(comment) };
}

bool isNumber(const std::string& cell)
{
  double ignored;
  return parseNumber(cell, ignored);
}

/// Finds the layout from comments and headings, which it takes out of the lines.
Layout recogniseLayout(std::vector<Line>& lines)
{
  const auto isRow = [](const Line& line) { return !line.cells.empty(); };
  auto row = std::find_if(lines.begin(), lines.end(), isRow);
  Layout layout = plainLayout();
  if (row == lines.end())
  {
    return layout;
  }
  if (std::none_of(row->cells.begin(), row->cells.end(), isNumber) &&
    headingLayout(row->cells, layout))
  {
    lines.erase(lines.begin(), row + 1);
    return layout;
  }
  for (auto line = lines.begin(); line != row; ++line)
  {
    const std::vector<std::string> heading = splitCells(line->comment);
    if (!heading.empty() && heading[0] == "ROTCUR")
    {
      return rotcurLayout();
    }
    if (heading.size() == row->cells.size() && headingLayout(heading, layout))
    {
      // 3DBarolo's way to write the unit; its model is GIPSY's GALMOD.
      const bool barolo = std::find(heading.begin(), heading.end(), "VROT(km/s)") != heading.end();
      layout.code = barolo ? RingCode::Rotcur : RingCode::Plain;
      return layout;
    }
  }
  return layout;
}

Ring parseRow(const Line& line, const Layout& layout, const std::string& file)
{
  const std::string where = "line " + std::to_string(line.number);
  const std::size_t count = line.cells.size();
  if (count < layout.count || (layout.exact && count > layout.count))
  {
    throw Error(file, where,
      (count < layout.count ? "too few columns: " : "too many columns: ") + std::to_string(count) +
        ", expected " + layout.expected);
  }
  Ring ring;
  for (const auto& [index, quantity] : layout.columns)
  {
    if (!parseNumber(line.cells[index], ring.*(quantity->member)))
    {
      throw Error(file, where,
        "column " + std::to_string(index + 1) + " (" + quantity->symbol +
          ") is not a finite number: '" + line.cells[index] + "'");
    }
  }
  return ring;
}
} // namespace

RingTable parseRingColumns(const std::vector<TextLine>& text, const std::string& file)
{
  std::vector<Line> lines;
  for (const TextLine& line : text)
  {
    lines.push_back(splitComment(line));
  }
  const Layout layout = recogniseLayout(lines);
  RingTable table;
  table.file = file;
  table.code = layout.code;
  for (const Line& line : lines)
  {
    if (line.cells.empty())
    {
      continue;
    }
    const Ring ring = parseRow(line, layout, file);
    checkRing(ring, table.rings.empty() ? nullptr : &table.rings.back(), file,
      "line " + std::to_string(line.number));
    table.rings.push_back(ring);
  }
  return table;
}
} // namespace galaxy
