#ifndef galaxy_Deredden_h
#define galaxy_Deredden_h

#include "Filters/Splatting/OpticalModel.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <cmath>

namespace galaxy
{
/// What light must be multiplied by where it was seen through dust of the optical depth tau >= 0
/// that lies in its midst: 2/(1 + e^-tau) for a sheet halfway through it, tau/(1 - e^-tau) for
/// both mixed evenly. (A screen before the light would take e^tau, which is wrong for a galaxy's
/// own dust.)
inline double dereddening(DustGeometry geometry, double tau)
{
  return geometry == DustGeometry::Sheet ? 2 / (1 + std::exp(-tau)) : 1 / escapeFraction(tau);
}

/// The same for every channel, from the depth in V and the dust's RGB_A.
inline Color dereddening(DustGeometry geometry, double tauV, const Color& absorption)
{
  return { dereddening(geometry, tauV * absorption[0]), dereddening(geometry, tauV * absorption[1]),
    dereddening(geometry, tauV * absorption[2]) };
}
} // namespace galaxy

#endif
