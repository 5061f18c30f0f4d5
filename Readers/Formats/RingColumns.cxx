#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingHeading.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// A column that becomes a quantity of the rings.
struct QuantityColumn
{
  std::size_t index;
  const Quantity* quantity;
  double factor;
};

/// A column that is kept by its name.
struct ExtraColumn
{
  std::size_t index;
  std::string name;
  std::string unit;
};

/// Which column holds what.
struct Layout
{
  RingCode code = RingCode::Plain;
  LayerLaw law = LayerLaw::Sech2;
  std::size_t count = 0; // columns a row has at least
  bool exact = false;    // and at most
  std::string expected;  // for messages
  std::vector<QuantityColumn> quantities;
  std::vector<ExtraColumn> extras;
};

/// A line's cells in front of its comment, and the comment.
struct Line
{
  int number;
  std::string text;
  std::vector<std::string> cells;
  std::string comment;
};

Line splitComment(const TextLine& line)
{
  const std::size_t mark = std::min(line.text.find_first_of("#!"), line.text.size());
  const std::size_t comment = line.text.find_first_not_of("#! \t", mark);
  const std::string text = trimmed(line.text.substr(0, mark));
  return { line.number, text, splitRow(text),
    comment == std::string::npos ? "" : trimmed(line.text.substr(comment)) };
}

bool isNumber(const std::string& cell)
{
  double ignored;
  return parseNumber(cell, ignored);
}

/// The rows of numbers, and what stands in front of the first.
struct Table
{
  std::string file;
  std::vector<Line> head;
  std::vector<Line> rows;
};

Table splitTable(const std::vector<TextLine>& text, const std::string& file)
{
  Table table;
  table.file = file;
  for (const TextLine& textLine : text)
  {
    const Line line = splitComment(textLine);
    const bool isRow = !table.rows.empty()
      ? !line.cells.empty()
      : std::any_of(line.cells.begin(), line.cells.end(), isNumber);
    if (isRow)
    {
      table.rows.push_back(line);
    }
    else if (table.rows.empty())
    {
      table.head.push_back(line);
    }
  }
  return table;
}

Layout plainLayout()
{
  const std::vector<Quantity>& all = ringQuantities();
  Layout layout;
  layout.count = 5;
  layout.exact = true;
  layout.expected = "5 (r vrot Z0 i PA)";
  for (std::size_t k = 0; k < layout.count; ++k)
  {
    layout.quantities.push_back({ k, &all[k], 1 });
  }
  return layout;
}

/// ROTCUR's columns always stand in the same order; the line of units in brackets tells the
/// radius'. Its model is v = VSYS + (VROT cos t + VEXP sin t) sin i with t from the receding axis
/// toward PA + 90 degrees (Begeman 1989), against the rotation of the clockwise disc that the
/// table's code stands for: what it calls outward is inward there, as with DiskFit. GALMOD and
/// 3DBarolo count t toward PA - 90 degrees, and their sign stays.
Layout rotcurLayout(const Table& table, const RingOptions& options)
{
  double radius = 1;
  std::string unit = "arcsec";
  for (const Line& line : table.head)
  {
    const std::string& text = line.comment.empty() ? line.text : line.comment;
    if (!text.empty() && text[0] == '(')
    {
      unit = text.substr(1, text.find(')') - 1);
      radius = unitFactor(Dimension::Length, unit, options, table.file, "radius");
      break;
    }
  }
  const std::vector<Quantity>& all = ringQuantities();
  Layout layout;
  layout.code = RingCode::Rotcur;
  layout.count = 11;
  layout.expected = "at least 11 of ROTCUR";
  layout.quantities = { { 0, &all[0], radius }, { 2, &all[7], 1 }, { 4, &all[1], 1 },
    { 6, &all[6], -1 }, { 8, &all[4], 1 }, { 10, &all[3], 1 } };
  layout.extras = { { 1, "WIDTH", unit }, { 3, "E_VSYS", "km/s" }, { 5, "E_VROT", "km/s" },
    { 7, "E_VEXP", "km/s" }, { 9, "E_PA", "deg" }, { 11, "E_INC", "deg" }, { 12, "XPOS", "grid" },
    { 13, "E_XPOS", "grid" }, { 14, "YPOS", "grid" }, { 15, "E_YPOS", "grid" }, { 16, "NPTS", "" },
    { 17, "SIGMA", "km/s" } };
  return layout;
}

/// True where the line is of ROTCUR's heading, commented out or not.
bool isRotcurHeading(const Line& line)
{
  const std::vector<std::string> words =
    splitCells(lowered(line.comment.empty() ? line.text : line.comment));
  return !words.empty() &&
    (words[0] == "rotcur" ||
      (words.size() > 2 && words[0] == "radius" && words[1] == "width" && words[2] == "systemic"));
}

/// The heading that stands for a quantity: an angular length rather than one that was derived from
/// it by the program's own distance; null where none does.
const Heading* headingOf(const Quantity& quantity, const std::vector<Heading>& headings)
{
  const Heading* best = nullptr;
  for (const Heading& heading : headings)
  {
    if (heading.quantity == &quantity &&
      (best == nullptr ||
        (quantity.dimension == Dimension::Length && !isAngularLength(best->unit) &&
          isAngularLength(heading.unit))))
    {
      best = &heading;
    }
  }
  return best;
}

