#include "Filters/Model/ExponentialSeeds.h"

#include "Filters/Model/BlockSum.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/SeedArrays.h"
#include "Filters/Model/SurfaceDraws.h"
#include "Readers/Formats/Error.h"

#include <cmath>

namespace galaxy
{
namespace
{
constexpr double pi = 3.14159265358979323846;

/// The light of exp(-(r - inner)/h) from `inner` out to a radius, over 2 pi: the integral of
/// (inner + x) exp(-x/h) over x = r - inner, which stays itself however many h the hole is wide.
double enclosedLight(double radius, double inner, double h)
{
  const double x = (radius - inner) / h;
  const double risen = -std::expm1(-x);
  return h * (inner * risen + h * (risen - x * std::exp(-x)));
}

/// The radius within which the fraction u of the light between two radii lies, by bisection to the
/// last bit.
double exponentialRadius(double u, double inner, double outer, double h)
{
  const double wanted = u * enclosedLight(outer, inner, h);
  double left = inner, right = outer;
  for (double middle = 0.5 * (left + right); middle > left && middle < right;
       middle = 0.5 * (left + right))
  {
    (enclosedLight(middle, inner, h) < wanted ? left : right) = middle;
  }
  return 0.5 * (left + right);
}

/// Draws from exp(-r/h): ImageDriven in proportion to it, SurfaceUniform with it as their light.
class ExponentialSampler
{
public:
  ExponentialSampler(const TiltedDisk& disk, const ComponentDescription& component,
    const RandomKey& key, const std::string& file, Seeds& seeds)
    : component(component)
    , key(key)
    , seeds(seeds)
    , h(component.scaleLength)
    , byLight(component.sampling == SeedSampling::ImageDriven)
    , surface(disk, seeds.innerRadius, seeds.outerRadius)
    , shown(shownColor(component.color))
  {
    const double brightest = component.role == ComponentRole::Absorbs ? 1 : this->shown.intensity;
    this->atInner = brightest * std::exp(-seeds.innerRadius / this->h);
    if (brightest > 0 && !(static_cast<float>(this->atInner) > 0))
    {
      throw Error(file, component.name,
        "scale_length leaves no light at inner_radius; give a longer one, or a smaller "
        "inner_radius");
    }
  }

  void sample(const DrawRange& range)
  {
    const double light = this->atInner * this->lightPerFall();
    resizeSeeds(this->seeds, this->atInner > 0 ? range.size() : 0);
    parallelFor<std::size_t>(0, this->seeds.size(), [&](std::size_t i) {
      const std::size_t j = range.first + i;
      const SurfaceDraws::Point point = this->draw(j);
      const double fall = this->fall(point.r);
      setSeed(
        this->seeds, i, point.r, point.theta, this->atInner * fall, this->shown.ratios.data(), j);
      this->seeds.light[i] = static_cast<float>(light * (this->byLight ? 1 : fall));
    });
  }

private:
  double fall(double r) const { return std::exp(-(r - this->seeds.innerRadius) / this->h); }

  SurfaceDraws::Point draw(std::size_t j) const
  {
    if (!this->byLight)
    {
      return this->surface.draw(this->key, j, this->seeds.drawn);
    }
    Random random(this->key, RandomStream::SeedPlace, j);
    const double u = (j + random.uniform()) / this->seeds.drawn;
    return { exponentialRadius(u, this->seeds.innerRadius, this->seeds.outerRadius, this->h),
      2 * pi * random.uniform() };
  }

  /// What a draw's light is over its fall, or over 1: the component's light by the sum of the
  /// draws' weights, whoever has them.
  double lightPerFall() const
  {
    const auto drawn = static_cast<double>(this->seeds.drawn);
    const double total =
      2 * pi * enclosedLight(this->seeds.outerRadius, this->seeds.innerRadius, this->h);
    if (this->byLight)
    {
      return total / drawn;
    }
    if (this->component.normalizeAt == NormalizeAt::None)
    {
      return this->surface.area() / drawn;
    }
    Buffer<float> weights(this->seeds.drawn);
    parallelFor<std::size_t>(0, weights.size(),
      [&](std::size_t j) { weights[j] = static_cast<float>(this->fall(this->draw(j).r)); });
    return total / blockSum(weights, 0, weights.size());
  }

  const ComponentDescription& component;
  RandomKey key;
  Seeds& seeds;
  double h;
  bool byLight;
  SurfaceDraws surface;
  ShownColor shown;
  double atInner = 0;
};
} // namespace

void sampleExponential(const TiltedDisk& disk, const ComponentDescription& component,
  const RandomKey& key, const DrawRange& range, const std::string& file, Seeds& seeds)
{
  ExponentialSampler(disk, component, key, file, seeds).sample(range);
}
} // namespace galaxy
