#include "Readers/Formats/RingUnits.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingPlane.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <map>

namespace galaxy
{
namespace
{
using Units = std::map<std::string, double>;

const Units angularLengths = { { "arcsec", 1 }, { "arcs", 1 }, { "arcsecs", 1 }, { "asec", 1 },
  { "arcsecond", 1 }, { "arcseconds", 1 }, { "\"", 1 }, { "arcmin", 60 }, { "arcm", 60 },
  { "arcmins", 60 }, { "arcminute", 60 }, { "arcminutes", 60 }, { "'", 60 }, { "deg", 3600 },
  { "degree", 3600 }, { "degrees", 3600 }, { "\xc2\xb0", 3600 }, { "mas", 1e-3 },
  { "rad", arcsecPerRadian }, { "radian", arcsecPerRadian }, { "radians", arcsecPerRadian },
  { "arc-sec", 1 }, { "arc-min", 60 }, { "amin", 60 } };
const Units physicalLengths = { { "pc", 1e-3 }, { "parsec", 1e-3 }, { "parsecs", 1e-3 },
  { "kpc", 1 }, { "kiloparsec", 1 }, { "kiloparsecs", 1 }, { "mpc", 1e3 } }; // in kpc
const Units pixels = { { "pix", 1 }, { "pixel", 1 }, { "pixels", 1 }, { "px", 1 }, { "grid", 1 } };
const Units velocities = { { "km/s", 1 }, { "km/sec", 1 }, { "km/second", 1 }, { "kms", 1 },
  { "kmps", 1 }, { "kms-1", 1 }, { "km_s-1", 1 }, { "m/s", 1e-3 }, { "m/sec", 1e-3 },
  { "ms-1", 1e-3 } };
const Units angles = { { "deg", 1 }, { "degree", 1 }, { "degrees", 1 }, { "degr", 1 },
  { "degs", 1 }, { "circ", 1 }, { "\xc2\xb0", 1 }, { "\xb0", 1 }, { "rad", arcsecPerRadian / 3600 },
  { "radian", arcsecPerRadian / 3600 }, { "radians", arcsecPerRadian / 3600 } };

/// Small letters without blanks, points and LaTeX's marks: km s$^{-1}$ as kms-1.
std::string plain(const std::string& unit)
{
  std::string name = lowered(unit);
  for (const char* command : { "\\mathrm", "\\rm", "\\text", "\\," })
  {
    for (std::size_t at; (at = name.find(command)) != std::string::npos;)
    {
      name.erase(at, std::char_traits<char>::length(command));
    }
  }
  name.erase(std::remove_if(name.begin(), name.end(),
               [](char c) { return std::string(" ${}~\\.*^").find(c) != std::string::npos; }),
    name.end());
  return name;
}

bool look(const Units& units, const std::string& unit, double& factor)
{
  const auto found = units.find(plain(unit));
  if (found != units.end())
  {
    factor = found->second;
  }
  return found != units.end();
}

[[noreturn]] void failWithout(const std::string& file, const std::string& column,
  const std::string& unit, const std::string& what)
{
  throw Error(file, column, "is in " + unit + "; give " + what);
}

double lengthFactor(const std::string& unit, const RingOptions& options, const std::string& file,
  const std::string& column)
{
  double factor;
  if (look(angularLengths, unit, factor))
  {
    return factor;
  }
  if (look(physicalLengths, unit, factor))
  {
    if (!(options.distance > 0))
    {
      failWithout(file, column, unit, "the distance in Mpc: Distance of the ring reader");
    }
    return factor / kpcPerArcsec(options.distance);
  }
  if (look(pixels, unit, factor))
  {
    if (!(options.pixelScale > 0))
    {
      failWithout(file, column, unit,
        "the size of a pixel in arcsec: ring_pixel_scale in [galaxy], PixelScale of the ring "
        "reader");
    }
    return options.pixelScale;
  }
  throw Error(file, column,
    "'" + unit + "' is no unit of length known here; use arcsec, arcmin, deg, pc, kpc or pix");
}
} // namespace

bool isAngularLength(const std::string& unit)
{
  double ignored;
  return unit.empty() || look(angularLengths, unit, ignored);
}

bool kpcOf(const std::string& unit, double& kpc)
{
  return look(physicalLengths, unit, kpc);
}

bool isUnit(Dimension dimension, const std::string& unit)
{
  double ignored;
  switch (dimension)
  {
    case Dimension::Length:
      return look(angularLengths, unit, ignored) || look(physicalLengths, unit, ignored) ||
        look(pixels, unit, ignored);
    case Dimension::Velocity:
      return look(velocities, unit, ignored);
    case Dimension::Angle:
      return look(angles, unit, ignored);
    default:
      return false;
  }
}

bool isAnyUnit(const std::string& unit)
{
  return isUnit(Dimension::Length, unit) || isUnit(Dimension::Velocity, unit) ||
    isUnit(Dimension::Angle, unit);
}

bool isUsualUnit(const std::string& unit)
{
  double factor = 0;
  return (look(angularLengths, unit, factor) && factor == 1) ||
    (look(velocities, unit, factor) && factor == 1) || (look(angles, unit, factor) && factor == 1);
}

double unitFactor(Dimension dimension, const std::string& unit, const RingOptions& options,
  const std::string& file, const std::string& column)
{
  if (unit.empty() || dimension == Dimension::Number)
  {
    return 1;
  }
  if (dimension == Dimension::Length)
  {
    return lengthFactor(unit, options, file, column);
  }
  const bool isAngle = dimension == Dimension::Angle;
  double factor;
  if (!look(isAngle ? angles : velocities, unit, factor))
  {
    throw Error(file, column,
      "'" + unit + "' is no unit of " +
        (isAngle ? "angle known here; use deg or rad" : "velocity known here; use km/s or m/s"));
  }
  return factor;
}
} // namespace galaxy
