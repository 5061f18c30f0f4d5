#include "Readers/Formats/WatCorrection.h"

#include "Readers/Formats/NoCoordinates.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

namespace galaxy
{
namespace
{
class BrokenCorrection : public NoCoordinates
{
public:
  BrokenCorrection(const std::string& file, int axis, const std::string& what)
    : NoCoordinates(file, fitsKeyword("WAT", static_cast<std::size_t>(axis)) + "_001", what)
  {
  }
};

std::string keywordOf(int axis, int card)
{
  const std::string number = std::to_string(1000 + card).substr(1);
  return "WAT" + std::to_string(axis) + "_" + number;
}

/// The cards one behind the other: all but the last are 68 characters long, blanks at their ends
/// included, which writers of FITS leave out.
std::string textOf(const std::string& file, const FitsHeader& header, int axis)
{
  constexpr std::size_t valueLength = 68;
  constexpr int mostCards = 999;
  std::string text;
  for (int card = 1; card <= mostCards; ++card)
  {
    const std::string keyword = keywordOf(axis, card);
    std::optional<std::string> value = header.text(keyword);
    if (!value)
    {
      break;
    }
    if (header.isUnclosed(keyword))
    {
      throw BrokenCorrection(file, axis, "the text of " + keyword + " has no closing quote");
    }
    value->resize(valueLength, ' ');
    text += *value;
  }
  return text;
}

std::map<int, double> parametersOf(const std::string& text)
{
  constexpr int mostParameters = 30;
  std::map<int, double> parameters;
  for (int m = 0; m < mostParameters; ++m)
  {
    const std::string name = "projp" + std::to_string(m) + "=";
    const std::size_t at = text.find(name);
    const std::size_t start = at == std::string::npos ? at : at + name.size();
    const std::optional<double> value = at == std::string::npos
      ? std::nullopt
      : fitsNumber(text.substr(start, text.find(' ', start) - start));
    if (value)
    {
      parameters[m] = *value;
    }
  }
  return parameters;
}

/// The numbers between the quotes behind lngcor or latcor; none where there is no correction.
std::vector<double> numbersOf(const std::string& file, int axis, const std::string& text)
{
  const std::size_t name = std::min(text.find("lngcor"), text.find("latcor"));
  const std::size_t open = name == std::string::npos ? name : text.find('"', name);
  if (open == std::string::npos)
  {
    return {};
  }
  const std::size_t close = text.find('"', open + 1);
  if (close == std::string::npos)
  {
    throw BrokenCorrection(file, axis, "the correction of the axis does not end");
  }
  std::vector<double> numbers;
  std::istringstream words(text.substr(open + 1, close - open - 1));
  for (std::string word; words >> word;)
  {
    const std::optional<double> number = fitsNumber(word);
    if (!number)
    {
      throw BrokenCorrection(file, axis, "'" + word + "' in the correction is not a number");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

constexpr std::size_t controls = 4; ///< type, order in x, in y, cross terms
constexpr std::size_t domain = 4;   ///< of x and of y

/// How many coefficients the controls promise; 0 where they are none that WCSLIB takes.
std::size_t coefficientsOf(const std::vector<double>& numbers)
{
  constexpr double highestDegree = 9;
  const double orderX = numbers[1], orderY = numbers[2], cross = numbers[3];
  const auto isWhole = [](double value, double lowest, double highest) {
    return value >= lowest && value <= highest && value == static_cast<int>(value);
  };
  if (!isWhole(numbers[0], 1, 3) || !isWhole(orderX, 1, 1 + highestDegree) ||
    !isWhole(orderY, 1, 1 + highestDegree) || !isWhole(cross, 0, 2) ||
    (cross == 1 && orderX + orderY - 2 > highestDegree))
  {
    return 0;
  }
  std::size_t count = 0;
  for (int n = 0; n < orderY; ++n)
  {
    for (int m = 0; m < orderX; ++m)
    {
      const bool isCross = m > 0 && n > 0;
      count += cross == 0 ? !isCross : cross == 1 || m + n < std::max(orderX, orderY);
    }
  }
  return count;
}

std::string written(const std::vector<double>& numbers)
{
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    // WCSLIB 7.12 does not step past a coefficient of 0, so that all behind it are lost.
    constexpr double nothing = 1e-300;
    const double number = numbers[i] == 0 && i >= controls + domain ? nothing : numbers[i];
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr) += ' ';
  }
  return text;
}
} // namespace

WatCorrection watCorrectionOf(const std::string& file, const FitsHeader& header, int axis)
{
  const std::string text = textOf(file, header, axis);
  WatCorrection correction;
  correction.parameters = parametersOf(text);
  std::vector<double> numbers = numbersOf(file, axis, text);
  if (numbers.empty())
  {
    return correction;
  }
  const std::size_t count = numbers.size() > controls + domain ? coefficientsOf(numbers) : 0;
  if (count == 0 || numbers.size() < controls + domain + count)
  {
    throw BrokenCorrection(file, axis,
      "the correction of the axis is not whole, its orders, domain and coefficients do not match");
  }
  numbers.resize(controls + domain + count);
  correction.polynomial = written(numbers);
  return correction;
}

std::string noCorrection()
{
  return written({ 3, 1, 1, 0, -1, 1, -1, 1, 0 });
}
} // namespace galaxy
