#ifndef galaxy_RegionNumbers_h
#define galaxy_RegionNumbers_h

#include <stdexcept>
#include <string>

namespace galaxy
{
/// What is wrong with a region; the parser adds file and line.
class RegionFault : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A length or an angle of a region file.
struct RegionNumber
{
  double value = 0; ///< degrees, or pixels
  bool isPixels = false;
};

/// A number with a unit, `bare` telling what one without a unit is in.
RegionNumber regionNumber(const std::string& text, bool barePixels);

/// Longitude or latitude in degrees: decimal, or as sexagesimalAngle reads it.
double regionAngle(const std::string& text, bool colonsAreHours);
} // namespace galaxy

#endif
