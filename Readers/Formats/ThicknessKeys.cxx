#include "Readers/Formats/GalaxyKeys.h"

#include <climits>

namespace galaxy
{
const Keys<ThicknessDescription>& thicknessKeys()
{
  using T = ThicknessDescription;
  static const Keys<T> keys = {
    choiceKey<T>("model", &T::model, { "Gaussian", "Tapered", "Flared", "Hydrostatic", "Rings" },
      "How a seed becomes a cloud of children."),
    choiceKey<T>("law", &T::law, { "Gaussian", "Sech2", "Exponential", "Lorentzian", "Box" },
      "Vertical density law of Tapered, Flared and Hydrostatic.", 1),
    numberKey<T>("children", &T::children, Range::notNegative(), "",
      "Children a seed, at intensity 1 (Gaussian) or at the centre (the others)."),
    integerKey<T>("maximum_children", &T::maximumChildren, 1, INT_MAX,
      "Most children a seed; the light is kept."),
    numberKey<T>("sigma", &T::sigma, Range::notNegative(), "kpc",
      "Spread in all directions (Gaussian) or in the plane (the others)."),
    numberKey<T>("compression", &T::compression, Range::from(0, 1), "",
      "Exponent from the image's intensity to the seed's (Gaussian)."),
    numberKey<T>("scale_length", &T::scaleLength, Range::positive(), "kpc",
      "Radial scale length: of the children (Tapered) or the stars (Hydrostatic)."),
    numberKey<T>("scale_height", &T::scaleHeight, Range::positive(), "kpc",
      "Vertical scale: of the children (Tapered) or the stars (Hydrostatic)."),
    flagKey<T>("taper_thickness", &T::taperThickness,
      "Whether the thickness falls with radius as the children do (Tapered)."),
    numberKey<T>("fwhm_centre", &T::fwhmCentre, Range::notNegative(), "kpc",
      "Full width at half maximum at the centre (Flared)."),
    numberKey<T>("fwhm_edge", &T::fwhmEdge, Range::positive(), "kpc",
      "Full width at half maximum at the stellar disc's edge (Flared)."),
    numberKey<T>("edge_radius", &T::edgeRadius, Range::positive(), "kpc",
      "Radius of the stellar disc's edge (Flared)."),
    numberKey<T>("flare_length", &T::flareLength, Range::positive(), "kpc",
      "Length of the exponential flare beyond the edge (Flared)."),
    numberKey<T>("fwhm_maximum", &T::fwhmMaximum, Range::positive(), "kpc",
      "Largest full width at half maximum (Flared)."),
    numberKey<T>("reference_velocity", &T::referenceVelocity, Range::positive(), "km/s",
      "Rotation velocity at which the widths hold (Flared)."),
    numberKey<T>("velocity_exponent", &T::velocityExponent, Range::any(), "",
      "Exponent of reference over rotation velocity (Flared)."),
    numberKey<T>("gas_dispersion", &T::gasDispersion, Range::positive(), "km/s",
      "Velocity dispersion of the gas (Hydrostatic)."),
    numberKey<T>("stellar_surface_density", &T::stellarSurfaceDensity, Range::notNegative(),
      "Msun/pc^2", "Surface density of the stars at the centre (Hydrostatic)."),
    numberKey<T>("gas_surface_density", &T::gasSurfaceDensity, Range::notNegative(), "Msun/pc^2",
      "Surface density of the gas (Hydrostatic)."),
  };
  return keys;
}
} // namespace galaxy
