#include "Readers/Formats/RegionNumbers.h"

#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace galaxy
{
namespace
{
const double degreesPerRadian = 180 / std::acos(-1.0);

struct Unit
{
  const char* name;
  double factor;
  bool isPixels;
};
const Unit units[] = {
  { "arcsec", 1 / 3600.0, false },
  { "arcmin", 1 / 60.0, false },
  { "deg", 1, false },
  { "rad", degreesPerRadian, false },
  { "pix", 1, true },
  { "\"", 1 / 3600.0, false },
  { "'", 1 / 60.0, false },
  { "d", 1, false },
  { "r", degreesPerRadian, false },
  { "p", 1, true },
  { "i", 1, true },
};

double plainNumber(const std::string& text)
{
  double number;
  if (!parseNumber(text, number))
  {
    throw RegionFault("'" + text + "' must be a number");
  }
  return number;
}

/// The fields of 13:29:52.7, 13h29m52.7s, +47d11m43s or 47.11.43.0.
std::vector<double> sexagesimalFields(const std::string& text)
{
  std::string fields = text;
  const bool dotted = std::count(text.begin(), text.end(), '.') >= 2;
  int dots = 0;
  for (char& c : fields)
  {
    const bool separatingDot = dotted && c == '.' && ++dots <= 2;
    c = separatingDot || std::string(":hdms").find(c) != std::string::npos ? ' ' : c;
  }
  std::vector<double> numbers;
  for (const std::string& cell : splitCells(fields))
  {
    numbers.push_back(plainNumber(cell));
  }
  return numbers;
}
} // namespace

RegionNumber regionNumber(const std::string& text, bool barePixels)
{
  for (const Unit& unit : units)
  {
    const std::string name = unit.name;
    if (text.size() > name.size() &&
      text.compare(text.size() - name.size(), name.size(), name) == 0)
    {
      return { plainNumber(text.substr(0, text.size() - name.size())) * unit.factor,
        unit.isPixels };
    }
  }
  return { plainNumber(text), barePixels };
}

double regionAngle(const std::string& text, bool colonsAreHours)
{
  const bool hours = text.find('h') != std::string::npos;
  const bool colons = text.find(':') != std::string::npos;
  const bool sexagesimal = hours || colons || text.find('m') != std::string::npos ||
    std::count(text.begin(), text.end(), '.') > 1;
  if (!sexagesimal || text.find("deg") != std::string::npos)
  {
    const RegionNumber number = regionNumber(text, false);
    if (number.isPixels)
    {
      throw RegionFault("'" + text + "' must be an angle on the sky");
    }
    return number.value;
  }
  const std::vector<double> fields = sexagesimalFields(text);
  if (fields.empty() || fields.size() > 3)
  {
    throw RegionFault("'" + text + "' must be an angle on the sky");
  }
  double angle = 0;
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    angle += std::abs(fields[i]) / std::pow(60.0, double(i));
  }
  const bool negative = text.front() == '-';
  return (negative ? -angle : angle) * (hours || (colons && colonsAreHours) ? 15 : 1);
}
} // namespace galaxy
