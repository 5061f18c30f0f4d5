// What the task ROTCUR of GIPSY and of NEMO prints (Begeman 1989): rows of numbers under words that
// name them in their order, GIPSY's
//   radius width systemic error rotation error expansion error pos. error incli- error x-pos. ...
// and NEMO's without width or expansion. The model is
//   v = VSYS + (VROT cos t + VEXP sin t) sin i
// with t from the receding axis toward PA + 90 degrees, against the rotation of the clockwise disc
// that the table's code stands for: what it calls outward is inward there, as with DiskFit. GALMOD
// and 3DBarolo count t toward PA - 90 degrees, and their sign stays.

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingHeading.h"
#include "Readers/Formats/RingText.h"
#include "Readers/Formats/TableCells.h"

#include <algorithm>
#include <limits>
#include <map>

namespace galaxy
{
namespace
{
/// A column of the output: a quantity of the ring, or one that is kept by its name.
struct RotcurColumn
{
  double Ring::*member = nullptr;
  double factor = 1;
  std::string name, unit;
};

/// A line without the mark of a comment, and where it is none without what stands behind one.
std::string bare(const TextLine& line)
{
  const std::string text = trimmed(line.text);
  const std::size_t mark = text.find_first_of("#!");
  return mark == 0 ? trimmed(text.substr(std::min(text.find_first_not_of("#! \t"), text.size())))
                   : trimmed(text.substr(0, mark));
}

bool isComment(const TextLine& line)
{
  const std::string text = trimmed(line.text);
  return !text.empty() && (text[0] == '#' || text[0] == '!');
}

std::vector<std::string> wordsOf(const TextLine& line)
{
  return splitCells(lowered(bare(line)));
}

bool isWordHeading(const std::vector<std::string>& words)
{
  return words.size() > 2 && words[0] == "radius" &&
    (words[1] == "systemic" || (words[1] == "width" && words[2] == "systemic"));
}

bool isNemo(const std::vector<TextLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(), [](const TextLine& line) {
    const std::vector<std::string> words = wordsOf(line);
    return (!words.empty() && words[0] == "rotcur:") ||
      lowered(line.text).find("[nemo]") != std::string::npos ||
      (isWordHeading(words) && words[1] != "width");
  });
}

RotcurColumn columnOfWord(const std::string& word, const std::string& before)
{
  static const std::map<std::string, RotcurColumn> words = {
    { "radius", { &Ring::radius, 1, "", "" } },
    { "width", { nullptr, 1, "WIDTH", "" } },
    { "systemic", { &Ring::systemicVelocity, 1, "VSYS", "km/s" } },
    { "rotation", { &Ring::rotationVelocity, 1, "VROT", "km/s" } },
    { "expansion", { &Ring::expansionVelocity, -1, "VEXP", "km/s" } },
    { "pos.", { &Ring::positionAngle, 1, "PA", "deg" } },
    { "position", { &Ring::positionAngle, 1, "PA", "deg" } },
    { "incli-", { &Ring::inclination, 1, "INC", "deg" } },
    { "inclination", { &Ring::inclination, 1, "INC", "deg" } },
    { "x-pos.", { nullptr, 1, "XPOS", "grid" } },
    { "x-position", { nullptr, 1, "XPOS", "grid" } },
    { "y-pos.", { nullptr, 1, "YPOS", "grid" } },
    { "y-position", { nullptr, 1, "YPOS", "grid" } },
    { "npts", { nullptr, 1, "NPTS", "" } },
    { "npoints", { nullptr, 1, "NPTS", "" } },
    { "points", { nullptr, 1, "NPTS", "" } },
    { "sigma", { nullptr, 1, "SIGMA", "km/s" } },
  };
  if (word == "error" && !before.empty())
  {
    const RotcurColumn of = columnOfWord(before, "");
    return { nullptr, 1, "E_" + of.name, of.unit };
  }
  const auto found = words.find(word);
  return found == words.end() ? RotcurColumn{ nullptr, 1, "", "" } : found->second;
}

std::vector<RotcurColumn> columnsOf(const std::vector<std::string>& words)
{
  std::vector<RotcurColumn> columns;
  for (std::size_t k = 0; k < words.size(); ++k)
  {
    columns.push_back(columnOfWord(words[k], k > 0 ? words[k - 1] : ""));
  }
  return columns;
}

bool hasAll(const std::vector<RotcurColumn>& columns)
{
  const auto count = [&](double Ring::*member) {
    return std::count_if(columns.begin(), columns.end(),
      [&](const RotcurColumn& column) { return column.member == member; });
  };
  return count(&Ring::radius) == 1 && count(&Ring::rotationVelocity) == 1 &&
    count(&Ring::positionAngle) == 1 && count(&Ring::inclination) == 1 &&
    std::none_of(columns.begin(), columns.end(),
      [](const RotcurColumn& column) { return column.member == nullptr && column.name.empty(); });
}

/// The output of one run.
struct Output
{
  std::string unit = "arcsec"; ///< of the radius
  std::vector<RotcurColumn> columns;
  std::vector<TableRow> rows;
};

Output readOutput(const std::vector<TextLine>& lines)
{
  static const std::vector<std::string> gipsy = { "radius", "width", "systemic", "error",
    "rotation", "error", "expansion", "error", "pos.", "error", "incli-", "error", "x-pos.",
    "error", "y-pos.", "error", "npts", "sigma" };
  Output output;
  for (const TextLine& line : lines)
  {
    const std::vector<std::string> words = wordsOf(line);
    if (isWordHeading(words) && hasAll(columnsOf(words)))
    {
      output.columns = columnsOf(words);
      // Behind the named columns the numbers of points and the scatter need no names.
      const std::vector<RotcurColumn> last = { columnOfWord("npts", ""),
        columnOfWord("sigma", "") };
      if (output.columns.back().name == "E_YPOS")
      {
        output.columns.insert(output.columns.end(), last.begin(), last.end());
      }
    }
    else if (output.rows.empty() && !words.empty() && words[0][0] == '(')
    {
      const std::string text = bare(line);
      output.unit = text.substr(1, text.find(')') - 1);
    }
    else if (!isComment(line) && !words.empty() &&
      (!output.rows.empty() || isRowOfNumbers(bare(line))))
    {
      output.rows.push_back({ line.number, splitCells(bare(line)) });
    }
  }
  if (output.columns.empty() && !isNemo(lines))
  {
    output.columns = columnsOf(gipsy);
  }
  return output;
}

Ring ringOf(const TableRow& row, const Output& output, double radius, const std::string& file)
{
  constexpr std::size_t leastOfGipsy = 11;
  std::size_t least = leastOfGipsy;
  for (std::size_t k = 0; k < output.columns.size(); ++k)
  {
    least = output.columns[k].member != nullptr ? k + 1 : least;
  }
  if (row.cells.size() < least)
  {
    throw Error(file, lineName(row.line),
      "has " + std::to_string(row.cells.size()) + " columns, must have at least " +
        std::to_string(least) + " of ROTCUR");
  }
  Ring ring;
  for (std::size_t k = 0; k < least; ++k)
  {
    const RotcurColumn& column = output.columns[k];
    double number;
    if (column.member == nullptr)
    {
      continue;
    }
    if (!parseNumber(row.cells[k], number))
    {
      throw Error(file, lineName(row.line),
        "column " + std::to_string(k + 1) + " (" + (k == 0 ? "radius" : column.name) +
          ") must be a finite number, not " + quoted(row.cells[k]));
    }
    ring.*column.member = number * (column.member == &Ring::radius ? radius : column.factor);
  }
  return ring;
}

void addFurther(const Output& output, RingTable& table)
{
  for (std::size_t k = 0; k < output.columns.size(); ++k)
  {
    RingColumn column{ output.columns[k].name,
      output.columns[k].name == "WIDTH" ? output.unit : output.columns[k].unit, {} };
    bool any = false;
    for (const TableRow& row : output.rows)
    {
      double number;
      const bool is = k < row.cells.size() && parseNumber(row.cells[k], number);
      column.values.push_back(is ? number : std::numeric_limits<double>::quiet_NaN());
      any = any || is;
    }
    if (output.columns[k].member == nullptr && any)
    {
      table.columns.push_back(std::move(column));
    }
  }
}
} // namespace

