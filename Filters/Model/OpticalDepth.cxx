#include "Filters/Model/OpticalDepth.h"

#include "Readers/Formats/Error.h"

#include <cctype>

namespace galaxy
{
namespace
{
constexpr double starlightAt8um = 0.232;     ///< over that at 3.6 um
constexpr double hydrogenPerDepth = 2.40e21; ///< atoms/cm^2 for tau_V = 1
constexpr double squareArcsecPerSteradian = 206264.80624709636 * 206264.80624709636;
} // namespace

bool isColumnDensity(const std::string& unit)
{
  std::string plain;
  for (const char c : unit)
  {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) || c == '-' || c == '/')
    {
      plain += static_cast<char>(std::tolower(letter));
    }
  }
  for (const char* what : { "atoms", "atom", "molecules", "hi", "h2", "h", "1" })
  {
    if (plain.rfind(what, 0) == 0)
    {
      plain.erase(0, std::string(what).size());
      break;
    }
  }
  return plain == "cm-2" || plain == "/cm2";
}

double blackBodyAt250um(double temperature)
{
  constexpr double h = 6.62607015e-34, c = 299792458, k = 1.380649e-23; // SI
  constexpr double nu = c / 250e-6;
  constexpr double jansky = 1e-26;
  return 2 * h * nu * nu * nu / (c * c) / std::expm1(h * nu / (k * temperature)) / jansky;
}

const std::string& OpticalDepth::companionOf(const ComponentDescription& component)
{
  static const std::string none;
  const DepthDescription& depth = component.depth;
  switch (depth.calibration)
  {
    case DepthCalibration::PAH8um:
      return depth.stellarImage;
    case DepthCalibration::Gas:
      return depth.molecularImage;
    default:
      return none;
  }
}

OpticalDepth::OpticalDepth(const ComponentDescription& component, const std::string& file,
  const DepthImage* image, const DepthImage* companion)
  : file(file)
  , component(component.name)
  , description(component.depth)
  , calibration(component.depth.calibration)
  , perSignal(component.opticalDepth)
{
  if (!companionOf(component).empty() && companion == nullptr)
  {
    this->fail("image '" + companionOf(component) + "' was not given; add it to the .galaxy file");
  }
  switch (this->calibration)
  {
    case DepthCalibration::PAH8um:
      this->readPah(image, companion);
      break;
    case DepthCalibration::Gas:
      this->readGas(image, companion);
      break;
    case DepthCalibration::Dust250um:
      this->readDust(image);
      break;
    default:
      break;
  }
}

void OpticalDepth::readPah(const DepthImage* image, const DepthImage* companion)
{
  this->perSignal = std::nan("");
  if (companion != nullptr)
  {
    this->perValue = this->surfaceFactor(this->given(image));
    this->perCompanion = -starlightAt8um * this->surfaceFactor(*companion);
  }
}

void OpticalDepth::readGas(const DepthImage* image, const DepthImage* companion)
{
  const DepthImage& atomic = this->given(image);
  this->perSignal = this->description.dustToGas / hydrogenPerDepth;
  this->perValue = isColumnDensity(atomic.unit) ? 1 : atomic.brightness.toColumnDensity;
  if (!std::isfinite(this->perValue))
  {
    this->fail("image '" + atomic.name + "' in '" + atomic.unit +
      "' has no column density; it must be in atoms/cm2, Jy/beam km/s or K km/s");
  }
  if (companion == nullptr)
  {
    return;
  }
  const Brightness& brightness = companion->brightness;
  const bool isIntegratedTemperature =
    brightness.kind == BrightnessKind::Temperature && std::isfinite(brightness.toColumnDensity);
  if (!isColumnDensity(companion->unit) && !isIntegratedTemperature)
  {
    this->fail("image '" + companion->name + "' in '" + companion->unit +
      "' has no column density of H2; it must be in molecules/cm2 or, of CO, in K km/s");
  }
  this->perCompanion =
    2 * (isIntegratedTemperature ? this->description.coToH2 * brightness.toSurface : 1);
}

void OpticalDepth::readDust(const DepthImage* image)
{
  this->perValue = this->surfaceFactor(this->given(image)) * squareArcsecPerSteradian;
  this->perSignal =
    this->description.extinctionOver250um / blackBodyAt250um(this->description.dustTemperature);
}

void OpticalDepth::setReference(double meanSignal)
{
  if (!(meanSignal > 0) || !std::isfinite(meanSignal))
  {
    this->fail("the image shows no light within reference_radius; give a larger one");
  }
  this->perSignal = this->description.referenceDepth / meanSignal;
}

void OpticalDepth::fail(const std::string& what) const
{
  throw Error(this->file, this->component, "calibration: " + what);
}

const DepthImage& OpticalDepth::given(const DepthImage* image) const
{
  if (image == nullptr)
  {
    this->fail("must be of a component with an image");
  }
  return *image;
}

/// From the image's values to Jy/arcsec^2.
double OpticalDepth::surfaceFactor(const DepthImage& image) const
{
  if (image.brightness.surfaceUnit != "Jy/arcsec2" || !std::isfinite(image.brightness.toSurface))
  {
    this->fail("image '" + image.name + "' in '" + image.unit +
      "' must be in MJy/sr, Jy/beam or Jy/pixel; give `unit` for it in the .galaxy file");
  }
  return image.brightness.toSurface;
}
} // namespace galaxy
