#include "Filters/Splatting/Projection.h"

#include "Filters/Splatting/SplatBlock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// Finite and not negative; false for NaN.
bool isAmount(double x)
{
  return x >= 0 && x < 1e30;
}

/// Of the power of two that is no less; 0 of what is no positive number.
int exponentOf(double x)
{
  int exponent = 0;
  const bool isPower = x > 0 && std::frexp(x, &exponent) == 0.5;
  return x > 0 && x < HUGE_VAL ? exponent - isPower : 0;
}

double mostOf(const std::array<double, 3>& channels)
{
  return *std::max_element(channels.begin(), channels.end());
}

int clampedFloor(double x, int low, int high)
{
  const double inRange = std::clamp(x, double(low), double(high));
  const int truncated = static_cast<int>(inRange);
  return truncated - (truncated > inRange);
}
} // namespace

Projection::Factors::Factors(const ComponentInfo& component, double weight, const LightScale& scale)
  : size(component.size)
  , isRecolored(component.isRecolored)
{
  const double opaque = std::ldexp(component.brightness * weight, -scale.depth);
  const double bright = std::ldexp(component.brightness * component.light * weight, -scale.light);
  this->light = static_cast<float>(bright);
  this->opacity = static_cast<float>(opaque);
  for (int c = 0; c < 3; ++c)
  {
    const double color = component.isRecolored ? component.color[c] : 1;
    this->emission[c] = component.absorbs ? 0 : static_cast<float>(color * this->light / 255);
    const double absorption = component.isRecolored ? component.color[c] : component.absorption[c];
    this->absorption[c] = component.absorbs ? static_cast<float>(absorption * this->opacity) : 0;
  }
}

Projection::Projection(const ParticleView& particles_, const Lens& lens_)
  : particles(particles_)
  , eye(lens_)
  , emissionStride(particles_.emissionChannels == 1 ? 1 : 3)
  , emissionStep(particles_.emissionChannels == 1 ? 0 : 1)
  , absorptionStride(particles_.absorptionChannels == 1 ? 1 : 3)
  , absorptionStep(particles_.absorptionChannels == 1 ? 0 : 1)
{
  const std::size_t components =
    this->particles.components ? this->particles.components->size() : 0;
  const std::size_t shown = this->particles.visible ? this->particles.visible->size() : 0;
  double mostLight = 0, mostDepth = 0;
  for (std::size_t k = 0; k < components; ++k)
  {
    const ComponentInfo& info = (*this->particles.components)[k];
    const double opaque = info.brightness * this->particles.weight;
    const auto& dims = info.isRecolored ? info.color : info.absorption;
    this->hasSizes |= info.size != 1;
    mostLight = std::max(
      mostLight, opaque * info.light * (info.isRecolored ? std::max(1.0, mostOf(info.color)) : 1));
    mostDepth = std::max(mostDepth, opaque * (info.absorbs ? std::max(1.0, mostOf(dims)) : 1));
  }
  const bool isPlain = components == 0;
  this->lightFactor = exponentOf(isPlain ? this->particles.weight : mostLight);
  this->depthFactor = exponentOf(isPlain ? this->particles.weight : mostDepth);
  this->scale = { this->lightFactor, this->depthFactor, -this->lightFactor };
  this->table.resize(std::max<std::size_t>({ components, shown, 1 }));
  this->makeTable();
}

void Projection::makeTable()
{
  const std::size_t components =
    this->particles.components ? this->particles.components->size() : 0;
  const std::size_t shown = this->particles.visible ? this->particles.visible->size() : 0;
  for (std::size_t k = 0; k < this->table.size(); ++k)
  {
    const ComponentInfo info = k < components ? (*this->particles.components)[k] : ComponentInfo();
    this->table[k] = Factors(info, this->particles.weight, this->scale);
    this->table[k].visible = k >= shown || (*this->particles.visible)[k];
    this->hasHidden |= !this->table[k].visible;
  }
}

bool Projection::holds(float brightest, bool hasLight) const
{
  // Hundreds of such, grown by what hides them, are no more than float can hold; and what is
  // fainter by thirty orders is there.
  const bool isInRange = brightest <= 0x1p110F && (this->isFitted || brightest >= 0x1p-64F);
  const auto isModest = [](int exponent) { return std::abs(exponent) < 40; };
  const bool areFactors = isModest(this->lightFactor) && isModest(this->depthFactor);
  return (isInRange || !hasLight) && (areFactors || this->isFitted);
}

void Projection::fitLight()
{
  double L = 0, e = 0, K = 0;
#pragma omp parallel for reduction(max : L, e, K)
  for (std::size_t i = 0; i < this->particles.size; ++i)
  {
    ParticleCounts counts;
    if (!this->classify(i, counts).empty())
    {
      const ParticleLight light = this->light(i);
      const double ratio = this->placeOf(i).ratio;
      L = std::max<double>(L, mostOf(light.L));
      K = std::max<double>(K, mostOf(light.K));
      e = std::max(e, mostOf(light.L) * ratio * ratio);
    }
  }
  this->isFitted = true;
  // Neither the factors nor the pixels' areas may be more than float can hold.
  const int light = this->scale.light;
  this->scale.light = std::max(light + exponentOf(L) - 50, this->lightFactor - 100);
  this->scale.area = light + exponentOf(e) - 60 - this->scale.light;
  this->scale.depth = std::max(this->scale.depth + exponentOf(K) - 64, this->depthFactor - 100);
  this->makeTable();
}

