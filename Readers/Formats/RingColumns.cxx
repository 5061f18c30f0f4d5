#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingHeading.h"
#include "Readers/Formats/RingText.h"
#include "Readers/Formats/TableCells.h"

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

bool has(const TextTable& table, const std::string& text)
{
  return std::any_of(table.columns.begin(), table.columns.end(),
    [&](const TableColumn& column) { return column.text == text; });
}

/// 3DBarolo writes its units like this; its model is GIPSY's GALMOD, its layers Gaussian at first.
bool isBarolo(const TextTable& table)
{
  return has(table, "VROT(km/s)") && has(table, "P.A.(deg)");
}

/// The task 2DFIT of 3DBarolo fits ROTCUR's model, with ROTCUR's sign of the expansion (see
/// RingRotcur.cxx).
bool isBaroloPlane(const TextTable& table)
{
  return has(table, "Xcenter") && has(table, "Ycenter") && has(table, "Vsys");
}

/// The names of a heading that mean nothing here.
std::string unknownNames(const TextTable& table, const RingOptions& options)
{
  const TableWords words = ringWords(options);
  std::string names;
  for (const TableColumn& column : table.columns)
  {
    if (!words.isName(plainName(column.name)))
    {
      names += (names.empty() ? "" : ", ") + quoted(column.text);
    }
  }
  return names;
}

[[noreturn]] void failAtMissing(
  const Quantity& quantity, const TextTable& table, const RingOptions& options)
{
  if (table.headingLine == 0)
  {
    const TableRow& row = table.rows[0];
    throw Error(table.file, lineName(row.line),
      "has " + std::to_string(row.cells.size()) +
        " columns, must have 5 (r vrot Z0 i PA); or give them a heading");
  }
  std::vector<std::string> names = quantity.names;
  names.insert(names.end(), quantity.lesserNames.begin(), quantity.lesserNames.end());
  std::string known;
  for (const std::string& name : names)
  {
    known += (known.empty() ? "" : ", ") + name;
  }
  const std::string unknown = unknownNames(table, options);
  throw Error(table.file, lineName(table.headingLine),
    std::string("the heading must name a column ") + quantity.symbol + " (" + known + ")" +
      (unknown.empty() ? ""
                       : "; not known here are " + unknown + "; use ring_columns = { " +
            lowered(quantity.symbol) + " = \"its name\" } in [galaxy] for one that is it"));
}

std::string placeOf(const TextTable& table, const TableColumn& column)
{
  const bool apart = table.unitLine > 0 && !column.unit.empty();
  return (apart ? lineName(table.unitLine) + ": " : "") + "column '" +
    printable(shortened(column.text, 60)) + "'";
}

std::vector<QuantityColumn> quantityColumns(const TextTable& table, const RingOptions& options)
{
  std::vector<QuantityColumn> found;
  for (const Quantity& quantity : ringQuantities())
  {
    const int index = columnOf(quantity, table, options);
    if (index < 0 && quantity.required)
    {
      failAtMissing(quantity, table, options);
    }
    if (index >= 0)
    {
      const TableColumn& column = table.columns[std::size_t(index)];
      found.push_back({ std::size_t(index), &quantity,
        unitFactor(quantity.dimension, column.unit, options, table.file, placeOf(table, column)) });
    }
  }
  return found;
}

bool isEmpty(const TableRow& row, const std::vector<QuantityColumn>& columns)
{
  return std::all_of(columns.begin(), columns.end(),
    [&](const QuantityColumn& column) { return isMissing(row.cells[column.index]); });
}

Ring ringOf(
  const TableRow& row, const std::vector<QuantityColumn>& columns, const std::string& file)
{
  Ring ring;
  for (const auto& [index, quantity, factor] : columns)
  {
    double number;
    if (!parseNumber(row.cells[index], number))
    {
      const bool comma = row.cells[index].find(',') != std::string::npos;
      throw Error(file, lineName(row.line),
        "column " + std::to_string(index + 1) + " (" + quantity->symbol +
          ") must be a finite number, not " + quoted(row.cells[index]) +
          (comma ? "; use a decimal point, and no comma for thousands" : ""));
    }
    ring.*(quantity->member) = factor * number;
  }
  return ring;
}

/// A further column; without values where none of its cells is a number.
RingColumn furtherColumn(const TextTable& table, std::size_t index)
{
  const TableColumn& heading = table.columns[index];
  const bool named = quantityOf(plainName(heading.name)) != nullptr;
  RingColumn column{ named ? heading.text : heading.name, heading.unit, {} };
  bool any = false;
  for (const TableRow& row : table.rows)
  {
    double number;
    const bool is = parseNumber(row.cells[index], number);
    column.values.push_back(is ? number : std::numeric_limits<double>::quiet_NaN());
    any = any || is;
  }
  return any && !column.name.empty() ? column : RingColumn{};
}
} // namespace

RingTable parseRingColumns(
  const std::vector<TextLine>& text, const std::string& file, const RingOptions& options)
{
  TextTable table = parseTextTable(text, file, ringWords(options));
  RingTable rings;
  rings.file = file;
  if (table.rows.empty())
  {
    return rings;
  }
  chooseGalaxy(table, options);
  std::vector<QuantityColumn> columns = quantityColumns(table, options);
  table.rows.erase(std::remove_if(table.rows.begin(), table.rows.end(),
                     [&](const TableRow& row) { return isEmpty(row, columns); }),
    table.rows.end());
  const bool plane = isBaroloPlane(table);
  rings.code = plane || isBarolo(table) ? RingCode::Rotcur : RingCode::Plain;
  rings.layerLaw = isBarolo(table) ? LayerLaw::Gaussian : LayerLaw::Sech2;
  for (QuantityColumn& column : columns)
  {
    column.factor *= plane && column.quantity->member == &Ring::expansionVelocity ? -1 : 1;
  }
  for (const TableRow& row : table.rows)
  {
    addRing(rings, ringOf(row, columns, file), lineName(row.line));
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k)
  {
    const bool used = std::any_of(columns.begin(), columns.end(),
      [&](const QuantityColumn& column) { return column.index == k; });
    RingColumn further = used ? RingColumn{} : furtherColumn(table, k);
    if (!further.values.empty())
    {
      rings.columns.push_back(std::move(further));
    }
  }
  return rings;
}
} // namespace galaxy
