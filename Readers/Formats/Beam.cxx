#include "Readers/Formats/Beam.h"

#include "Readers/Formats/FitsHeader.h"

#include <fitsio.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
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

/// The number behind "NAME=" in the text; 0 where there is none.
double numberBehind(const std::string& text, const std::string& name)
{
  const std::size_t at = text.find(name + "=");
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + name.size() + 1);
}

std::optional<Beam> beamOfHistory(const std::string& cards)
{
  constexpr std::size_t cardLength = 80;
  std::optional<Beam> last;
  for (std::size_t at = 0; at + cardLength <= cards.size(); at += cardLength)
  {
    const std::string card = cards.substr(at, cardLength);
    if (card.rfind("HISTORY", 0) == 0 && card.find("BMAJ=") != std::string::npos)
    {
      const auto beam = fromDegrees(
        numberBehind(card, "BMAJ"), numberBehind(card, "BMIN"), numberBehind(card, "BPA"));
      last = beam ? beam : last;
    }
  }
  return last;
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
  return isAngularSize && std::string(unit) == "arcsec" ? *middle / arcsecPerDegree : *middle;
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
  const double major = header.number("BMAJ").value_or(0);
  const auto beam =
    fromDegrees(major, header.number("BMIN").value_or(major), header.number("BPA").value_or(0));
  if (beam)
  {
    return beam;
  }
  const auto restored = beamOfHistory(image.cards);
  return restored ? restored : beamOfTable(image.file);
}
} // namespace galaxy
