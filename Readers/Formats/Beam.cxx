#include "Readers/Formats/Beam.h"

#include "Readers/Formats/ClassicLocale.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsHeader.h"
#include "Readers/Formats/HistoryBeam.h"

#include <fitsio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace galaxy
{
namespace
{
constexpr double arcsecPerDegree = 3600;

std::optional<Beam> fromDegrees(double major, double minor, double positionAngle)
{
  if (!(major > 0 && minor > 0))
  {
    return std::nullopt;
  }
  return Beam{ major * arcsecPerDegree, minor * arcsecPerDegree, positionAngle };
}

/// How many degrees one of the unit is that a text names; none where it names none.
std::optional<double> degreesOf(const std::string& text)
{
  struct Unit
  {
    const char* word;
    double degrees;
  };
  constexpr double perRadian = 57.295779513082320877;
  static const Unit units[] = { { "MAS", 1 / 3.6e6 }, { "MARCSEC", 1 / 3.6e6 },
    { "MILLIARCSEC", 1 / 3.6e6 }, { "ARCSEC", 1 / 3600. }, { "ASEC", 1 / 3600. },
    { "ARCMIN", 1 / 60. }, { "AMIN", 1 / 60. }, { "DEG", 1 }, { "RAD", perRadian },
    { "RADIAN", perRadian } };
  if (text == "\"" || text.find("[\"]") != std::string::npos)
  {
    return 1 / arcsecPerDegree;
  }
  const std::string capitals = upperCase(text);
  const auto isLetter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  for (const Unit& unit : units)
  {
    const std::string word = unit.word;
    for (std::size_t at = 0; (at = capitals.find(word, at)) != std::string::npos; ++at)
    {
      // A word of its own, but for a plural or what is written out: arcseconds, degrees.
      const std::size_t end = at + word.size();
      const bool isShort = word == "MAS" || word == "RAD" || word == "RADIAN";
      const bool ends = end == capitals.size() || !isLetter(capitals[end]) ||
        (word == "RADIAN" ? capitals[end] == 'S' : !isShort);
      if (ends && (at == 0 || !isLetter(capitals[at - 1])))
      {
        return unit.degrees;
      }
    }
  }
  return std::nullopt;
}

/// A length in degrees: of "10.8" the unit of the comment, or else the usual one; of "10.8 arcsec"
/// its own.
std::optional<double> angleOf(const FitsHeader& header, const std::string& keyword, double usual)
{
  if (const std::optional<double> number = header.number(keyword))
  {
    return *number * degreesOf(header.comment(keyword)).value_or(usual);
  }
  const std::string text = header.text(keyword).value_or("");
  const std::size_t end = std::min(text.find_first_of(" \"acdmr"), text.size());
  const std::optional<double> number = fitsNumber(text.substr(0, end));
  const std::optional<double> unit = degreesOf(text.substr(end));
  return number && unit ? std::optional<double>(*number * *unit) : std::nullopt;
}

/// The keywords of a program, and how many degrees its unit of lengths is.
struct BeamKeywords
{
  const char* major;
  const char* minor;
  const char* positionAngle;
  double unit;
};

std::optional<Beam> beamOfKeywords(const FitsHeader& header)
{
  static const BeamKeywords programs[] = { { "BMAJ", "BMIN", "BPA", 1 },
    { "CLEANBMJ", "CLEANBMN", "CLEANBPA", 1 },           // Obit
    { "BMMAJ", "BMMIN", "BMPA", 1 / arcsecPerDegree } }; // GIPSY
  for (const BeamKeywords& names : programs)
  {
    const double major = angleOf(header, names.major, names.unit).value_or(0);
    const double minor = angleOf(header, names.minor, names.unit).value_or(major);
    const auto beam =
      fromDegrees(major, minor, angleOf(header, names.positionAngle, 1).value_or(0));
    if (beam)
    {
      return beam;
    }
  }
  return std::nullopt;
}

/// The median of a column of angles in degrees; 0 where there is none. A channel without data has a
/// beam of size 0, which does not count.
double medianOfColumn(fitsfile* table, const char* name, bool isAngularSize)
{
  int status = 0;
  int column = 0;
  long rows = 0;
  std::string columnName = name;
  fits_get_colnum(table, CASEINSEN, columnName.data(), &column, &status);
  fits_get_num_rows(table, &rows, &status);
  if (status != 0 || rows < 1)
  {
    return 0;
  }
  std::vector<double> values(static_cast<std::size_t>(rows));
  int anyNull = 0;
  fits_read_col(table, TDOUBLE, column, 1, 1, rows, nullptr, values.data(), &anyNull, &status);
  char unit[FLEN_VALUE] = "";
  int noUnit = 0;
  fits_read_key(table, TSTRING, ("TUNIT" + std::to_string(column)).c_str(), unit, nullptr, &noUnit);
  const auto valid = std::remove_if(values.begin(), values.end(),
    [&](double v) { return !std::isfinite(v) || (isAngularSize && v <= 0); });
  if (status != 0 || valid == values.begin())
  {
    return 0;
  }
  const auto middle = values.begin() + (valid - values.begin()) / 2;
  std::nth_element(values.begin(), middle, valid);
  return *middle * degreesOf(unit).value_or(1);
}

struct CloseFits
{
  void operator()(fitsfile* handle) const
  {
    int status = 0;
    fits_close_file(handle, &status);
    fits_clear_errmsg();
  }
};

// CASA's table of a beam for each channel and polarization.
std::optional<Beam> beamOfTable(const std::string& file)
{
  const ClassicLocale classic;
  int status = 0;
  fitsfile* opened = nullptr;
  fits_open_diskfile(&opened, file.c_str(), READONLY, &status);
  if (status != 0)
  {
    fits_clear_errmsg();
    return std::nullopt;
  }
  const std::unique_ptr<fitsfile, CloseFits> table(opened);
  std::string name = "BEAMS";
  fits_movnam_hdu(table.get(), BINARY_TBL, name.data(), 0, &status);
  if (status != 0)
  {
    return std::nullopt;
  }
  return fromDegrees(medianOfColumn(table.get(), "BMAJ", true),
    medianOfColumn(table.get(), "BMIN", true), medianOfColumn(table.get(), "BPA", false));
}
} // namespace

double Beam::solidAngle() const
{
  return std::acos(-1.0) / (4 * std::log(2.0)) * this->major * this->minor;
}

std::optional<Beam> beamOf(const Image& image)
{
  const FitsHeader header(image.cards);
  std::optional<Beam> beam = beamOfKeywords(header);
  beam = beam ? beam : beamOfHistory(image.cards);
  return beam ? beam : beamOfTable(image.file);
}

void requireBeamInImage(const Image& image, const Beam& beam, double pixel)
{
  constexpr double most = 3; // a cutout of a few pixels is smaller than its beam
  const double side = pixel * std::max(image.width, image.height);
  if (!(side > 0 && beam.minor > most * side))
  {
    return;
  }
  const auto rounded = [](double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << value;
    return text.str();
  };
  throw Error(image.file, "BMAJ",
    "the beam of the header, " + rounded(beam.major) + " by " + rounded(beam.minor) +
      " arcsec where BMAJ is in degrees, is far wider than the image, " + rounded(side) +
      " arcsec; give `beam = [bmaj, bmin, bpa]` (arcsec, degrees) for this image in the .galaxy "
      "file");
}
} // namespace galaxy
