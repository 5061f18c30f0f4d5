#include "Filters/Model/SurfaceDraws.h"

#include "Filters/Model/SineCosine.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;
constexpr int ringsPerRange = 48;

/// sqrt(1 + (r kappa)^2)
double stretch(const RingFrame& ring, double r, double cosTheta, double sinTheta)
{
  const double bend = r * (ring.bendA * cosTheta + ring.bendB * sinTheta);
  return std::sqrt(1 + bend * bend);
}

/// Area on the sky by area of the flat ring, |n_z + r kappa e_r,z|.
double foreshortening(const RingFrame& ring, double r, double cosTheta, double sinTheta)
{
  const double bend = r * (ring.bendA * cosTheta + ring.bendB * sinTheta);
  return std::abs(ring.n.z + bend * (cosTheta * ring.a.z + sinTheta * ring.b.z));
}

/// Areas over pi (outer^2 - inner^2).
struct RingAreas
{
  double surface = 0;
  double sky = 0;
};

/// The means of stretch and foreshortening between two radii. Over the azimuth the sum of a smooth
/// periodic function converges at once, over so narrow a ring three Gauss-Legendre nodes in r^2 do.
RingAreas areasBetween(const TiltedDisk& disk, double inner2, double outer2)
{
  constexpr double nodes[3] = { 0.11270166537925831, 0.5, 0.88729833462074169 };
  constexpr double weights[3] = { 5 / 18.0, 8 / 18.0, 5 / 18.0 };
  constexpr int azimuths = 64;
  RingAreas mean;
  for (int node = 0; node < 3; ++node)
  {
    const double r = std::sqrt(inner2 + nodes[node] * (outer2 - inner2));
    const RingFrame ring = disk.frame(r);
    for (int k = 0; k < azimuths; ++k)
    {
      const auto [sine, cosine] = sineCosine(2 * pi * k / azimuths);
      const double weight = weights[node] / azimuths;
      mean.surface += weight * stretch(ring, r, cosine, sine);
      mean.sky += weight * foreshortening(ring, r, cosine, sine);
    }
  }
  return mean;
}

double bendOf(const RingFrame& ring)
{
  return std::hypot(ring.bendA, ring.bendB);
}
} // namespace

SurfaceDraws::SurfaceDraws(const TiltedDisk& disk, double inner, double outer)
  : disk(disk)
{
  const std::vector<double> knots = disk.knotsBetween(inner, outer);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < knots.size(); ++k)
  {
    for (int part = 0; part < ringsPerRange; ++part)
    {
      const double width = (knots[k + 1] - knots[k]) / ringsPerRange;
      const double low = knots[k] + part * width;
      const double high = part + 1 < ringsPerRange ? low + width : knots[k + 1];
      // |n'| changes little within a ring; twice its change bounds it with room to spare.
      const double bends[3] = { bendOf(disk.frame(low)), bendOf(disk.frame(0.5 * (low + high))),
        bendOf(disk.frame(std::nextafter(high, low))) };
      const auto [least, largest] = std::minmax_element(bends, bends + 3);
      const double most = high * (*largest + 2 * (*largest - *least));
      this->rings.push_back({ low * low, high * high, std::sqrt(1 + most * most) });
      const double flat = pi * (high * high - low * low);
      const RingAreas mean = areasBetween(disk, low * low, high * high);
      sum += flat * mean.surface;
      this->ends.push_back(sum);
      this->onSky += flat * mean.sky;
    }
  }
}

SurfaceDraws::Point SurfaceDraws::draw(
  const RandomKey& key, std::size_t index, std::size_t count) const
{
  const double passed = this->area() * ((index + 0.5) / count);
  const std::size_t k = std::min<std::size_t>(this->rings.size() - 1,
    std::upper_bound(this->ends.begin(), this->ends.end(), passed) - this->ends.begin());
  const Ring& ring = this->rings[k];
  // The first try stands where the running area is passed, which spreads the draws evenly.
  const double start = k > 0 ? this->ends[k - 1] : 0;
  double part = (passed - start) / (this->ends[k] - start);
  Random random(key, RandomStream::SeedPlace, index);
  for (;; part = random.uniform())
  {
    const double r = std::sqrt(ring.inner2 + part * (ring.outer2 - ring.inner2));
    const double theta = 2 * pi * random.uniform();
    if (ring.most == 1)
    {
      return { r, theta };
    }
    const auto [sine, cosine] = sineCosine(theta);
    if (random.uniform() * ring.most <= stretch(this->disk.frame(r), r, cosine, sine))
    {
      return { r, theta };
    }
  }
}
} // namespace galaxy
