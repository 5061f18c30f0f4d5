#include "Readers/Formats/TableCells.h"

#include "Readers/Formats/Sexagesimal.h"
#include "Readers/Formats/TextFile.h"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace galaxy
{
namespace
{
bool isBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

bool isNumber(const std::string& cell)
{
  double ignored;
  return parseNumber(cell, ignored);
}

std::size_t countOf(const std::string& text, char c)
{
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

/// A cell in quotation marks that begins at `at`: its content, and `at` behind it. A doubled mark
/// is one. False where no mark closes it at a cell's end.
bool takeQuoted(const std::string& line, char separator, std::size_t& at, std::string& cell)
{
  const char mark = line[at];
  cell.clear();
  for (std::size_t i = at + 1; i < line.size(); ++i)
  {
    if (line[i] != mark)
    {
      cell += line[i];
    }
    else if (i + 1 < line.size() && line[i + 1] == mark)
    {
      cell += line[i++];
    }
    else
    {
      const bool ends = i + 1 == line.size() || line[i + 1] == separator || isBlank(line[i + 1]) ||
        (separator == blankSeparator && line[i + 1] == ',');
      at = ends ? i + 1 : at;
      return ends;
    }
  }
  return false;
}

/// Digits, one comma, digits.
bool hasDecimalComma(const std::string& cell)
{
  const std::size_t comma = cell.find(',');
  const auto digit = [&](std::size_t i) {
    return i < cell.size() && std::isdigit(static_cast<unsigned char>(cell[i]));
  };
  if (comma == std::string::npos || comma == 0 || !digit(comma - 1) || !digit(comma + 1))
  {
    return false;
  }
  std::string pointed = cell;
  pointed[comma] = '.';
  return isNumber(pointed);
}

/// 1,200 may be a number in thousands; 0,200 and 1,20 may not.
bool mayBeThousands(const std::string& cell)
{
  const std::size_t first = cell.find_first_of("0123456789");
  const std::size_t comma = cell.find(',');
  const std::size_t last = cell.find_first_not_of("0123456789", comma + 1);
  return cell[first] != '0' && comma - first <= 3 &&
    (last == std::string::npos ? cell.size() : last) - comma == 4;
}

void addWord(std::vector<std::string>& cells, const std::string& word)
{
  if (hasDecimalComma(word))
  {
    cells.push_back(word);
    return;
  }
  for (const std::string& cell : splitCells(word))
  {
    cells.push_back(cell);
  }
}

std::vector<std::string> wordsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t at = 0; at < line.size();)
  {
    if (isBlank(line[at]) || line[at] == ',')
    {
      ++at;
    }
    else if ((line[at] == '"' || line[at] == '\'') && takeQuoted(line, blankSeparator, at, cell))
    {
      cells.push_back(cell);
    }
    else
    {
      const std::size_t end = std::min(line.find_first_of(" \t\f\v", at), line.size());
      addWord(cells, line.substr(at, end - at));
      at = end;
    }
  }
  return cells;
}

std::vector<std::string> wideCellsOf(const std::string& line)
{
  std::vector<std::string> cells;
  std::size_t start = 0;
  const std::string text = trimmed(line);
  while (start < text.size())
  {
    std::size_t end = start;
    while (end < text.size() && text[end] != '\t' &&
      !(isBlank(text[end]) && end + 1 < text.size() && isBlank(text[end + 1])))
    {
      ++end;
    }
    cells.push_back(trimmed(text.substr(start, end - start)));
    start = std::min(text.find_first_not_of(" \t\f\v", end), text.size());
  }
  return cells;
}

/// Two numbers in what a separator would make one cell.
bool holdsTwoNumbers(const std::string& cell)
{
  const std::vector<std::string> words = splitCells(cell);
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    if (isNumber(words[i - 1]) && isNumber(words[i]))
    {
      return true;
    }
  }
  return false;
}

/// Whether a tab or a comma cuts all rows sensibly: into as many cells, of a number each.
bool separatesAll(const std::vector<std::string>& rows, char separator)
{
  const auto cells = [&](const std::string& row) { return cellsOf(row, separator); };
  return std::all_of(rows.begin(), rows.end(), [&](const std::string& row) {
    const std::vector<std::string> cut = cells(row);
    return countOf(row, separator) > 0 && std::none_of(cut.begin(), cut.end(), holdsTwoNumbers);
  });
}

