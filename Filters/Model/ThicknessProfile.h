#ifndef galaxy_ThicknessProfile_h
#define galaxy_ThicknessProfile_h

#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/GalaxyDescription.h"

namespace galaxy
{
/// The thickness models as functions of radius R (kpc).
///
/// Gaussian (the paper's model 1): children displaced by sigma along every axis; their mean number
/// is N0 I_p^(1 - gamma), the inverse of I_s = I_p^gamma, so that N I_s = N0 I_p.
///
/// Tapered (model 2): N = N0 exp(-R/H_r), scale height H_z, or H_z exp(-R/H_r). The paper prints
/// exp(-R/H_z), which leaves H_r without use and nearly all the disc at one child a seed:
/// TaperReading::Literal has that. Its sigma_z is H_z in either reading.
///
/// Flared (model 3): full width at half maximum after O'Brien, Freeman & van der Kruit 2010
/// (linear inside the stellar disc, exponential outside, inverse to the rotation velocity):
///   FWHM = (v_ref/v_rot)^beta { F0 + (Fb - F0) R/Rb (R <= Rb); Fb exp((R - Rb)/L) (R > Rb) },
/// at most F_max, which it is where v_rot = 0. The relation compares galaxies, so v_rot is the
/// disc's fastest (VelocityScaling::Maximum), or the fastest at R and beyond (Local), which lets
/// the gas of a falling rotation curve flare more and cannot widen it inward, where every curve
/// falls to 0. Where the rotation is not known the first factor is 1. Rows of (R, FWHM), as
/// measured, replace all of it: linear between them, constant beyond.
///
/// Hydrostatic: isothermal gas between its own sheet, the stars' disc and a spherical halo,
///   sigma_z = 2 sigma_g^2 / (B + sqrt(B^2 + 4 (nu_h^2 + nu_s^2) sigma_g^2)),
///   B = 4 pi G Sigma_g/sqrt(2 pi), nu_s^2 = 4 pi G Sigma_0 exp(-R/H_r)/(2 z0),
///   nu_h^2 = v_rot^2/(R^2 + (0.1 kpc)^2),
/// at most the radius of the last ring, where nothing holds the gas. The dispersion is turned into
/// other laws' scale heights at equal full width.
///
/// Rings: the scale height and law of the ring table, as the fit to the galaxy had them.
class ThicknessProfile
{
public:
  ThicknessProfile(const ThicknessDescription& thickness, const TiltedDisk& disk);

  LayerLaw law() const { return this->verticalLaw; }
  /// Scale height of the vertical law, kpc.
  double scaleHeight(double r) const
  {
    return this->scaleHeight(r, this->disk.rotationVelocity(r));
  }
  /// The same where the disc is known to rotate with `rotation` km/s.
  double scaleHeight(double r, double rotation) const;
  /// Mean number of children of a seed of intensity I_p.
  double meanChildren(double r, double intensity) const;
  double inPlaneSigma() const { return this->thickness.sigma; } ///< kpc

private:
  double childrensScaleLength() const;
  double flaredWidth(double r) const;
  double velocityFactor(double rotation) const;
  double hydrostaticDispersion(double r, double rotation) const;

  ThicknessDescription thickness;
  const TiltedDisk& disk;
  LayerLaw verticalLaw;
  double widthOfUnit; ///< full width at half maximum of the law at scale height 1
  double widthFactor; ///< of Flared for the disc's fastest rotation
};
} // namespace galaxy

#endif
