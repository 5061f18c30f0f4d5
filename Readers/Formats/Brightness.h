#ifndef galaxy_Brightness_h
#define galaxy_Brightness_h

#include "Readers/Formats/BrightnessUnit.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

#include <string>

namespace galaxy
{
/// What factor turns an image's values into which brightness. A factor is NaN where the unit is
/// none of that kind.
struct Brightness
{
  BrightnessKind kind = BrightnessKind::NotBrightness;
  double toSurface = 0;       ///< into quantity [km/s] per arcsec^2; K stays K
  double toPixel = 0;         ///< into quantity [km/s] per pixel
  double toColumnDensity = 0; ///< into H I atoms per cm^2, for Jy km/s and K km/s
  std::string surfaceUnit;    ///< "Jy/arcsec2 km/s"
  double pixelArea = 0;       ///< arcsec^2 on the sky, at the image's middle
  double beamArea = 0;        ///< arcsec^2; 0 where the unit needs none
};

/// From the image's unit, its coordinates and its beam; the description's beam goes before the
/// header's. Throws Error naming the keyword where the unit needs a beam and there is none.
Brightness brightnessOf(const Image& image, const ImageDescription& description);

/// The solid angle of the pixel at the image's middle, arcsec^2.
double pixelArea(const Image& image, const ImageDescription& description);

/// The mass of the atomic hydrogen in the image, Msun, optically thin; blank pixels count nothing.
/// `distance` in Mpc. NaN where the unit has no column density.
double hydrogenMass(const Image& image, const Brightness& brightness, double distance);

/// Changes the image's values and unit as the description's `unit` and `convert` ask.
/// Throws Error where its unit cannot be converted so.
void convertBrightness(const ImageDescription& description, Image& image);
} // namespace galaxy

#endif
