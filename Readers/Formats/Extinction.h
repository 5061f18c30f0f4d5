#ifndef galaxy_Extinction_h
#define galaxy_Extinction_h

#include "Readers/Formats/GalaxyDescription.h"

#include <array>
#include <string>
#include <vector>

namespace galaxy
{
/// A band by its name and effective wavelength in um.
struct Band
{
  std::string name;
  double wavelength;
};

/// The bands that a .galaxy file can name: GALEX's (Morrissey et al. 2005), Johnson's and Cousins'
/// (Bessell, Castelli & Plez 1998), Halpha, and IRAC's first two (Fazio et al. 2004).
const std::vector<Band>& knownBands();

/// The wavelengths in um between which a law is defined.
std::array<double, 2> wavelengthRange(ExtinctionLaw law);

/// R_V = A_V/E(B-V) of a law where none is given: 3.1 (CCM89), 4.05 (Calzetti), 0 where the law
/// has none.
double usualTotalToSelective(ExtinctionLaw law);

/// A(wavelength)/A_V at a wavelength in um, within wavelengthRange.
///
/// CCM89: Cardelli, Clayton & Mathis (1989), a(x) + b(x)/R_V of x = 1/wavelength, 0.1 to 3.3 um;
/// the infrared power law x^1.61 is continued to 5 um, where it is an extrapolation (measured
/// curves are flatter there). Calzetti: Calzetti et al. (2000), k(wavelength)/R_V, 0.12 to 2.2 um.
/// Grey: 1. Custom has no curve: NaN.
double extinctionCurve(ExtinctionLaw law, double wavelength, double totalToSelective);

/// The extinction in three bands (um) over that in V (0.545 um): RGB_A.
Color absorptionInBands(
  ExtinctionLaw law, const std::array<double, 3>& bands, double totalToSelective);
} // namespace galaxy

#endif
