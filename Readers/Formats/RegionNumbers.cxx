#include "Readers/Formats/RegionNumbers.h"

#include "Readers/Formats/Printable.h"
#include "Readers/Formats/Sexagesimal.h"
#include "Readers/Formats/TextFile.h"

#include <cmath>

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
    const bool angle = sexagesimalAngle(text, false).has_value();
    throw RegionFault(angle
        ? quoted(text) + " must be a number of pixels; name the frame of angles first, such as fk5"
        : quoted(text) + " must be a number");
  }
  return number;
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
  if (const std::optional<double> angle = sexagesimalAngle(text, colonsAreHours))
  {
    return *angle;
  }
  const RegionNumber number = regionNumber(text, false);
  if (number.isPixels)
  {
    throw RegionFault(quoted(text) + " must be an angle on the sky");
  }
  return number.value;
}
} // namespace galaxy
