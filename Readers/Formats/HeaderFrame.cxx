#include "Readers/Formats/HeaderFrame.h"

#include "Readers/Formats/NoCoordinates.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace galaxy
{
namespace
{
struct Equinox
{
  double year = 0;
  char letter = ' '; ///< B or J where the text says so
};

/// "1950", "B1950.0", "J2000 (mean)"; none where the text is a date or anything else.
std::optional<Equinox> parsedEquinox(const std::string& value)
{
  std::string text = upperCase(value);
  text.erase(0, text.find_first_not_of(' '));
  Equinox equinox;
  if (!text.empty() && (text[0] == 'B' || text[0] == 'J'))
  {
    equinox.letter = text[0];
    text.erase(0, 1);
  }
  equinox.year = fitsNumber(text.substr(0, text.find_first_of(" ("))).value_or(0);
  const bool isYear = equinox.year > 1500 && equinox.year < 2500;
  return isYear ? std::optional<Equinox>(equinox) : std::nullopt;
}

/// The equinox by EPOCH; `isAlone` where nothing else tells the system.
std::optional<Equinox> equinoxOfEpoch(const FitsHeader& header, bool isAlone)
{
  const std::optional<Equinox> epoch = parsedEquinox(header.text("EPOCH").value_or(""));
  const bool isDate = epoch && isAlone && epoch->letter == ' ' && std::fmod(epoch->year, 25.0) != 0;
  return isDate ? std::nullopt : epoch;
}

/// What the header says of its system, the gaps filled in as the FITS standard does.
struct System
{
  std::string name; ///< in capitals; empty where nothing is said
  std::optional<Equinox> equinox;
  std::string unknownEquinox; ///< what is written in place of one

  System(const FitsHeader& header, const std::string& version);
  bool is(const char* start) const { return this->name.rfind(start, 0) == 0; }
  double year(double usual) const { return this->equinox ? this->equinox->year : usual; }
};

System::System(const FitsHeader& header, const std::string& version)
{
  this->name = upperCase(header.text("RADESYS" + version).value_or(""));
  if (this->name.empty() && version.empty())
  {
    this->name = upperCase(header.text("RADECSYS").value_or(""));
  }
  this->name.erase(0, this->name.find_first_not_of(' '));
  const std::string written = header.text("EQUINOX" + version).value_or("");
  this->equinox = parsedEquinox(written);
  if (!this->equinox && fitsNumber(written).value_or(1) > 0)
  {
    // 0 is what some programs write where they know none.
    this->unknownEquinox = written;
  }
  if (written.empty() && version.empty())
  {
    this->equinox = equinoxOfEpoch(header, this->name.empty());
  }
  std::optional<Equinox> named = parsedEquinox(this->name); // RADESYS = 'J2000'
  if (named)
  {
    this->equinox = this->equinox ? this->equinox : named;
  }
  else if (this->name.empty())
  {
    named = this->equinox;
  }
  if (named)
  {
    const bool isBesselian = named->letter == 'B' || (named->letter == ' ' && named->year < 1984);
    this->name = isBesselian ? "FK4" : "FK5";
  }
}
} // namespace

CelestialFrame frameOfHeader(const std::string& file, const FitsHeader& header,
  const std::string& version, const std::string& longitude)
{
  if (longitude == "GLON")
  {
    return CelestialFrame::galactic();
  }
  const System system(header, version);
  if (longitude != "RA" && longitude != "ELON")
  {
    throw NoCoordinates(file, "CTYPE", "the celestial frame of " + longitude + " is not supported");
  }
  const bool isIcrs = system.is("ICRS");
  if (!isIcrs && !system.unknownEquinox.empty())
  {
    throw NoCoordinates(file, "EQUINOX" + version,
      "'" + system.unknownEquinox + "' is no equinox, must be like 2000.0, J2000 or B1950");
  }
  if (longitude == "ELON")
  {
    return CelestialFrame::ecliptic(isIcrs ? 2000 : system.year(2000));
  }
  if (system.name.empty() || isIcrs)
  {
    return CelestialFrame::icrs();
  }
  if (system.is("FK5"))
  {
    return CelestialFrame::fk5(system.year(2000));
  }
  if (system.is("FK4"))
  {
    return system.is("FK4-NO-E") ? CelestialFrame::fk4WithoutETerms(system.year(1950))
                                 : CelestialFrame::fk4(system.year(1950));
  }
  throw NoCoordinates(file, "RADESYS" + version,
    "'" + system.name + "' is not supported, must be ICRS, FK5, FK4 or FK4-NO-E");
}
} // namespace galaxy
