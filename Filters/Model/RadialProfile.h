#ifndef galaxy_RadialProfile_h
#define galaxy_RadialProfile_h

#include "Filters/Model/RadialLaw.h"

#include <memory>
#include <vector>

namespace galaxy
{
/// A spheroid's radial law up to where it is truncated. Radii s are in units of scaleOf().
class RadialProfile
{
public:
  explicit RadialProfile(const SpheroidDescription& spheroid);

  /// The fraction of the mass within s.
  double massWithin(double s) const;
  /// The radius of a fraction u of the mass, 0 to 1, its inverse: ln s by cubic Hermite
  /// interpolation between exact values and slopes at equal steps of ln(u/(1 - u)), good to 1e-8;
  /// of the innermost and the outermost 1e-16 of the mass, the radius where they begin.
  double radius(double u) const;
  /// Where it ends; may be infinite.
  double end() const { return this->last; }
  /// The share of the law's mass that would lie beyond; of NFW, which has none as a whole, 0.
  double beyond() const { return this->kept.outside; }

  /// Mass per area of the round spheroid at the projected radius where a central brightness holds:
  /// 0 where it is finite there (Gaussian, Exponential, Plummer, Cored); R_e of Sersic, the
  /// radius of half of the mass of Hernquist and NFW, or of Sersic where that is smaller.
  double surfaceBrightness() const;
  /// That radius.
  double brightnessRadius() const;

private:
  double surfaceDensity(double s) const;

  SpheroidProfile kind;
  double last;
  std::unique_ptr<RadialLaw> law;
  MassSplit kept; ///< of the law's mass, what the truncation leaves
  std::vector<double> logRadius;
  std::vector<double> slope; ///< of logRadius, a step
};
} // namespace galaxy

#endif
