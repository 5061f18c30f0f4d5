#ifndef galaxy_RadialLaw_h
#define galaxy_RadialLaw_h

#include "Readers/Formats/GalaxyDescription.h"

#include <memory>

namespace galaxy
{
/// The fractions of a whole on both sides of a radius, each to its own full precision, so that
/// neither end of a distribution is lost to 1 - x.
struct MassSplit
{
  double inside;
  double outside;
};

/// A round density of mass 1 and scale 1, s = r/scale.
class RadialLaw
{
public:
  virtual ~RadialLaw() = default;
  virtual MassSplit split(double s) const = 0;
  virtual double density(double s) const = 0;
  /// The radius of a split; the inverse of split().
  virtual double radius(const MassSplit& split) const = 0;
};

/// The law of a profile. The mass of NFW, which has none as a whole, is that within `end`.
std::unique_ptr<RadialLaw> radialLaw(const SpheroidDescription& spheroid, double end);
} // namespace galaxy

#endif
