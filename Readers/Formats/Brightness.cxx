#include "Readers/Formats/Brightness.h"

#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Beam.h"
#include "Readers/Formats/NoCoordinates.h"
#include "Readers/Formats/Vec3.h"

#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
const double pi = std::acos(-1.0);
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double arcsecPerRadian = 206264.80624709636;

// Atoms per cm^2: N = 1.104e24 I/(bmaj bmin) of I in Jy/beam km/s and a beam in arcsec, which is
// per arcsec^2 of the Gaussian beam; and N = 1.823e18 T of T in K km/s.
const double atomsPerJansky = 1.104e24 * pi / (4 * std::log(2.0));
constexpr double atomsPerKelvin = 1.823e18;

Vec3 direction(const WorldCoordinates& world, const PixelPosition& pixel, const std::string& file)
{
  SkyPosition sky;
  if (!world.pixelToSky(pixel, sky))
  {
    throw NoCoordinates(file, "CRPIX", "the image's middle is not on the sky");
  }
  const double alpha = sky.ra * pi / 180, delta = sky.dec * pi / 180;
  return { std::cos(delta) * std::cos(alpha), std::cos(delta) * std::sin(alpha), std::sin(delta) };
}

/// `pixel` is the width of one, arcsec.
double beamAreaOf(const Image& image, const ImageDescription& description, double pixel)
{
  if (description.beam > 0)
  {
    return Beam{ description.beam, description.beam, 0 }.solidAngle();
  }
  const auto beam = beamOf(image);
  if (beam)
  {
    requireBeamInImage(image, *beam, pixel);
  }
  return beam ? beam->solidAngle() : 0;
}

/// The factor from the unit's quantity to what there is of it in an arcsec^2.
double perSquareArcsec(const BrightnessUnit& unit, const Brightness& brightness)
{
  switch (unit.kind)
  {
    case BrightnessKind::PerPixel:
      return unit.scale / brightness.pixelArea;
    case BrightnessKind::PerBeam:
      return unit.scale / brightness.beamArea;
    case BrightnessKind::PerSolidAngle:
    case BrightnessKind::Temperature:
      return unit.scale;
    case BrightnessKind::NotBrightness:
      break;
  }
  return nan;
}

double columnDensityFactor(const BrightnessUnit& unit)
{
  if (!unit.isIntegrated)
  {
    return nan;
  }
  if (unit.kind == BrightnessKind::Temperature)
  {
    return atomsPerKelvin;
  }
  return unit.quantity == "Jy" ? atomsPerJansky : nan;
}
} // namespace

double pixelArea(const Image& image, const ImageDescription& description)
{
  const WorldCoordinates world = coordinatesOf(image, description);
  const double x = 0.5 * (image.width + 1), y = 0.5 * (image.height + 1);
  const auto at = [&](double dx, double dy) {
    return direction(world, { x + dx, y + dy }, image.file);
  };
  const Vec3 right = at(0.5, 0) - at(-0.5, 0);
  const Vec3 up = at(0, 0.5) - at(0, -0.5);
  return length(cross(right, up)) * arcsecPerRadian * arcsecPerRadian;
}

Brightness brightnessOf(const Image& image, const ImageDescription& description)
{
  const BrightnessUnit unit = parseBrightnessUnit(image.unit);
  Brightness brightness;
  brightness.kind = unit.kind;
  brightness.pixelArea = pixelArea(image, description);
  const bool isPerBeam = unit.kind == BrightnessKind::PerBeam;
  brightness.beamArea =
    isPerBeam ? beamAreaOf(image, description, std::sqrt(brightness.pixelArea)) : 0;
  if (isPerBeam && !(brightness.beamArea > 0))
  {
    throw Error(image.file, "BMAJ",
      "the unit " + image.unit +
        " needs a beam and the header has none; give `beam = [bmaj, bmin, bpa]` (arcsec, degrees) "
        "or another `unit` for this image in the .galaxy file");
  }
  brightness.toSurface = perSquareArcsec(unit, brightness);
  brightness.toPixel = brightness.toSurface * brightness.pixelArea;
  brightness.toColumnDensity = brightness.toSurface * columnDensityFactor(unit);
  brightness.surfaceUnit = (unit.kind == BrightnessKind::Temperature
                               ? unit.quantity
                               : (unit.quantity.empty() ? "1" : unit.quantity) + "/arcsec2") +
    (unit.isIntegrated ? " km/s" : "");
  return brightness;
}

double hydrogenMass(const Image& image, const Brightness& brightness, double distance)
{
  double sum = 0;
  for (const double value : image.values)
  {
    sum += std::isnan(value) ? 0 : value;
  }
  // M = 2.356e5 D^2 F of the flux F in Jy km/s.
  const double flux = sum * brightness.toColumnDensity / atomsPerJansky * brightness.pixelArea;
  return 2.356e5 * distance * distance * flux;
}

void convertBrightness(const ImageDescription& description, Image& image)
{
  if (!description.unit.empty())
  {
    image.unit = description.unit;
  }
  if (description.convert == BrightnessConversion::None)
  {
    return;
  }
  const Brightness brightness = brightnessOf(image, description);
  const bool toSurface = description.convert == BrightnessConversion::SurfaceBrightness;
  const double factor = toSurface ? brightness.toSurface : brightness.toColumnDensity;
  if (std::isnan(factor))
  {
    throw Error(image.file, "BUNIT",
      "no way from '" + image.unit + "' to " +
        (toSurface ? "surface brightness" : "a column density, which needs Jy km/s or K km/s") +
        "; give `unit` for this image in the .galaxy file");
  }
  for (double& value : image.values)
  {
    value *= factor;
  }
  image.unit = toSurface ? brightness.surfaceUnit : "cm-2";
}
} // namespace galaxy
