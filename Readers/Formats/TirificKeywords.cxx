#include "Readers/Formats/TirificKeywords.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/Sexagesimal.h"

#include <algorithm>
#include <cctype>

namespace galaxy
{
namespace
{
bool isLetter(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool isBlank(char c)
{
  return c == ' ' || c == '\t';
}

/// Where the next KEYWORD= begins, its name, and where its value begins; npos where there is none.
std::size_t nextKeyword(
  const std::string& text, std::size_t from, std::string& name, std::size_t& value)
{
  for (std::size_t equals = text.find('=', from); equals != std::string::npos;
       equals = text.find('=', equals + 1))
  {
    std::size_t end = equals;
    while (end > from && isBlank(text[end - 1]))
    {
      --end;
    }
    std::size_t start = end;
    while (start > from && isLetter(text[start - 1]))
    {
      --start;
    }
    if (start < end && (start == 0 || isBlank(text[start - 1])))
    {
      name = text.substr(start, end - start);
      std::transform(name.begin(), name.end(), name.begin(),
        [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      value = equals + 1;
      return start;
    }
  }
  return std::string::npos;
}

bool isNumber(const std::string& cell)
{
  double ignored;
  return parseNumber(cell, ignored);
}

bool beginsAsValues(const std::string& text)
{
  std::string name;
  std::size_t value;
  const std::vector<std::string> cells = splitCells(text);
  return nextKeyword(text, 0, name, value) == 0 || (!cells.empty() && isNumber(cells[0]));
}

/// The line without # ... #, and the backslash that promises another. A line that begins with # is
/// a comment to its end, unless values follow a second one.
std::string withoutComments(const std::string& line)
{
  std::string text;
  bool comment = false;
  for (const char c : line)
  {
    comment = c == '#' ? !comment : comment;
    text += c == '#' ? ' ' : comment ? '\0' : c;
  }
  text.erase(std::remove(text.begin(), text.end(), '\0'), text.end());
  text = trimmed(text);
  const std::string whole = trimmed(line);
  if (!whole.empty() && whole[0] == '#' &&
    (whole.compare(0, 2, "##") == 0 || !beginsAsValues(text)))
  {
    return "";
  }
  return !text.empty() && text.back() == '\\' ? trimmed(text.substr(0, text.size() - 1)) : text;
}

/// A keyword whose = was forgotten: one word of capitals.
bool isBareKeyword(const std::vector<std::string>& cells)
{
  return cells.size() == 1 &&
    std::all_of(cells[0].begin(), cells[0].end(),
      [](char c) { return isLetter(c) && !std::islower(static_cast<unsigned char>(c)); }) &&
    !isNumber(cells[0]);
}
} // namespace

bool isTirific(const std::vector<TextLine>& lines)
{
  static const std::vector<std::string> telling = { "RADI", "NUR", "NDISKS", "VROT", "INCL",
    "SBR" };
  return std::any_of(lines.begin(), lines.end(), [](const TextLine& line) {
    const std::string text = withoutComments(line.text);
    std::string name;
    std::size_t value = 0;
    return text.find('!') == std::string::npos && nextKeyword(text, 0, name, value) == 0 &&
      std::find(telling.begin(), telling.end(), name.substr(0, name.find('_'))) != telling.end();
  });
}

TirificKeywords::TirificKeywords(const std::vector<TextLine>& lines, const std::string& file)
  : file(file)
{
  for (const TextLine& line : lines)
  {
    const std::string text = withoutComments(line.text);
    this->add({ line.number, text });
    const std::string comment = trimmed(line.text);
    std::string name;
    std::size_t value = 0;
    if (text.empty() && !comment.empty() &&
      nextKeyword(trimmed(comment.substr(1)), 0, name, value) == 0)
    {
      Values& values = this->comments[name];
      values = { line.number, {} };
      for (const std::string& cell : splitCells(trimmed(comment.substr(1)).substr(value)))
      {
        values.cells.push_back({ line.number, cell });
      }
    }
  }
}

/// Takes a line: what stands before its first KEYWORD= belongs to the one before.
void TirificKeywords::add(const TextLine& line)
{
  std::string name, following;
  std::size_t value = 0, nextValue = 0;
  std::size_t start = nextKeyword(line.text, 0, name, value);
  this->addValues({ line.number, line.text.substr(0, start) });
  while (start != std::string::npos)
  {
    const std::size_t next = nextKeyword(line.text, value, following, nextValue);
    this->open = &(this->all[name] = { line.number, {} });
    this->addValues(
      { line.number, line.text.substr(value, std::min(next, line.text.size()) - value) });
    start = next;
    name = following;
    value = nextValue;
  }
}

void TirificKeywords::addValues(const TextLine& line)
{
  const std::vector<std::string> cells = splitCells(line.text);
  if (cells.empty())
  {
    return;
  }
  const bool continues = this->open != nullptr && this->open->line != line.number;
  const bool numbers = continues && !this->open->cells.empty() &&
    std::all_of(this->open->cells.begin(), this->open->cells.end(),
      [](const Cell& cell) { return isNumber(cell.text); });
  if (this->open == nullptr ||
    (continues && (isBareKeyword(cells) || (numbers && !isNumber(cells[0])))))
  {
    throw Error(this->file, lineName(line.number),
      "must be KEYWORD= values or a # comment, not " + quoted(trimmed(line.text)));
  }
  for (const std::string& cell : cells)
  {
    this->open->cells.push_back({ line.number, cell });
  }
}

template <class Parse>
std::vector<double> TirificKeywords::parsed(const std::string& keyword, const Parse& parse) const
{
  std::vector<double> numbers;
  const auto found = this->all.find(keyword);
  if (found == this->all.end())
  {
    return numbers;
  }
  for (const Cell& cell : found->second.cells)
  {
    const std::optional<double> number = parse(cell.text);
    if (!number)
    {
      throw Error(this->file, lineName(cell.line) + ": " + keyword,
        "value " + std::to_string(numbers.size() + 1) + " must be a finite number, not " +
          quoted(cell.text));
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> TirificKeywords::numbers(const std::string& keyword) const
{
  return this->parsed(keyword, [](const std::string& cell) {
    double number;
    return parseNumber(cell, number) ? std::optional<double>(number) : std::nullopt;
  });
}

std::vector<double> TirificKeywords::angles(const std::string& keyword, bool colonsAreHours) const
{
  return this->parsed(
    keyword, [=](const std::string& cell) { return angleOf(cell, colonsAreHours); });
}

std::vector<double> TirificKeywords::commentedNumbers(const std::string& keyword) const
{
  std::vector<double> numbers;
  const auto found = this->comments.find(keyword);
  if (found == this->comments.end())
  {
    return numbers;
  }
  for (const Cell& cell : found->second.cells)
  {
    double number;
    if (!parseNumber(cell.text, number))
    {
      return {}; // a comment may say anything
    }
    numbers.push_back(number);
  }
  return numbers;
}

int TirificKeywords::whole(const std::string& keyword, int lowest, int highest, int absent) const
{
  const std::vector<double> values = this->numbers(keyword);
  if (values.empty())
  {
    return absent;
  }
  if (!(values[0] >= lowest && values[0] <= highest) || values[0] != static_cast<int>(values[0]))
  {
    throw Error(this->file, this->where(keyword),
      "must be a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
  }
  return static_cast<int>(values[0]);
}

std::string TirificKeywords::where(const std::string& keyword) const
{
  const auto found = this->all.find(keyword);
  return found == this->all.end() ? keyword : lineName(found->second.line) + ": " + keyword;
}
} // namespace galaxy
