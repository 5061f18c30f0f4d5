#include "Readers/Formats/FitsHeader.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace galaxy
{
namespace
{
std::string withoutTrailingBlanks(std::string text)
{
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The text of a quoted value that begins at `start`; two quotes in it stand for one.
std::string quoted(const std::string& card, std::size_t start)
{
  std::string text;
  for (std::size_t i = start + 1; i < card.size(); ++i)
  {
    if (card[i] == '\'' && (++i == card.size() || card[i] != '\''))
    {
      break;
    }
    text += card[i];
  }
  return withoutTrailingBlanks(text);
}

template <class Number>
std::optional<Number> parsed(const std::string& text)
{
  Number number{};
  const char* begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end ? std::optional<Number>(number) : std::nullopt;
}
} // namespace

void FitsHeader::add(const std::string& card)
{
  if (card.size() < cardLength || card.compare(8, 2, "= ") != 0)
  {
    return;
  }
  const std::size_t start = card.find_first_not_of(' ', 10);
  if (start == std::string::npos || card[start] == '/')
  {
    return;
  }
  const std::string value = card[start] == '\''
    ? quoted(card, start)
    : withoutTrailingBlanks(card.substr(start, card.find('/', start) - start));
  const std::string keyword = withoutTrailingBlanks(card.substr(0, 8));
  if (!this->values.emplace(keyword, value).second)
  {
    this->repeatedKeywords.insert(keyword);
  }
}

std::optional<std::string> FitsHeader::text(const std::string& keyword) const
{
  const auto found = this->values.find(keyword);
  return found == this->values.end() ? std::nullopt : std::optional<std::string>(found->second);
}

std::optional<double> FitsHeader::number(const std::string& keyword) const
{
  std::string value = this->text(keyword).value_or("");
  // Fortran's exponent letter of double precision.
  std::replace_if(
    value.begin(), value.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  return parsed<double>(value);
}

std::optional<long long> FitsHeader::integer(const std::string& keyword) const
{
  return parsed<long long>(this->text(keyword).value_or(""));
}

bool FitsHeader::flag(const std::string& keyword) const
{
  return this->text(keyword).value_or("") == "T";
}

std::string FitsHeader::repeated(const std::string& beginning) const
{
  const auto found = this->repeatedKeywords.lower_bound(beginning);
  return found != this->repeatedKeywords.end() &&
      found->compare(0, beginning.size(), beginning) == 0
    ? *found
    : std::string();
}

std::string fitsKeyword(const std::string& root, std::size_t number)
{
  return root + std::to_string(number);
}

std::string upperCase(std::string text)
{
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}
} // namespace galaxy
