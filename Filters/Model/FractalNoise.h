#ifndef galaxy_FractalNoise_h
#define galaxy_FractalNoise_h

#include "Filters/Model/Random.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Vec3.h"

#include <cstdint>
#include <vector>

namespace galaxy
{
/// Fractal noise in space, of mean 0 and variance 1 everywhere: a pure function of the random key
/// and the place, without a period.
///
/// An octave is value noise whose variance is the same at every point: the normal deviates of the
/// eight lattice points around, weighted by w_i of the quintic fade (Perlin 2002), over
/// sqrt(sum w_i^2), which makes each value itself a normal deviate. Octave k has the scale
/// noise_scale/lacunarity^k and the amplitude lacunarity^(-H k), over what makes the variance 1;
/// the lattices are turned against one another and shifted at random. More octaves add detail and
/// leave the shape of those before. Ridged noise takes 1 - |n| of each octave in place of n.
class FractalNoise
{
public:
  FractalNoise(const DustDescription& dust, const RandomKey& key);

  /// At a place in kpc.
  double operator()(const Vec3& p) const;

  /// The mean of exp(s g) over the values g of this noise: exp(s^2/2) for FBm; for ridged noise the
  /// product over the octaves of exp(t m + t^2/2) erfc(t/sqrt 2), t being s times the factor of |n|
  /// and m = sqrt(2/pi), the mean of |n|.
  double meanExponential(double s) const;

private:
  struct Octave
  {
    double frequency; ///< 1/kpc
    double amplitude;
    Vec3 shift;
    std::uint64_t seed;
  };

  std::vector<Octave> octaves;
  bool ridged;
};

/// The density of clouds relative to its mean, exp(s g)/<exp(s g)>, in a disc's own coordinates,
/// so that the clouds follow its warp. `winding` W shears them by the angle W log(1 + r/L) against
/// the rotation, L being their scale: far out they trail at the pitch angle arctan(1/W).
class FractalClouds
{
public:
  FractalClouds(const DustDescription& dust, const RandomKey& key);

  /// At r (cosTheta a + sinTheta b) + z n; of mean 1.
  double weight(double r, double cosTheta, double sinTheta, double z) const;

private:
  FractalNoise noise;
  double contrast;
  double scale;
  double winding;
  double mean;
};
} // namespace galaxy

#endif
