#include "Readers/Formats/TextTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/TableCells.h"
#include "Readers/Formats/TableHeading.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// Where a comment begins: at # or !, at % behind a blank, none of them in quotation marks.
std::size_t commentStart(const std::string& text)
{
  bool quotes = false;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    quotes = text[i] == '"' ? !quotes : quotes;
    const bool percent = text[i] == '%' && i > 0 && (text[i - 1] == ' ' || text[i - 1] == '\t');
    if (!quotes && (text[i] == '#' || text[i] == '!' || percent))
    {
      return i;
    }
  }
  return text.size();
}

/// A line as a comment, its marks taken off, or as what stands before one. Of IPAC and LaTeX all
/// lines with a backslash are comments; of LaTeX's the mark is a part of its words.
HeadLine classified(const TextLine& line)
{
  const std::string text = trimmed(line.text);
  const bool marked = text.find_first_of("#!%") == 0 || text.compare(0, 2, "//") == 0 ||
    (text.find(';') == 0 && text.find(';', 1) == std::string::npos);
  if (marked)
  {
    return { line.number, true,
      trimmed(text.substr(std::min(text.find_first_not_of("#!%/; \t"), text.size()))) };
  }
  if (!text.empty() && text[0] == '\\')
  {
    return { line.number, true, text };
  }
  std::string body = trimmed(text.substr(0, commentStart(text)));
  if (body.find('&') != std::string::npos)
  {
    body.erase(std::remove(body.begin(), body.end(), '$'), body.end());
  }
  const std::size_t end = body.find("\\\\");
  return { line.number, false, trimmed(body.substr(0, end)) };
}

/// The lines that say something.
std::vector<HeadLine> classifiedLines(const std::vector<TextLine>& lines)
{
  std::vector<HeadLine> said;
  for (const TextLine& line : lines)
  {
    HeadLine read = classified(line);
    if (!read.text.empty() && !isRule(read.text))
    {
      said.push_back(std::move(read));
    }
  }
  return said;
}

/// Whether a line above the first row of numbers is a row too, with cells that are no numbers.
bool isSpoiltRow(const HeadLine& line, std::size_t count, char separator)
{
  const std::vector<std::string> cells = cellsOf(line.text, separator);
  const auto numbers = std::count_if(cells.begin(), cells.end(), [](const std::string& cell) {
    double ignored;
    return parseNumber(cell, ignored);
  });
  return cells.size() == count && 2 * static_cast<std::size_t>(numbers) >= count;
}

/// Takes off the empty cells behind a separator at the end of every row, where no heading counts
/// them.
void dropEmptyEnds(const std::vector<HeadLine>& head, char separator, std::vector<TableRow>& rows)
{
  const auto ends = [](const TableRow& row) { return row.cells.back().empty(); };
  const bool named = std::any_of(head.begin(), head.end(), [&](const HeadLine& line) {
    const std::vector<std::string> cells = cellsOf(line.text, separator);
    return cells.size() == rows[0].cells.size() && !cells.back().empty();
  });
  const bool drop = !named && std::all_of(rows.begin(), rows.end(), ends);
  for (TableRow& row : rows)
  {
    row.cells.resize(row.cells.size() - (drop ? 1 : 0));
  }
}

/// Whether a first row of numbers is rather a title with a date: it has words, and not as many
/// cells as the rows below.
bool isTitle(const std::string& line, const std::string& next, char separator)
{
  const std::vector<std::string> words = cellsOf(line, blankSeparator);
  return cellsOf(line, separator).size() != cellsOf(next, separator).size() &&
    std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return !isMissing(word) && word.find_first_of("0123456789") == std::string::npos;
    });
}

/// Whether all rows have as many tabs, or commas, as a line in front of them: these cut the cells.
bool areCutAsNames(const std::vector<std::string>& rows, char mark,
  const std::vector<HeadLine>& said, std::vector<HeadLine>::const_iterator first)
{
  const auto marks = [mark](const std::string& text) {
    return std::count(text.begin(), text.end(), mark);
  };
  const auto count = rows.empty() ? 0 : marks(rows[0]);
  return count > 0 &&
    std::all_of(
      rows.begin(), rows.end(), [&](const std::string& row) { return marks(row) == count; }) &&
    std::any_of(
      said.begin(), first, [&](const HeadLine& line) { return marks(line.text) == count; });
}

