#include "Readers/Formats/TirificKeywords.h"

#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cctype>

namespace galaxy
{
namespace
{
std::string beforeComment(const std::string& line)
{
  return line.substr(0, line.find('#'));
}
} // namespace

/// Takes a line KEYWORD= cells; false where it reads otherwise.
bool TirificKeywords::split(const TextLine& line, Map& into)
{
  const std::size_t equals = line.text.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  std::string keyword = trimmed(line.text.substr(0, equals));
  const auto isLetter = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (keyword.empty() || !std::all_of(keyword.begin(), keyword.end(), isLetter))
  {
    return false;
  }
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  into[keyword] = { line.number, splitCells(line.text.substr(equals + 1)) };
  return true;
}

bool isTirific(const std::vector<TextLine>& lines)
{
  TirificKeywords::Map ignored;
  return std::any_of(lines.begin(), lines.end(), [&](const TextLine& line) {
    const std::string text = beforeComment(line.text);
    return text.find('!') == std::string::npos &&
      TirificKeywords::split({ line.number, text }, ignored);
  });
}

TirificKeywords::TirificKeywords(const std::vector<TextLine>& lines, const std::string& file)
  : file(file)
{
  TextLine whole;
  for (const TextLine& line : lines)
  {
    const std::string text = trimmed(beforeComment(line.text));
    const bool continues = !text.empty() && text.back() == '\\';
    whole.number = whole.text.empty() ? line.number : whole.number;
    whole.text += text.substr(0, text.size() - (continues ? 1 : 0));
    if (continues)
    {
      continue;
    }
    if (!split(whole, this->all) && !whole.text.empty())
    {
      throw Error(file, "line " + std::to_string(whole.number),
        "must be KEYWORD= values or a # comment, not '" + whole.text.substr(0, 40) + "'");
    }
    if (text.empty() && line.text.find('#') != std::string::npos)
    {
      split({ line.number, line.text.substr(line.text.find('#') + 1) }, this->comments);
    }
    whole.text.clear();
  }
}

std::vector<double> TirificKeywords::numbers(const std::string& keyword) const
{
  std::vector<double> numbers;
  const auto found = this->all.find(keyword);
  if (found == this->all.end())
  {
    return numbers;
  }
  for (const std::string& cell : found->second.cells)
  {
    double number;
    if (!parseNumber(cell, number))
    {
      throw Error(this->file, this->where(keyword),
        "value " + std::to_string(numbers.size() + 1) + " must be a finite number, not '" + cell +
          "'");
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<double> TirificKeywords::commentedNumbers(const std::string& keyword) const
{
  std::vector<double> numbers;
  const auto found = this->comments.find(keyword);
  if (found == this->comments.end())
  {
    return numbers;
  }
  for (const std::string& cell : found->second.cells)
  {
    double number;
    if (!parseNumber(cell, number))
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
  return found == this->all.end() ? keyword
                                  : "line " + std::to_string(found->second.line) + ": " + keyword;
}
} // namespace galaxy
