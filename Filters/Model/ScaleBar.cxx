#include "Filters/Model/ScaleBar.h"

#include <cmath>
#include <cstdio>

namespace galaxy
{
namespace
{
struct Unit
{
  double size;
  const char* name;
};

/// In the largest unit that there is at least one of, or else in the first.
template <std::size_t n>
std::string plainText(double value, const Unit (&units)[n])
{
  const Unit* unit = units;
  for (const Unit& larger : units)
  {
    // 0.9996 of a unit would be written as one of it.
    unit = value >= 0.9995 * larger.size ? &larger : unit;
  }
  char text[40];
  const double shown = value / unit->size;
  std::snprintf(text, sizeof(text), shown < 999.5 ? "%.3g%s" : "%.0f%s", shown, unit->name);
  return text;
}
} // namespace

std::string lengthText(double kpc)
{
  const Unit units[] = { { 1e-3, " pc" }, { 1, " kpc" }, { 1e3, " Mpc" } };
  return plainText(kpc, units);
}

std::string angleText(double radians)
{
  const double degree = M_PI / 180;
  const Unit units[] = { { degree / 3600, "\"" }, { degree / 60, "'" }, { degree, "°" } };
  return plainText(radians, units);
}

ScaleBar scaleBar(double most, double distance)
{
  ScaleBar bar;
  if (!(most > 1e-30 && most < 1e30))
  {
    return bar;
  }
  const double power = std::pow(10, std::floor(std::log10(most)));
  bar.length = power;
  for (const double digit : { 2, 5, 10 })
  {
    bar.length = digit * power <= most ? digit * power : bar.length;
  }
  bar.label = lengthText(bar.length);
  if (distance > 0)
  {
    bar.label += " = " + angleText(2 * std::atan(bar.length / 2 / distance));
  }
  return bar;
}
} // namespace galaxy
