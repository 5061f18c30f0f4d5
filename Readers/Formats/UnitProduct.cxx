#include "Readers/Formats/UnitProduct.h"

#include "Readers/Formats/ClassicLocale.h"
#include "Readers/Formats/FitsHeader.h"

#include <wcslib/wcsunits.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace galaxy
{
namespace
{
constexpr std::size_t longestUnit = 68; // of a card; WCSLIB has room for a little more
constexpr int translateAll = 7;

/// The unit as the FITS standard spells it, where WCSLIB knows an alias.
std::string standardUnit(const std::string& name)
{
  if (name.size() > longestUnit)
  {
    return name;
  }
  const ClassicLocale classic;
  std::array<char, 2 * longestUnit> unit{};
  std::copy(name.begin(), name.end(), unit.begin());
  wcsutrn(translateAll, unit.data());
  return unit.data();
}

bool isLetter(char c)
{
  const auto byte = static_cast<unsigned char>(c);
  return std::isalpha(byte) != 0 || byte >= 0x80;
}

bool isDigit(char c)
{
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

class UnitReader
{
public:
  explicit UnitReader(const std::string& text)
    : text(text)
  {
  }

  UnitProduct read()
  {
    this->readProduct(1, 0);
    return this->product;
  }

private:
  /// Up to the end of the text or of the bracket.
  void readProduct(int sign, int depth)
  {
    constexpr int deepest = 20;
    int next = sign;
    while (this->at < this->text.size())
    {
      const char c = this->text[this->at];
      if (c == ')' && depth > 0)
      {
        ++this->at;
        return;
      }
      if (c == '(' && depth < deepest)
      {
        ++this->at;
        this->readProduct(next, depth + 1);
        this->product.hasPowerOfAll |= this->power() != 1;
        next = sign;
      }
      else if (isDigit(c))
      {
        const double number = this->number();
        this->product.number *= std::pow(number, next * this->power());
        next = sign;
      }
      else if (isLetter(c))
      {
        const std::string name = this->name();
        this->product.factors.push_back({ name, standardUnit(name), next * this->power() });
        next = sign;
      }
      else
      {
        next = c == '/' ? -sign : next;
        ++this->at;
      }
    }
  }

  std::string name()
  {
    const std::size_t start = this->at;
    while (this->at < this->text.size() && isLetter(this->text[this->at]))
    {
      ++this->at;
    }
    return this->text.substr(start, this->at - start);
  }

  double number()
  {
    const std::size_t start = this->at;
    double value = 0;
    const auto [end, error] =
      std::from_chars(this->text.data() + start, this->text.data() + this->text.size(), value);
    this->at = static_cast<std::size_t>(end - this->text.data());
    return error == std::errc() ? value : 1;
  }

  /// The whole power behind a name or number; 1 where there is none.
  int power()
  {
    std::size_t end = std::min(this->text.find_first_not_of("^*(", this->at), this->text.size());
    const bool isMarked = end > this->at; // as "cm^2", unlike "cm2"
    end += end < this->text.size() && this->text[end] == '+' ? 1 : 0;
    int power = 1;
    const auto [behind, error] =
      std::from_chars(this->text.data() + end, this->text.data() + this->text.size(), power);
    constexpr int largest = 99;
    // "Jy*1.5" and "km (10" have no power.
    const bool isProduct =
      isMarked && this->text[this->at] == '*' && this->text.compare(this->at, 2, "**") != 0;
    const bool isBracket = isMarked && this->text[this->at] == '(';
    if (error != std::errc() || std::abs(power) > largest || isProduct || isBracket)
    {
      return 1;
    }
    const bool isBracketed = this->text.find('(', this->at) < end;
    this->at = static_cast<std::size_t>(behind - this->text.data());
    this->at += isBracketed && this->at < this->text.size() && this->text[this->at] == ')' ? 1 : 0;
    return power;
  }

  const std::string& text;
  std::size_t at = 0;
  UnitProduct product;
};
} // namespace

bool UnitProduct::take(std::initializer_list<const char*> names, int power)
{
  const auto found =
    std::find_if(this->factors.begin(), this->factors.end(), [&](const UnitFactor& factor) {
      const std::string name = lowerCase(factor.standard);
      return factor.power == power &&
        std::any_of(names.begin(), names.end(), [&](const char* known) { return name == known; });
    });
  if (found == this->factors.end())
  {
    return false;
  }
  this->factors.erase(found);
  return true;
}

std::string UnitProduct::written() const
{
  std::string text;
  for (const UnitFactor& factor : this->factors)
  {
    text += factor.power < 0 ? "/" : (text.empty() ? "" : " ");
    text += factor.name;
    text += std::abs(factor.power) == 1 ? "" : std::to_string(std::abs(factor.power));
  }
  return text;
}

UnitProduct parseUnitProduct(const std::string& text)
{
  return UnitReader(text).read();
}

double unitRatio(const std::string& from, const std::string& to)
{
  const std::string unit = standardUnit(from);
  if (unit.empty() || unit.size() > longestUnit)
  {
    return 0;
  }
  const ClassicLocale classic;
  double scale = 0, offset = 0, power = 1;
  const bool isKnown = wcsunits(unit.c_str(), to.c_str(), &scale, &offset, &power) == 0;
  return isKnown && offset == 0 && power == 1 ? scale : 0;
}

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}
} // namespace galaxy