bool needsTabs(const std::vector<std::string>& rows)
{
  return std::any_of(rows.begin(), rows.end(), [](const std::string& row) {
    const std::vector<std::string> cells = cellsOf(row, '\t');
    return std::any_of(cells.begin(), cells.end(),
      [](const std::string& cell) { return cell.empty() || cell.find(' ') != std::string::npos; });
  });
}
} // namespace

std::vector<std::string> cellsOf(const std::string& line, char separator)
{
  if (separator == blankSeparator || separator == wideSeparator)
  {
    return separator == blankSeparator ? wordsOf(line) : wideCellsOf(line);
  }
  std::vector<std::string> cells;
  std::string text = line;
  const bool framed = separator == '|' || separator == '&';
  if (framed && !trimmed(text).empty() && trimmed(text)[0] == separator && separator == '|')
  {
    text.erase(0, text.find(separator) + 1);
  }
  for (std::size_t at = 0; at <= text.size();)
  {
    while (at < text.size() && isBlank(text[at]) && text[at] != separator)
    {
      ++at;
    }
    std::string cell;
    const bool isQuoted = at < text.size() && (text[at] == '"' || text[at] == '\'') &&
      takeQuoted(text, separator, at, cell);
    const std::size_t end = std::min(text.find(separator, at), text.size());
    cells.push_back(isQuoted ? cell : trimmed(text.substr(at, end - at)));
    at = end + 1;
  }
  if (separator == '|' && cells.size() > 1 && cells.back().empty())
  {
    cells.pop_back();
  }
  return cells;
}

std::vector<std::string> namesOf(const std::string& line, char separator)
{
  std::vector<std::string> names;
  bool open = false, divided = false;
  for (const std::string& cell : cellsOf(line, separator))
  {
    const bool unit = !cell.empty() && std::strchr("([/", cell[0]) != nullptr;
    if (!names.empty() &&
      (open || divided || (unit && separator != wideSeparator) ||
        (unit && names.back().find_first_of("([") == std::string::npos)))
    {
      names.back() += (divided ? "" : " ") + cell;
    }
    else
    {
      names.push_back(cell);
    }
    const std::string& all = names.back();
    open = countOf(all, '(') + countOf(all, '[') > countOf(all, ')') + countOf(all, ']');
    divided = cell == "/";
  }
  return names;
}

char separatorOf(const std::vector<std::string>& rows)
{
  for (const char separator : { '|', '&', ';' })
  {
    if (!rows.empty() && std::all_of(rows.begin(), rows.end(), [&](const std::string& row) {
          return row.find(separator) != std::string::npos;
        }))
    {
      return separator;
    }
  }
  if (rows.empty())
  {
    return blankSeparator;
  }
  return separatesAll(rows, '\t') && needsTabs(rows) ? '\t'
    : separatesAll(rows, ',')                        ? ','
                                                     : blankSeparator;
}

bool isRowOfNumbers(const std::string& line)
{
  std::string plain = line;
  std::replace_if(
    plain.begin(), plain.end(), [](char c) { return c == ';' || c == '|' || c == '&'; }, ' ');
  std::size_t numbers = 0, words = 0;
  for (const std::string& word : wordsOf(plain))
  {
    const bool number = isNumber(word) || hasDecimalComma(word) ||
      (word.find(':') != std::string::npos && sexagesimalAngle(word, false));
    numbers += number;
    words += number || !isMissing(word);
  }
  return 2 * numbers > words;
}

bool isRule(const std::string& line)
{
  const std::string text = trimmed(line);
  return text.find_first_not_of("-=+_~*:|;,& \t") == std::string::npos &&
    text.find_first_of("-=_~*") != std::string::npos;
}

bool isMissing(const std::string& cell)
{
  static const char* const words[] = { "", "nan", "null", "none", "n/a", "na", "indef", "masked",
    "*", "\\nodata", "nodata", "undef" };
  if (cell.find_first_not_of("-.") == std::string::npos)
  {
    return true;
  }
  const std::string word = lowered(cell);
  return std::any_of(
    std::begin(words), std::end(words), [&](const char* known) { return word == known; });
}

void readDecimalCommas(std::vector<std::vector<std::string>*>& rows)
{
  std::vector<std::string*> commas;
  bool decimal = false;
  for (std::vector<std::string>* row : rows)
  {
    for (std::string& cell : *row)
    {
      if (hasDecimalComma(cell))
      {
        commas.push_back(&cell);
        decimal = decimal || !mayBeThousands(cell);
      }
    }
  }
  for (std::string* cell : commas)
  {
    if (decimal)
    {
      cell->at(cell->find(',')) = '.';
    }
  }
}
} // namespace galaxy
