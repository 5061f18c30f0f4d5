#include "Filters/Model/PixelDraws.h"

#include "Filters/Model/HilbertOrder.h"
#include "Filters/Model/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
std::vector<char> pixelsOnDisk(const LightMap& map, const DiskInverse& inverse)
{
  std::vector<char> onDisk(map.size());
  parallelForDynamic<std::size_t>(0, map.size(), 4096,
    [&](std::size_t k) { onDisk[k] = map.isLitOn(inverse, static_cast<std::uint32_t>(k)); });
  return onDisk;
}
} // namespace

PixelDraws::PixelDraws(
  const LightMap& map, const DiskInverse& inverse, std::size_t seeds, double shift)
  : shift(shift)
  , seeds(seeds)
{
  const std::vector<char> onDisk = pixelsOnDisk(map, inverse);
  this->pixels.reserve(std::count(onDisk.begin(), onDisk.end(), 1));
  HilbertOrder(map.width(), map.height(), [&](int column, int row) {
    const auto pixel = static_cast<std::uint32_t>(row) * map.width() + column;
    if (onDisk[pixel])
    {
      this->pixels.push_back(pixel);
    }
  });
  this->share(map, seeds);
}

// e_p = max(least, lambda F_p): lambda falls from its value without a least as pixels below it take
// theirs, which can only bring more pixels below, so that the iteration ends.
void PixelDraws::share(const LightMap& map, std::size_t seeds)
{
  if (this->pixels.empty() || seeds == 0)
  {
    this->ends.assign(this->pixels.size(), 0);
    return;
  }
  const double least = seeds >= this->pixels.size() ? 1 : 0;
  double lambda = std::numeric_limits<double>::infinity(); // at first no pixel is below its least
  std::size_t below = 0;
  for (bool settled = false; !settled;)
  {
    double flux = 0;
    std::size_t count = 0;
    for (const std::uint32_t pixel : this->pixels)
    {
      const bool isBelow = lambda * map.flux(pixel) < least;
      count += isBelow;
      flux += isBelow ? 0 : map.flux(pixel);
    }
    settled = std::isfinite(lambda) && count <= below;
    below = count;
    lambda = flux > 0 ? static_cast<double>(seeds - below) / flux : 0;
  }
  double sum = 0;
  this->ends.reserve(this->pixels.size());
  for (const std::uint32_t pixel : this->pixels)
  {
    sum += std::max(least, lambda * map.flux(pixel));
    this->ends.push_back(sum);
  }
  // What rounding has left must not keep the last seed from its pixel.
  this->ends.back() = std::max(sum, static_cast<double>(seeds));
}

std::size_t PixelDraws::firstSeed(std::size_t k) const
{
  const double start = k > 0 ? this->ends[k - 1] : 0;
  return std::min(
    this->seeds, static_cast<std::size_t>(std::max(0.0, std::ceil(start - this->shift))));
}

std::size_t PixelDraws::pixelOfSeed(std::size_t seed) const
{
  const auto end =
    std::upper_bound(this->ends.begin(), this->ends.end(), static_cast<double>(seed) + this->shift);
  return std::min<std::size_t>(end - this->ends.begin(), this->ends.size() - 1);
}
} // namespace galaxy
