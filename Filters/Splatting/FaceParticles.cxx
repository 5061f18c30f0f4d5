#include "Filters/Splatting/FaceParticles.h"

#include "Filters/Splatting/NearParticle.h"
#include "Filters/Splatting/Projection.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Beyond it, nothing that is not near the eye reaches into a face of the cube.
constexpr double smallestCosine = 0.3;

/// Room for changed values of an array, where there is one.
const float* room(const float* values, std::size_t count, std::vector<float>& changed)
{
  changed.resize(values ? count : 0);
  return values ? changed.data() : nullptr;
}

void scale(const float* from, std::size_t first, int count, double factor, std::vector<float>& to)
{
  if (!from)
  {
    return;
  }
  for (std::size_t k = first; k < first + static_cast<std::size_t>(count); ++k)
  {
    to[k] = static_cast<float>(from[k] * factor);
  }
}

int channelsOf(int channels)
{
  return channels == 1 ? 1 : 3;
}
} // namespace

struct FaceParticles::Change
{
  Vec3 fromEye;
  double light = 1; ///< factors
  double size = 1;
};

FaceParticles::FaceParticles(const ParticleView& particles, Kernel kernel)
  : original(particles)
  , changed(particles)
  , variance(NearParticle::sigmas(kernel) * NearParticle::sigmas(kernel) / 2)
{
  const std::size_t n = particles.size;
  this->changed.position = room(particles.position, 3 * n, this->position);
  this->changed.smoothingLength = room(particles.smoothingLength, n, this->smoothingLength);
  this->changed.intensity = room(particles.intensity, n, this->intensity);
  this->changed.emission =
    room(particles.emission, channelsOf(particles.emissionChannels) * n, this->emission);
  this->changed.absorption =
    room(particles.absorption, channelsOf(particles.absorptionChannels) * n, this->absorption);
}

FaceParticles::Change FaceParticles::changeOf(
  const Vec3& d, double radius, const Camera& camera) const
{
  const double distance = length(d);
  const double along = dot(d, camera.forward) / distance;
  if (NearParticle::is(d, radius, camera) || !(along > smallestCosine))
  {
    return { d };
  }
  const Vec3 across = (1 / distance) * d - along * camera.forward;
  const double sine = length(across);
  const double s2 = this->variance * radius * radius / (distance * distance);
  Change change;
  // Not so large that it would count as near.
  const double largest = 0.999 * distance / (NearParticle::within * radius);
  change.size = std::min(1 / std::sqrt(along), std::max(1.0, largest));
  const double disc = s2 * change.size * change.size;
  const double theta = std::atan2(sine, along) + 4 * disc * sine * along;
  const double C = std::max(std::cos(theta), smallestCosine);
  change.fromEye =
    sine > 0 ? distance * (C * camera.forward + (std::sqrt(1 - C * C) / sine) * across) : d;
  change.light = (1 + s2) / (1 + disc * (9 - 15 * C * C) / 2) / C;
  return change;
}

const ParticleView& FaceParticles::seenBy(const Camera& camera)
{
  const ParticleView& from = this->original;
  const Projection projection(from, camera);
  const int emissions = channelsOf(from.emissionChannels);
  const int absorptions = channelsOf(from.absorptionChannels);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < from.size; ++i)
  {
    const float* p = from.position + 3 * i;
    const Vec3 d = Vec3{ p[0], p[1], p[2] } - camera.eye;
    const Change change = this->changeOf(d, projection.radius(i), camera);
    const Vec3 place = camera.eye + change.fromEye;
    this->position[3 * i] = static_cast<float>(place.x);
    this->position[3 * i + 1] = static_cast<float>(place.y);
    this->position[3 * i + 2] = static_cast<float>(place.z);
    scale(from.smoothingLength, i, 1, change.size, this->smoothingLength);
    scale(from.intensity, i, 1, change.light, this->intensity);
    scale(from.emission, emissions * i, emissions, change.light, this->emission);
    scale(from.absorption, absorptions * i, absorptions, change.light, this->absorption);
  }
  return this->changed;
}
} // namespace galaxy
