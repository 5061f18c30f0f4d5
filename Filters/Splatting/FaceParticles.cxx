#include "Filters/Splatting/FaceParticles.h"

#include "Filters/Model/ParallelFor.h"
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

/// Room for `width` changed values of each particle, where it has any.
Buffer<float> room(const float* values, std::size_t width, const ParticleView& particles)
{
  return Buffer<float>(values ? width * particles.size : 0);
}

/// Scales the `width` values of particle i.
void scale(const float* from, std::size_t i, std::size_t width, double factor, Buffer<float>& to)
{
  for (std::size_t k = width * i; from && k < width * (i + 1); ++k)
  {
    to[k] = static_cast<float>(from[k] * factor);
  }
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
  , variance(NearParticle::sigmas(kernel) * NearParticle::sigmas(kernel) / 2)
{
  this->arrays.position = room(particles.position, 3, particles);
  this->arrays.smoothingLength = room(particles.smoothingLength, 1, particles);
  this->arrays.intensity = room(particles.intensity, 1, particles);
  this->arrays.emission = room(particles.emission, particles.emissionChannels, particles);
  this->arrays.absorption = room(particles.absorption, particles.absorptionChannels, particles);
  this->changed = this->arrays.view(particles);
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
  ParticleArrays& to = this->arrays;
  const Projection projection(from, camera);
  parallelFor<std::size_t>(0, from.size, [&](std::size_t i) {
    const float* p = from.position + 3 * i;
    const Vec3 d = Vec3{ p[0], p[1], p[2] } - camera.eye;
    const Change change = this->changeOf(d, projection.radius(i), camera);
    const Vec3 place = camera.eye + change.fromEye;
    to.position[3 * i] = static_cast<float>(place.x);
    to.position[3 * i + 1] = static_cast<float>(place.y);
    to.position[3 * i + 2] = static_cast<float>(place.z);
    scale(from.smoothingLength, i, 1, change.size, to.smoothingLength);
    scale(from.intensity, i, 1, change.light, to.intensity);
    scale(from.emission, i, from.emissionChannels, change.light, to.emission);
    scale(from.absorption, i, from.absorptionChannels, change.light, to.absorption);
  });
  return this->changed;
}
} // namespace galaxy
