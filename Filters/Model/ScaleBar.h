#ifndef galaxy_ScaleBar_h
#define galaxy_ScaleBar_h

#include <string>

namespace galaxy
{
/// The bar under a picture that says how large things are.
struct ScaleBar
{
  double length = 0; ///< kpc: 1, 2 or 5 times a power of ten; 0: none
  std::string label; ///< as "5 kpc = 3.8'"
};

/// The longest bar of no more than `most` kpc. Where the distance from Earth (kpc) is known,
/// greater than 0, its label also says how large it is on the sky.
ScaleBar scaleBar(double most, double distance);

/// With three digits at most, and the unit that needs the fewest: pc, kpc or Mpc; ", ' or °, which
/// all fonts have.
std::string lengthText(double kpc);
std::string angleText(double radians);
} // namespace galaxy

#endif
