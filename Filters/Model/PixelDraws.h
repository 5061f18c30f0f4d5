#ifndef galaxy_PixelDraws_h
#define galaxy_PixelDraws_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/LightMap.h"

#include <cstdint>
#include <vector>

namespace galaxy
{
/// Shares a number of seeds among the pixels of a map, in proportion to their light.
///
/// A pixel that shows the disc and has the flux F_p expects e_p = lambda F_p seeds. Where there are
/// no fewer seeds than such pixels every one of them expects max(1, lambda F_p), so that none goes
/// without; lambda makes the sum the number of seeds. With the pixels along
/// Hilbert's curve and the running sum E of what they expect, seed j belongs to the pixel in which
/// E passes j + shift (systematic sampling): a pixel, or any stretch of the curve, gets its
/// expected number to within one, where independent draws would scatter by its root.
class PixelDraws
{
public:
  /// `shift`, 0 to 1, is the same for all seeds.
  PixelDraws(const LightMap& map, const DiskInverse& inverse, std::size_t seeds, double shift);

  /// The pixels with light that show the disc, along Hilbert's curve.
  std::size_t size() const { return this->pixels.size(); }
  std::uint32_t pixel(std::size_t k) const { return this->pixels[k]; }
  /// Seeds that pixel k expects.
  double expected(std::size_t k) const { return this->ends[k] - (k > 0 ? this->ends[k - 1] : 0); }
  /// The first seed of pixel k; pixel k has those up to the first of pixel k + 1.
  std::size_t firstSeed(std::size_t k) const;
  /// The pixel of a seed.
  std::size_t pixelOfSeed(std::size_t seed) const;

private:
  void share(const LightMap& map, std::size_t seeds);

  double shift;
  std::size_t seeds;
  std::vector<std::uint32_t> pixels;
  std::vector<double> ends; ///< running sum of what the pixels expect
};
} // namespace galaxy

#endif