bool isRotcur(const std::vector<TextLine>& lines)
{
  return std::any_of(lines.begin(), lines.end(), [](const TextLine& line) {
    const std::vector<std::string> words = wordsOf(line);
    return !words.empty() &&
      (words[0] == "rotcur" || words[0] == "rotcur:" || isWordHeading(words));
  });
}

RingTable parseRotcur(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options)
{
  const Output output = readOutput(lines);
  RingTable table;
  table.file = file;
  table.code = RingCode::Rotcur;
  if (output.columns.empty())
  {
    // NEMO's tables have a heading of short names, if any.
    const TextTable named = parseTextTable(lines, file, ringWords(options));
    if (named.headingLine == 0 && !named.rows.empty())
    {
      throw Error(file, lineName(named.rows[0].line),
        "is a table of NEMO's rotcur without names of its columns; give it a heading, such as # "
        "RAD "
        "VSYS XPOS YPOS VROT PA INC");
    }
    table = parseRingColumns(lines, file, options);
    table.code = RingCode::Rotcur;
    for (Ring& ring : table.rings)
    {
      ring.expansionVelocity *= -1;
    }
    return table;
  }
  const double radius = unitFactor(Dimension::Length, output.unit, options, file, "radius");
  for (const TableRow& row : output.rows)
  {
    addRing(table, ringOf(row, output, radius, file), lineName(row.line));
  }
  addFurther(output, table);
  return table;
}
} // namespace galaxy
