#include "Readers/Formats/FitsHeader.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace galaxy
{
namespace
{
std::string withoutTrailingBlanks(std::string text)
{
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

struct Quoted
{
  std::string text;
  std::size_t end = 0; ///< behind the closing quote
  bool isUnclosed = false;
};

/// The quoted value that begins at `start`; two quotes in it stand for one. Where nothing closes
/// it, it ends at its comment.
Quoted quoted(const std::string& card, std::size_t start)
{
  Quoted value;
  for (std::size_t i = start + 1; i < card.size(); ++i)
  {
    if (card[i] == '\'' && (++i == card.size() || card[i] != '\''))
    {
      value.end = i;
      value.text = withoutTrailingBlanks(value.text);
      return value;
    }
    value.text += card[i];
  }
  value.end = std::min(card.find(" /", start), card.size());
  value.text = withoutTrailingBlanks(card.substr(start + 1, value.end - start - 1));
  value.isUnclosed = true;
  return value;
}

template <class Number>
std::optional<Number> parsed(const std::string& text)
{
  Number number{};
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* begin = text.data() + (plus ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end ? std::optional<Number>(number) : std::nullopt;
}

bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Coordinate keywords with indices as the standard writes them: CRPIX1 of CRPIX01, PV2_1 of
/// PV02_01, PC1_2 and CD1_2 of the old PC001002 and CD001002.
std::string withStandardIndices(const std::string& keyword)
{
  for (const std::string root :
    { "CTYPE", "CUNIT", "CRPIX", "CRVAL", "CDELT", "CROTA", "PC", "CD", "PV" })
  {
    if (keyword.compare(0, root.size(), root) != 0 || keyword.size() == root.size() ||
      !isDigit(keyword[root.size()]))
    {
      continue;
    }
    std::string indices = keyword.substr(root.size());
    if ((root == "PC" || root == "CD") && indices.size() == 6 &&
      std::all_of(indices.begin(), indices.end(), isDigit))
    {
      indices.insert(3, "_");
    }
    std::string standard = root;
    bool inNumber = false;
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      const bool leadingZero =
        !inNumber && indices[i] == '0' && i + 1 < indices.size() && isDigit(indices[i + 1]);
      standard += leadingZero ? "" : indices.substr(i, 1);
      inNumber = isDigit(indices[i]) && !leadingZero;
    }
    return standard;
  }
  return keyword;
}
} // namespace

FitsHeader::FitsHeader(const std::string& cards)
{
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    this->add(cards.substr(at, cardLength));
  }
}

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
  Quoted value;
  if (card[start] == '\'')
  {
    value = quoted(card, start);
  }
  else
  {
    value.end = std::min(card.find('/', start), card.size());
    value.text = withoutTrailingBlanks(card.substr(start, value.end - start));
  }
  // Messages quote values, and a control character is no part of one.
  std::replace_if(
    value.text.begin(), value.text.end(), [](unsigned char c) { return std::iscntrl(c) != 0; },
    ' ');
  const std::size_t slash = card.find('/', value.end);
  const std::string comment = slash == std::string::npos ? "" : card.substr(slash + 1);
  const std::string keyword = withStandardIndices(withoutTrailingBlanks(card.substr(0, 8)));
  const Entry entry = { value.text, withoutTrailingBlanks(comment), value.isUnclosed };
  if (!this->entries.emplace(keyword, entry).second)
  {
    this->repeatedKeywords.insert(keyword);
  }
}

std::optional<std::string> FitsHeader::text(const std::string& keyword) const
{
  const auto found = this->entries.find(keyword);
  return found == this->entries.end() ? std::nullopt
                                      : std::optional<std::string>(found->second.value);
}

std::optional<double> FitsHeader::number(const std::string& keyword) const
{
  return fitsNumber(this->text(keyword).value_or(""));
}

bool FitsHeader::isUnclosed(const std::string& keyword) const
{
  const auto found = this->entries.find(keyword);
  return found != this->entries.end() && found->second.isUnclosed;
}

std::string FitsHeader::comment(const std::string& keyword) const
{
  const auto found = this->entries.find(keyword);
  return found == this->entries.end() ? std::string() : found->second.comment;
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

std::optional<double> fitsNumber(std::string text)
{
  const std::size_t start = text.find_first_not_of(' ');
  text = withoutTrailingBlanks(text.erase(0, std::min(start, text.size())));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'E');
  const std::optional<double> number = parsed<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string upperCase(std::string text)
{
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}
} // namespace galaxy