/// The headings of a line, units from an ECSV header where they have none.
std::vector<Heading> headingsOf(
  const std::string& text, const std::map<std::string, std::string>& units)
{
  std::vector<Heading> headings;
  for (const std::string& cell : splitHeadings(text))
  {
    Heading heading = parseHeading(cell);
    const auto unit = units.find(heading.name);
    if (heading.unit.empty() && unit != units.end())
    {
      heading.unit = unit->second;
    }
    headings.push_back(heading);
  }
  return headings;
}

/// The quantity that the headings must name and do not; null where all are there.
const Quantity* missingQuantity(const std::vector<Heading>& headings)
{
  for (const Quantity& quantity : ringQuantities())
  {
    if (quantity.required && headingOf(quantity, headings) == nullptr)
    {
      return &quantity;
    }
  }
  return nullptr;
}

Layout namedLayout(
  const std::vector<Heading>& headings, const RingOptions& options, const std::string& file)
{
  Layout layout;
  layout.count = headings.size();
  layout.exact = true;
  layout.expected = std::to_string(headings.size()) + ", as the heading has";
  for (const Heading& heading : headings)
  {
    const auto index = static_cast<std::size_t>(&heading - headings.data());
    const Quantity* quantity = heading.quantity;
    if (quantity != nullptr && headingOf(*quantity, headings) == &heading)
    {
      layout.quantities.push_back({ index, quantity,
        unitFactor(
          quantity->dimension, heading.unit, options, file, "column '" + heading.text + "'") });
    }
    else
    {
      layout.extras.push_back(
        { index, quantity != nullptr ? heading.text : heading.name, heading.unit });
    }
  }
  const auto has = [&](const char* text) {
    return std::any_of(headings.begin(), headings.end(),
      [&](const Heading& heading) { return heading.text == text; });
  };
  // 3DBarolo writes its units like this; its model is GIPSY's GALMOD, its layers Gaussian at first.
  if (has("VROT(km/s)") && has("P.A.(deg)"))
  {
    layout.code = RingCode::Rotcur;
    layout.law = LayerLaw::Gaussian;
  }
  return layout;
}

/// The layout that the lines in front of the rows tell.
Layout recogniseLayout(const Table& table, const RingOptions& options)
{
  if (std::any_of(table.head.begin(), table.head.end(), isRotcurHeading))
  {
    return rotcurLayout(table, options);
  }
  std::vector<std::string> comments;
  for (const Line& line : table.head)
  {
    comments.push_back(line.comment);
  }
  const auto units = ecsvUnits(comments);
  const std::size_t columns = table.rows.empty() ? 0 : table.rows[0].cells.size();
  for (auto line = table.head.rbegin(); line != table.head.rend(); ++line)
  {
    const bool commented = line->cells.empty();
    const std::vector<Heading> headings = headingsOf(commented ? line->comment : line->text, units);
    const Quantity* missing = missingQuantity(headings);
    if (!commented && missing != nullptr)
    {
      throw Error(table.file, "line " + std::to_string(line->number),
        std::string("the heading must name a column ") + missing->symbol);
    }
    if (missing == nullptr && (!commented || headings.size() == columns))
    {
      return namedLayout(headings, options, table.file);
    }
  }
  return plainLayout();
}

Ring parseRow(const Line& line, const Layout& layout, const std::string& file)
{
  const std::string where = "line " + std::to_string(line.number);
  const std::size_t count = line.cells.size();
  if (count < layout.count || (layout.exact && count > layout.count))
  {
    throw Error(
      file, where, "has " + std::to_string(count) + " columns, must have " + layout.expected);
  }
  Ring ring;
  for (const auto& [index, quantity, factor] : layout.quantities)
  {
    double number;
    if (!parseNumber(line.cells[index], number))
    {
      throw Error(file, where,
        "column " + std::to_string(index + 1) + " (" + quantity->symbol +
          ") must be a finite number, not '" + line.cells[index] + "'");
    }
    ring.*(quantity->member) = factor * number;
  }
  return ring;
}

/// A further column; without values where none of its cells is a number.
RingColumn readExtra(const ExtraColumn& extra, const std::vector<Line>& rows)
{
  RingColumn column{ extra.name, extra.unit, {} };
  bool any = false;
  for (const Line& row : rows)
  {
    double number;
    const bool is = extra.index < row.cells.size() && parseNumber(row.cells[extra.index], number);
    column.values.push_back(is ? number : std::numeric_limits<double>::quiet_NaN());
    any = any || is;
  }
  return any ? column : RingColumn{};
}
} // namespace

RingTable parseRingColumns(
  const std::vector<TextLine>& text, const std::string& file, const RingOptions& options)
{
  const Table rows = splitTable(text, file);
  const Layout layout = recogniseLayout(rows, options);
  RingTable table;
  table.file = file;
  table.code = layout.code;
  table.layerLaw = layout.law;
  for (const Line& line : rows.rows)
  {
    addRing(table, parseRow(line, layout, file), "line " + std::to_string(line.number));
  }
  for (const ExtraColumn& extra : layout.extras)
  {
    RingColumn column = readExtra(extra, rows.rows);
    if (!column.values.empty())
    {
      table.columns.push_back(std::move(column));
    }
  }
  return table;
}
} // namespace galaxy
