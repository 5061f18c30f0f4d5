#include "Filters/Model/Photometry.h"

#include "Filters/Model/ParallelFor.h"

#include <algorithm>

namespace galaxy
{
Photometry::Photometry(const LightMap& map, double typical)
  : map(map)
  , quantum(std::ldexp(1, (typical > 0 ? std::ilogb(typical) : 0) - 20))
  , perQuantum(1 / this->quantum)
  , weights(map.size(), 0)
{
}

void Photometry::weigh(const Particles& particles, std::size_t first, std::size_t last)
{
#pragma omp parallel for schedule(static)
  for (std::size_t i = first; i < last; ++i)
  {
    const std::uint32_t pixel = this->pixelOf(particles, i);
    if (pixel != LightMap::nowhere)
    {
      const double weight = this->rounded(particles.intensity[i]);
#pragma omp atomic update
      this->weights[pixel] += weight;
    }
  }
}

std::vector<std::uint32_t> Photometry::uncovered(const DiskInverse& inverse) const
{
  std::vector<std::uint32_t> found;
  for (std::uint32_t pixel = 0; pixel < this->map.size(); ++pixel)
  {
    if (!(this->weights[pixel] > 0) && this->map.isLitOn(inverse, pixel))
    {
      found.push_back(pixel);
    }
  }
  return found;
}

double Photometry::light(std::uint32_t pixel, float weight) const
{
  if (pixel == LightMap::nowhere || !(this->weights[pixel] > 0))
  {
    return 0;
  }
  return this->map.flux(pixel) * this->rounded(weight) / this->weights[pixel];
}

void Photometry::shine(
  Particles& particles, std::size_t first, std::size_t last, double factor) const
{
  parallelFor<std::size_t>(first, last, [&](std::size_t i) {
    const std::uint32_t pixel = this->pixelOf(particles, i);
    particles.intensity[i] =
      static_cast<float>(factor * this->light(pixel, particles.intensity[i]));
    if (pixel != LightMap::nowhere)
    {
      std::copy_n(this->map.color(pixel), 3, &particles.color[3 * i]);
    }
  });
}

double Photometry::evenShare(double wanted, double most) const
{
  std::vector<std::uint32_t> under;
  for (std::uint32_t pixel = 0; pixel < this->map.size(); ++pixel)
  {
    if (this->weights[pixel] > 0)
    {
      under.push_back(pixel);
    }
  }
  const auto given = [&](double each) {
    double sum = 0;
    for (const std::uint32_t pixel : under)
    {
      sum += std::min<double>(this->weights[pixel] * each, this->map.flux(pixel));
    }
    return sum;
  };
  const bool isEnough = given(most) > wanted;
  double low = 0, high = most;
  for (int halving = 0; halving < 40 && isEnough; ++halving)
  {
    const double middle = (low + high) / 2;
    (given(middle) < wanted ? low : high) = middle;
  }
  return high;
}

void Photometry::takeLight(
  Particles& particles, std::size_t first, std::size_t last, double wanted, LightMap& map)
{
  std::fill(particles.intensity.begin() + first, particles.intensity.begin() + last, 1.0F);
  Photometry photometry(map, 1);
  photometry.weigh(particles, first, last);
  const double each = photometry.evenShare(wanted, 2 * wanted / double(last - first));
  const auto lightOn = [&](std::uint32_t pixel) {
    return static_cast<float>(std::min(each, photometry.light(pixel, 1)));
  };
  parallelFor<std::size_t>(first, last, [&](std::size_t i) {
    const std::uint32_t pixel = photometry.pixelOf(particles, i);
    particles.intensity[i] = lightOn(pixel);
    if (pixel != LightMap::nowhere)
    {
      std::copy_n(map.color(pixel), 3, &particles.color[3 * i]);
    }
  });
  for (std::uint32_t pixel = 0; pixel < map.size(); ++pixel)
  {
    if (photometry.weight(pixel) > 0)
    {
      map.take(pixel, static_cast<float>(photometry.weight(pixel) * lightOn(pixel)));
    }
  }
}
} // namespace galaxy
