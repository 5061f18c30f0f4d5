#include "Filters/Splatting/Projection.h"

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
  return x >= 0 && x <= std::numeric_limits<float>::max();
}

/// Where pixels stop being counted in int.
constexpr int farPixel = 1 << 30;

int clampedFloor(double x, int low, int high)
{
  const double inRange = std::clamp(x, double(low), double(high));
  const int truncated = static_cast<int>(inRange);
  return truncated - (truncated > inRange);
}
} // namespace

bool ParticleLight::valid() const
{
  // One comparison for six numbers: a sum of amounts is one, and NaN or infinity persist in it.
  const float least = std::min({ L[0], L[1], L[2], K[0], K[1], K[2] });
  return least >= 0 && isAmount(double(L[0]) + L[1] + L[2] + K[0] + K[1] + K[2]);
}

double ParticleLight::most() const
{
  return std::max({ L[0], L[1], L[2], K[0], K[1], K[2] });
}

ProjectionCounts& ProjectionCounts::operator+=(const ProjectionCounts& other)
{
  this->drawn += other.drawn;
  this->culled += other.culled;
  this->invalid += other.invalid;
  this->emitters += other.emitters;
  this->absorbers += other.absorbers;
  this->colored += other.colored;
  return *this;
}

Projection::Projection(const ParticleView& particles_, const Camera& camera_)
  : particles(particles_)
  , camera(camera_)
  , emissionStride(particles_.emissionChannels == 1 ? 1 : 3)
  , emissionStep(particles_.emissionChannels == 1 ? 0 : 1)
  , absorptionStride(particles_.absorptionChannels == 1 ? 1 : 3)
  , absorptionStep(particles_.absorptionChannels == 1 ? 0 : 1)
{
  const std::size_t components =
    this->particles.components ? this->particles.components->size() : 0;
  const std::size_t shown = this->particles.visible ? this->particles.visible->size() : 0;
  this->table.resize(std::max<std::size_t>({ components, shown, 1 }));
  for (std::size_t k = 0; k < components; ++k)
  {
    const ComponentInfo& info = (*this->particles.components)[k];
    Factors& factors = this->table[k];
    factors.size = info.size;
    factors.brightness = static_cast<float>(info.brightness);
    factors.emission = info.absorbs ? 0 : static_cast<float>(info.brightness / 255);
    for (int c = 0; c < 3 && info.absorbs; ++c)
    {
      factors.absorption[c] = static_cast<float>(info.brightness * info.absorption[c]);
    }
  }
  for (std::size_t k = 0; k < shown; ++k)
  {
    this->table[k].visible = (*this->particles.visible)[k];
  }
}

const Projection::Factors& Projection::factors(std::size_t i) const
{
  const std::size_t k = this->particles.component ? this->particles.component[i] : 0;
  return this->table[std::min(k, this->table.size() - 1)];
}

bool Projection::visible(std::size_t i) const
{
  return this->factors(i).visible;
}

double Projection::radius(std::size_t i) const
{
  return this->particles.smoothingLength[i] * this->factors(i).size;
}

ParticleLight Projection::light(std::size_t i) const
{
  const ParticleView& p = this->particles;
  const Factors& f = this->factors(i);
  const float I = p.intensity ? p.intensity[i] : 0;
  ParticleLight light;
  for (int c = 0; c < 3; ++c)
  {
    const int color = p.color ? p.color[3 * i + c] : 255;
    light.L[c] = p.emission
      ? f.brightness * p.emission[this->emissionStride * i + this->emissionStep * c]
      : f.emission * I * color;
    light.K[c] = p.absorption
      ? f.brightness * p.absorption[this->absorptionStride * i + this->absorptionStep * c]
      : f.absorption[c] * I;
  }
  return light;
}

bool Projection::valid(std::size_t i, const ParticleLight& light) const
{
  const float* p = this->particles.position + 3 * i;
  return isAmount(std::abs(p[0])) && isAmount(std::abs(p[1])) && isAmount(std::abs(p[2])) &&
    isAmount(this->radius(i)) && light.valid();
}

Projection::Place Projection::place(std::size_t i) const
{
  const Camera& c = this->camera;
  const float* p = this->particles.position + 3 * i;
  const Vec3 d = Vec3{ p[0], p[1], p[2] } - c.eye;
  Place place;
  place.seen = { dot(d, c.right), dot(d, c.up), dot(d, c.forward) };
  place.ratio = c.parallel ? c.scale : c.scale / place.seen.z;
  place.x = c.centerX + place.ratio * place.seen.x;
  place.y = c.centerY + place.ratio * place.seen.y;
  place.h = place.ratio * this->radius(i);
  return place;
}

void Projection::prefetch(std::size_t i) const
{
  const ParticleView& p = this->particles;
  __builtin_prefetch(p.position + 3 * i);
  __builtin_prefetch(p.smoothingLength + i);
  __builtin_prefetch(p.emission ? p.emission + this->emissionStride * i : p.intensity + i);
  __builtin_prefetch(p.absorption ? p.absorption + this->absorptionStride * i : p.intensity + i);
  __builtin_prefetch(p.color + 3 * i);
  __builtin_prefetch(p.component + i);
}

__attribute__((flatten)) PixelBox Projection::classify(
  std::size_t i, ProjectionCounts& counts) const
{
  const ParticleLight light = this->light(i);
  if (!this->valid(i, light))
  {
    ++counts.invalid;
    return {};
  }
  const Place p = this->place(i);
  PixelBox box;
  const bool absorbs = light.absorbs();
  // Luminosity per pixel area must stay finite in float.
  const bool finite = p.ratio > 0 && light.most() * p.ratio * p.ratio < 1e37;
  if (finite && this->visible(i) && (absorbs || light.emits()))
  {
    box.x0 = clampedFloor(p.x - p.h, 0, this->camera.width);
    box.y0 = clampedFloor(p.y - p.h, 0, this->camera.height);
    box.x1 = clampedFloor(p.x + p.h, -1, this->camera.width - 1) + 1;
    box.y1 = clampedFloor(p.y + p.h, -1, this->camera.height - 1) + 1;
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

__attribute__((flatten)) Splat Projection::splat(std::size_t i, int x, int y) const
{
  const Place p = this->place(i);
  const ParticleLight light = this->light(i);
  Splat splat;
  splat.column = clampedFloor(p.x, -farPixel, farPixel);
  splat.row = clampedFloor(p.y, -farPixel, farPixel);
  splat.x = static_cast<float>(p.x - splat.column);
  splat.y = static_cast<float>(p.y - splat.row);
  splat.column -= x;
  splat.row -= y;
  splat.h = static_cast<float>(std::min(p.h, 1e15));
  splat.depth = static_cast<float>(this->camera.parallel ? p.seen.z : length(p.seen));
  const float perPixel = static_cast<float>(p.ratio * p.ratio);
  for (int c = 0; c < 3; ++c)
  {
    splat.e[c] = light.L[c] * perPixel;
    splat.t[c] = light.K[c] * perPixel;
  }
  return splat;
}
} // namespace galaxy
