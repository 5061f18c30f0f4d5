#ifndef galaxy_SpreadAbsorbers_h
#define galaxy_SpreadAbsorbers_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/ParticleArrays.h"

#include <vector>

namespace galaxy
{
/// Absorbers that each stand for many. As small as they are, they would be as opaque as all of
/// those on top of each other, and leave holes where those were. What n absorbers per area let
/// through on average is exp(-n A), where A is the area that one of them would have if it were
/// black and dimmed as much: the integral of 1 - e^-t over its footprint. One that stands for
/// `weight` must have that many times the area of one, and is spread so wide that this takes no
/// more than a moderate depth; its light keeps the source function that it had.
class SpreadAbsorbers
{
public:
  /// The same particles as a camera is to see them, to be used before it is asked again.
  ParticleView of(const ParticleView& particles, const Camera& camera, Kernel kernel);

private:
  ParticleArrays arrays;
  std::vector<ComponentInfo> units; ///< of these arrays, one for each component
};
} // namespace galaxy

#endif
