#ifndef galaxy_Photometry_h
#define galaxy_Photometry_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/LightMap.h"
#include "Filters/Model/Particles.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace galaxy
{
/// The two passes that give particles the light of the pixels they are seen on, along parallels:
/// moveToSightLines later makes those the sight lines from Earth. First the weights that fall on
/// every pixel, then every particle its share,
///   W_p = sum of w_i over the particles on pixel p,   L_i = F_p w_i / W_p.
/// The weights, which the particles bring in place of intensities, are rounded to multiples of a
/// power of two, about 2^-20 of a typical weight, so that their sums are exact in double precision
/// whatever the order and the threads, and sum L_i = F_p to rounding.
class Photometry
{
public:
  /// `typical`: the size of the weights, such as their mean.
  Photometry(const LightMap& map, double typical);

  /// First pass, for the particles from `first` to `last`.
  void weigh(const Particles& particles, std::size_t first, std::size_t last);
  /// W_p
  double weight(std::uint32_t pixel) const { return this->weights[pixel]; }
  /// The pixels with light that show the disc and on which no weight has fallen.
  std::vector<std::uint32_t> uncovered(const DiskInverse& inverse) const;
  /// The light of a particle of this weight on this pixel, before it is rounded to single
  /// precision; 0 off the map.
  double light(std::uint32_t pixel, float weight) const;
  /// Second pass: weights become `factor` times light, and particles take their pixel's colour.
  void shine(Particles& particles, std::size_t first, std::size_t last, double factor) const;

  /// For a population that takes its light from another's pixels: every particle gets the same, or
  /// an equal part of its pixel where that has less, and its pixel's colour; the map loses it. What
  /// pixels with too little cannot give the others do, so that it is `wanted` in all; but no more
  /// than twice an even share, for it would be another profile.
  static void takeLight(
    Particles& particles, std::size_t first, std::size_t last, double wanted, LightMap& map);

  /// The pixel that a particle is seen on.
  std::uint32_t pixelOf(const Particles& particles, std::size_t i) const
  {
    return this->map.pixelAt(particles.position[3 * i], particles.position[3 * i + 1]);
  }

private:
  /// What every particle takes of its pixel, as far as that has it, so that all have `wanted`.
  double evenShare(double wanted, double most) const;

  double rounded(float weight) const
  {
    return std::nearbyint(weight * this->perQuantum) * this->quantum;
  }

  const LightMap& map;
  double quantum;
  double perQuantum; ///< its inverse
  std::vector<double> weights;
};
} // namespace galaxy

#endif