const float* Projection::radii(std::size_t i, int count, float* scaled) const
{
  const float* h = this->particles.smoothingLength + i;
  if (!this->hasSizes)
  {
    return h;
  }
  for (int k = 0; k < count; ++k)
  {
    scaled[k] = static_cast<float>(h[k] * this->factors(i + k).size);
  }
  return scaled;
}

double Projection::radius(std::size_t i) const
{
  return this->particles.smoothingLength[i] * this->factors(i).size;
}

void Projection::light(
  std::size_t first, const std::uint32_t* which, int count, BlockLights& lights) const
{
  const ParticleView& p = this->particles;
  lights.areaOfLight = std::ldexp(1.0, -this->scale.area);
  lights.areaOfDepth = std::ldexp(1.0, this->scale.depth);
  // The most common arrays, with nothing to look up.
  const bool isPlain = p.emission && p.absorption && this->table.size() == 1;
  const float light = this->table[0].light, opacity = this->table[0].opacity;
  for (int k = 0; k < count; ++k)
  {
    const std::size_t i = first + which[k];
    lights.particle[k] = static_cast<std::uint32_t>(i);
    if (isPlain)
    {
      const float* L = p.emission + this->emissionStride * i;
      const float* K = p.absorption + this->absorptionStride * i;
      for (int c = 0; c < 3; ++c)
      {
        lights.L[c][k] = light * L[this->emissionStep * c];
        lights.K[c][k] = opacity * K[this->absorptionStep * c];
      }
      continue;
    }
    const ParticleLight both = this->light(i);
    for (int c = 0; c < 3; ++c)
    {
      lights.L[c][k] = both.L[c];
      lights.K[c][k] = both.K[c];
    }
  }
}

bool Projection::valid(std::size_t i, const ParticleLight& light) const
{
  const float* p = this->particles.position + 3 * i;
  return isAmount(std::abs(p[0])) && isAmount(std::abs(p[1])) && isAmount(std::abs(p[2])) &&
    isAmount(this->radius(i)) && light.valid();
}

Projection::Place Projection::placeOf(std::size_t i) const
{
  const Camera& c = this->eye.camera();
  const float* p = this->particles.position + 3 * i;
  const double radius = this->radius(i);
  Place place;
  place.seen = this->eye.seen({ p[0], p[1], p[2] });
  place.isNear = this->eye.isNear(place.seen, radius);
  if (place.isNear)
  {
    // On every pixel.
    place.ratio = c.scale / radius;
    place.h = 1e15;
  }
  else if (this->eye.isBefore(place.seen, radius))
  {
    const Lens::Circle circle = this->eye.circle(place.seen, radius);
    place.ratio = c.scale * circle.radius;
    place.x = c.centerX + c.scale * circle.x;
    place.y = c.centerY + c.scale * circle.y;
    place.h = place.ratio * radius;
  }
  return place;
}

bool Projection::isBeforeAtSameDepth(std::size_t i, std::size_t j) const
{
  const float *p = this->position(i), *q = this->position(j);
  return p[0] != q[0] ? p[0] < q[0]
    : p[1] != q[1]    ? p[1] < q[1]
    : p[2] != q[2]    ? p[2] < q[2]
                      : i > j;
}

double Projection::pixelAt(std::size_t i) const
{
  const double ratio = this->placeOf(i).ratio;
  return ratio > 0 ? 1 / ratio : 0;
}

PixelBox Projection::classify(std::size_t i, ParticleCounts& counts) const
{
  const ParticleLight light = this->light(i);
  if (!this->valid(i, light))
  {
    ++counts.invalid;
    return {};
  }
  const Camera& camera = this->eye.camera();
  const Place p = this->placeOf(i);
  PixelBox box;
  const bool absorbs = light.absorbs();
  if (p.ratio > 0 && this->visible(i) && (absorbs || light.emits()))
  {
    box.x0 = clampedFloor(p.x - p.h, 0, camera.width);
    box.y0 = clampedFloor(p.y - p.h, 0, camera.height);
    box.x1 = clampedFloor(p.x + p.h, -1, camera.width - 1) + 1;
    box.y1 = clampedFloor(p.y + p.h, -1, camera.height - 1) + 1;
  }
  if (box.empty())
  {
    ++counts.culled;
    return {};
  }
  ++counts.drawn;
  counts.emitters += light.emits();
  counts.absorbers += absorbs;
  counts.colored += absorbs && !light.grey();
  return box;
}
} // namespace galaxy
