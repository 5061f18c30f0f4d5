#ifndef galaxy_BrightnessUnit_h
#define galaxy_BrightnessUnit_h

#include <string>

namespace galaxy
{
/// What a pixel's value is measured over.
enum class BrightnessKind
{
  PerPixel,
  PerBeam,
  PerSolidAngle, ///< arcsec^2
  Temperature,   ///< K, itself a surface brightness
  NotBrightness, ///< a velocity, a unit that is not known
};

/// A BUNIT taken apart: a value v of it is v * scale quantity [km/s] per pixel, beam or arcsec^2.
struct BrightnessUnit
{
  BrightnessKind kind = BrightnessKind::PerPixel;
  std::string quantity; ///< "Jy", "K", "counts", "electrons/s"; empty where the header has none
  double scale = 1;     ///< of prefixes, steradians and m/s
  bool isIntegrated = false; ///< over velocity, km/s
};

/// Reads a unit as programs write it: "Jy/beam", "JY/BEAM", "mJy beam-1", "JY/B*M/S",
/// "Jy/beam.km/s", "K km/s", "MJy/sr", "Jy/pixel", "ELECTRONS/S", "10**(-20) erg/s/cm**2/Angstrom".
/// No unit, counts of any name and fluxes are per pixel.
BrightnessUnit parseBrightnessUnit(const std::string& text);
} // namespace galaxy

#endif