/// The lines from the first row of numbers on; `head` gets those before it.
std::vector<TableRow> rowsOf(
  const std::vector<HeadLine>& said, std::vector<HeadLine>& head, char& separator)
{
  std::vector<std::string> sure;
  std::vector<std::vector<HeadLine>::const_iterator> at;
  for (auto line = said.begin(); line != said.end(); ++line)
  {
    if (!line->commented && isRowOfNumbers(line->text))
    {
      sure.push_back(line->text);
      at.push_back(line);
    }
  }
  const auto below = sure.begin() + (sure.size() > 1 ? 1 : 0);
  separator = separatorOf({ below, sure.end() });
  if (sure.size() > 1 && isTitle(sure[0], sure[1], separator))
  {
    sure.erase(sure.begin());
    at.erase(at.begin());
  }
  auto first = at.empty() ? said.end() : at[0];
  separator = separatorOf(sure);
  for (const char mark : { '\t', ',' })
  {
    separator =
      separator == blankSeparator && areCutAsNames(sure, mark, said, first) ? mark : separator;
  }
  const std::size_t count = sure.empty() ? 0 : cellsOf(sure[0], separator).size();
  while (first != said.end() && first != said.begin() && !std::prev(first)->commented &&
    isSpoiltRow(*std::prev(first), count, separator))
  {
    --first;
  }
  head.assign(said.begin(), first);
  std::vector<TableRow> rows;
  for (auto line = first; line != said.end(); ++line)
  {
    if (!line->commented)
    {
      rows.push_back({ line->number, cellsOf(line->text, separator) });
    }
  }
  return rows;
}

std::string namesOf(const TextTable& table)
{
  std::string names;
  for (const TableColumn& column : table.columns)
  {
    names += (names.empty() ? "" : " ") + column.name;
  }
  return names;
}

void checkCounts(const TextTable& table)
{
  for (const TableRow& row : table.rows)
  {
    if (!table.columns.empty() && row.cells.size() != table.columns.size())
    {
      throw Error(table.file, lineName(row.line),
        "has " + std::to_string(row.cells.size()) + " columns, must have " +
          std::to_string(table.columns.size()) +
          (table.headingLine > 0 ? ", as the heading has" : " (" + namesOf(table) + ")"));
    }
  }
}

/// The number of cells that most of the first rows have.
std::size_t usualCount(const std::vector<TableRow>& rows)
{
  constexpr std::size_t looked = 5;
  std::size_t best = 0, most = 0;
  for (std::size_t k = 0; k < std::min(rows.size(), looked); ++k)
  {
    const auto same = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.begin() + std::ptrdiff_t(std::min(rows.size(), looked)),
        [&](const TableRow& row) { return row.cells.size() == rows[k].cells.size(); }));
    best = same > most ? rows[k].cells.size() : best;
    most = std::max(same, most);
  }
  return best;
}
} // namespace

TextTable parseTextTable(
  const std::vector<TextLine>& lines, const std::string& file, const TableWords& words)
{
  TextTable table;
  table.file = file;
  if (readDescribedBytes(lines, table))
  {
    return table;
  }
  std::vector<HeadLine> head;
  char separator = blankSeparator;
  table.rows = rowsOf(classifiedLines(lines), head, separator);
  for (const HeadLine& line : head)
  {
    table.head.push_back({ line.number, line.text });
  }
  if (!table.rows.empty())
  {
    dropEmptyEnds(head, separator, table.rows);
    const TableHead above = { head, usualCount(table.rows), separator, words };
    findNames(above, table);
    readEcsvUnits(head, table);
    findUnits(above, table);
  }
  std::vector<std::vector<std::string>*> cells;
  for (TableRow& row : table.rows)
  {
    cells.push_back(&row.cells);
  }
  readDecimalCommas(cells);
  checkCounts(table);
  return table;
}
} // namespace galaxy
