#include "Filters/Splatting/SpreadAbsorbers.h"

#include "Filters/Splatting/Projection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;

/// What a spread absorber's black area is at most, over pi sigma^2: its depth in the middle is then
/// 1.35.
constexpr double mostBlack = 1;

/// The area of a Gaussian of depth t exp(-r^2/sigma^2) if it were black, over pi sigma^2,
///   Ein(t) = int_0^t (1 - e^-s)/s ds,
/// and its inverse, by tables.
class BlackArea
{
public:
  BlackArea()
  {
    for (int k = 0; k <= entries; ++k)
    {
      this->areas[k] = series(k * step);
      const double area = mostBlack * k / entries;
      double t = area;
      for (int turn = 0; turn < 6; ++turn)
      {
        t -= t > 0 ? (series(t) - area) * t / -std::expm1(-t) : 0;
      }
      this->depths[k] = t;
    }
  }
  double operator()(double t) const
  {
    constexpr double euler = 0.57721566490153286;
    return t < last ? between(this->areas, t / step) : euler + std::log(t);
  }
  /// For an area of mostBlack or less.
  double depthOf(double area) const { return between(this->depths, area / mostBlack * entries); }

private:
  static constexpr int entries = 4096;
  static constexpr double last = 16, step = last / entries;
  using Table = std::array<double, entries + 1>;

  static double series(double t)
  {
    double sum = 0, power = -1;
    for (int k = 1; k < 80; ++k)
    {
      power *= -t / k;
      sum += power / k;
    }
    return sum;
  }
  static double between(const Table& table, double at)
  {
    const int k = std::clamp(static_cast<int>(at), 0, entries - 1);
    return table[k] + (at - k) * (table[k + 1] - table[k]);
  }

  Table areas, depths;
};

/// An absorber as pixels of a size show it: the Gaussian of its variance and the pixel's.
class Footprint
{
public:
  Footprint(double sigma, double pixel)
    : variance(sigma * sigma + pixel * pixel / 6)
    , evenness(pixel * pixel / 6 / variance)
  {
  }
  /// The area that is black for a cross-section K. What is smaller than a pixel dims it evenly:
  /// within 5 % of the mean over the places in a pixel, for t < 10.
  double blackArea(const BlackArea& black, double K) const
  {
    const double area = 2 * pi * this->variance; // as an even one has the same mean depth
    const double t = K / area;
    const double square = this->evenness * this->evenness, even = square * square;
    const double widest = 36 * this->variance; // kernels end
    return std::min(area * (even * -std::expm1(-t) + (1 - even) * black(2 * t) / 2), widest);
  }
  /// The inverse, where the mean depth is thin: both kinds are t - t^2/2 + t^3/5 about.
  double thinCrossSection(double area) const
  {
    const double unit = 2 * pi * this->variance, a = area / unit;
    return unit * (a + a * a / 2 + 0.3 * a * a * a);
  }
  bool isThin(double area) const { return area <= 0.2 * 2 * pi * this->variance; }
  /// The inverse, of what is larger than a pixel.
  double crossSection(const BlackArea& black, double area) const
  {
    const double unit = pi * this->variance;
    return unit * black.depthOf(std::min(area / unit, mostBlack));
  }

private:
  double variance, evenness;
};

/// What one absorber becomes.
struct Spread
{
  double radius;
  double K[3];
};

Spread spread(double radius, const double* K, double weight, double pixel, double sigmas)
{
  static const BlackArea black;
  const Footprint before(sigmas * radius, pixel);
  const double most = weight * before.blackArea(black, std::max({ K[0], K[1], K[2] }));
  const bool isThin = before.isThin(most);
  const double wide = std::max(0.7 * pixel, std::sqrt(most / (pi * mostBlack)));
  const double sigma = std::max(sigmas * radius, isThin ? 0 : wide);
  const Footprint after(sigma, pixel);
  Spread spread = { sigma / sigmas, {} };
  for (int c = 0; c < 3; ++c)
  {
    const double area = weight * before.blackArea(black, K[c]);
    spread.K[c] = c > 0 && K[c] == K[0] ? spread.K[0]
      : isThin                          ? after.thinCrossSection(area)
                                        : after.crossSection(black, area);
  }
  return spread;
}

bool canAbsorb(const ParticleView& particles)
{
  const auto isAbsorber = [](const ComponentInfo& component) { return component.absorbs; };
  return particles.absorption ||
    (particles.components &&
      std::any_of(particles.components->begin(), particles.components->end(), isAbsorber));
}
} // namespace

ParticleView SpreadAbsorbers::of(const ParticleView& particles, const Camera& camera, Kernel kernel)
{
  const double weight = particles.weight;
  if (weight == 1 || !canAbsorb(particles))
  {
    return particles;
  }
  ParticleView single = particles;
  single.weight = 1;
  const Projection projection(single, { camera, kernel });
  const double sigmas = NearParticle::sigmas(kernel);
  this->arrays.smoothingLength.resize(particles.size);
  this->arrays.emission.resize(3 * particles.size);
  this->arrays.absorption.resize(3 * particles.size);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < particles.size; ++i)
  {
    ParticleLight light = projection.light(i);
    double radius = projection.radius(i);
    const double pixel = projection.pixelAt(i);
    if (light.absorbs() && projection.valid(i, light) && (radius > 0 || pixel > 0))
    {
      const double unit = projection.depthUnit();
      const double K[3] = { light.K[0] * unit, light.K[1] * unit, light.K[2] * unit };
      const Spread wide = spread(radius, K, weight, pixel, sigmas);
      radius = wide.radius;
      for (int c = 0; c < 3; ++c)
      {
        const double share = K[c] > 0 ? wide.K[c] / (weight * K[c]) : 1;
        light.L[c] = static_cast<float>(light.L[c] * share);
        light.K[c] = static_cast<float>(light.K[c] * share);
      }
    }
    this->arrays.smoothingLength[i] = static_cast<float>(radius);
    std::copy_n(light.L, 3, &this->arrays.emission[3 * i]);
    std::copy_n(light.K, 3, &this->arrays.absorption[3 * i]);
  }
  // The components' factors are in these already.
  ComponentInfo unit;
  unit.brightness = projection.depthUnit();
  unit.light = projection.lightUnit() / projection.depthUnit();
  this->units.assign(
    particles.visible ? std::max<std::size_t>(1, particles.visible->size()) : 1, unit);
  ParticleView view = particles;
  view.components = &this->units;
  view.emissionChannels = view.absorptionChannels = 3;
  return this->arrays.view(view);
}
} // namespace galaxy
