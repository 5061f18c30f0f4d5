#include "Readers/Formats/SpectralAxis.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/UnitProduct.h"

#include <cmath>

namespace galaxy
{
namespace
{
constexpr double speedOfLight = 299792.458; // km/s

/// A range of velocities that the header cannot tell the planes of.
class NoVelocities : public Error
{
public:
  NoVelocities(const std::string& file, const std::string& where, const std::string& what)
    : Error(file, where, what + "; choose planes in place of a velocity range")
  {
  }
};

std::string typeOf(const FitsHdu& hdu, std::size_t axis)
{
  return upperCase(hdu.header.text(fitsKeyword("CTYPE", axis + 1)).value_or(""));
}

bool isSpectral(const std::string& type)
{
  const std::string kind = type.substr(0, 4);
  return kind == "VELO" || kind == "VRAD" || kind == "VOPT" || kind == "FELO" || kind == "FREQ";
}

/// In Hz or km/s.
double unitOf(
  const std::string& file, const std::string& keyword, const FitsHdu& hdu, bool isFrequency)
{
  const std::string unit = isFrequency ? "Hz" : "km/s";
  const std::string name = hdu.header.text(keyword).value_or("");
  if (name.empty())
  {
    return isFrequency ? 1 : 1e-3;
  }
  const double known = unitRatio(name, unit);
  const double ratio = known > 0 ? known : unitRatio(upperCase(name), unit); // "Km/s"
  if (!(ratio > 0))
  {
    throw NoVelocities(file, keyword,
      "'" + name + "' is no unit of " + (isFrequency ? "frequency" : "velocity") + " known here");
  }
  return ratio;
}
} // namespace

SpectralAxis::SpectralAxis(
  const std::string& file, const FitsHdu& hdu, const std::array<int, 2>& image)
{
  const auto isThis = [&](std::size_t i) {
    const int number = static_cast<int>(i) + 1;
    return number != image[0] && number != image[1] && isSpectral(typeOf(hdu, i));
  };
  while (this->axis < hdu.axes.size() && !isThis(this->axis))
  {
    ++this->axis;
  }
  if (this->axis == hdu.axes.size())
  {
    throw NoVelocities(file, "velocity range",
      "the image has no axis of velocities (CTYPE VELO, VRAD, VOPT, FELO) or frequencies (FREQ)");
  }
  this->count = static_cast<long>(hdu.axes[this->axis]);
  this->readLaw(file, hdu);
  this->readScale(file, hdu);
}

void SpectralAxis::readLaw(const std::string& file, const FitsHdu& hdu)
{
  const std::string type = typeOf(hdu, this->axis);
  const std::string kind = type.substr(0, 4);
  const std::string code = type.size() > 5 ? type.substr(5) : "";
  const bool algorithm = code.size() >= 3 && (code[1] == '2' || code == "TAB" || code == "LOG");
  if (kind == "FELO" || (kind == "VOPT" && code == "F2W"))
  {
    this->law = Law::OpticalOfFrequency;
  }
  else if (algorithm)
  {
    throw NoVelocities(file, fitsKeyword("CTYPE", this->axis + 1),
      "velocities by '" + type + "' are not linear along the axis, which is not supported");
  }
  else if (kind == "FREQ")
  {
    this->law = Law::RadioOfFrequency;
    const double modern = hdu.header.number("RESTFRQ").value_or(0);
    this->rest = modern > 0 ? modern : hdu.header.number("RESTFREQ").value_or(0);
    if (!(this->rest > 0))
    {
      throw NoVelocities(file, "RESTFRQ", "frequencies become velocities only by a rest frequency");
    }
  }
}

void SpectralAxis::readScale(const std::string& file, const FitsHdu& hdu)
{
  const std::size_t number = this->axis + 1;
  const double unit =
    unitOf(file, fitsKeyword("CUNIT", number), hdu, this->law == Law::RadioOfFrequency);
  const std::string diagonal = std::to_string(number) + "_" + std::to_string(number);
  const double turn = hdu.header.number("PC" + diagonal).value_or(1);
  const double step =
    hdu.header.number("CD" + diagonal)
      .value_or(hdu.header.number(fitsKeyword("CDELT", number)).value_or(0) * turn);
  this->increment = step * unit;
  this->reference = hdu.header.number(fitsKeyword("CRVAL", number)).value_or(0) * unit;
  this->pixel = hdu.header.number(fitsKeyword("CRPIX", number)).value_or(0);
  if (this->increment == 0 || !std::isfinite(this->increment) || !std::isfinite(this->reference))
  {
    throw NoVelocities(file, fitsKeyword("CDELT", number), "the spectral axis has no increment");
  }
}

double SpectralAxis::velocity(double channel) const
{
  const double c = speedOfLight;
  const double step = channel - this->pixel;
  if (this->law == Law::OpticalOfFrequency)
  {
    // nu / nu_0 = 1 / (1 + v/c) is linear in the channel, its slope CDELT's at CRVAL.
    const double u = 1 / (1 + this->reference / c);
    return c * (1 / (u - u * u * this->increment / c * step) - 1);
  }
  const double value = this->reference + this->increment * step;
  return this->law == Law::RadioOfFrequency ? c * (1 - value / this->rest) : value;
}

double SpectralAxis::width(double channel) const
{
  if (this->law == Law::OpticalOfFrequency)
  {
    return std::abs(this->velocity(channel + 0.5) - this->velocity(channel - 0.5));
  }
  return std::abs(this->increment) *
    (this->law == Law::RadioOfFrequency ? speedOfLight / this->rest : 1);
}
} // namespace galaxy
