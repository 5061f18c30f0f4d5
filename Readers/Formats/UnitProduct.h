#ifndef galaxy_UnitProduct_h
#define galaxy_UnitProduct_h

#include <string>
#include <vector>

namespace galaxy
{
struct UnitFactor
{
  std::string name;     ///< as it is written
  std::string standard; ///< as the FITS standard spells it: "Jy" of "JY", "s" of "seconds"
  int power = 1;
};

/// A unit taken apart: a number times names with their powers.
struct UnitProduct
{
  double number = 1;
  std::vector<UnitFactor> factors;
  bool hasPowerOfAll = false; ///< "(mJy/beam)**2", whose inside is not raised

  /// Takes out the first factor of one of these names, small letters, and this power.
  bool take(std::initializer_list<const char*> names, int power);
  /// What is left, as "erg/s/cm2".
  std::string written() const;
};

/// Reads a unit as programs write it: blanks, points and asterisks multiply, a slash divides by the
/// next name or bracket only, powers are "2", "-1", "^2", "**(-2)".
UnitProduct parseUnitProduct(const std::string& text);

/// How many of the unit `to` one of `from` is, by WCSLIB; 0 where they are of different kinds, or
/// one is none that it knows.
double unitRatio(const std::string& from, const std::string& to);

/// In small letters.
std::string lowerCase(std::string text);
} // namespace galaxy

#endif
