#include "Filters/Splatting/Projection.h"

#include "Filters/Splatting/SplatBlock.h"

#include <algorithm>
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

int clampedFloor(double x, int low, int high)
{
  const double inRange = std::clamp(x, double(low), double(high));
  const int truncated = static_cast<int>(inRange);
  return truncated - (truncated > inRange);
}
} // namespace

Projection::Factors::Factors(const ComponentInfo& component, double weight)
  : size(component.size)
  , light(static_cast<float>(component.brightness * component.light * weight))
  , opacity(static_cast<float>(component.brightness * weight))
  , isRecolored(component.isRecolored)
{
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
  const ComponentInfo plain;
  for (std::size_t k = 0; k < std::max<std::size_t>({ components, shown, 1 }); ++k)
  {
    const ComponentInfo& info = k < components ? (*this->particles.components)[k] : plain;
    this->table.emplace_back(info, this->particles.weight);
    this->hasSizes |= info.size != 1;
  }
  for (std::size_t k = 0; k < shown; ++k)
  {
    this->table[k].visible = (*this->particles.visible)[k];
    this->hasHidden |= !this->table[k].visible;
  }
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
  // Luminosity per pixel area must stay finite in float.
  const bool finite = p.ratio > 0 && double(light.most()) * p.ratio * p.ratio < 1e37;
  if (finite && this->visible(i) && (absorbs || light.emits()))
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
