#ifndef galaxy_RingUnits_h
#define galaxy_RingUnits_h

#include "Readers/Formats/RingTable.h"

#include <string>

namespace galaxy
{
/// What a column of a ring table measures, which decides the units it may have.
enum class Dimension
{
  Length,
  Velocity,
  Angle,
  Number,
};

/// True for a length in arcsec, arcmin, degrees or radians, which needs nothing else to be known.
bool isAngularLength(const std::string& unit);

/// The kpc of a unit pc, kpc or Mpc; false where it is none of them.
bool kpcOf(const std::string& unit, double& kpc);

/// True for a unit that is known for the dimension.
bool isUnit(Dimension dimension, const std::string& unit);

/// True for a unit that is known for any dimension.
bool isAnyUnit(const std::string& unit);

/// True for those that a column without a unit is in: arcsec, km/s, degrees.
bool isUsualUnit(const std::string& unit);

/// The factor from a unit to arcsec, km/s or degrees; no unit is any of these. Throws Error naming
/// `column` where the unit is unknown, or where a length needs a distance or pixel scale that the
/// options lack.
double unitFactor(Dimension dimension, const std::string& unit, const RingOptions& options,
  const std::string& file, const std::string& column);
} // namespace galaxy

#endif
