#include "Filters/Splatting/NearParticle.h"

#include "Filters/Splatting/Knobs.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Where the kernel ends, in sigma; pixels' rays are known to float.
constexpr double end = 3 + 1e-5;
} // namespace

NearParticle::NearParticle(const Vec3& position, double smoothingLength, const Lens& lens)
  : sigma(sigmas(lens.kernel()) * smoothingLength)
{
  const Vec3 seen = lens.seen(position);
  this->x = seen.x / this->sigma;
  this->y = seen.y / this->sigma;
  this->z = seen.z / this->sigma;
  this->share = lens.circleShare(seen, smoothingLength);
  const Lens::Circle circle = this->share > 0 ? lens.circle(seen, smoothingLength) : Lens::Circle{};
  this->u = circle.x;
  this->v = circle.y;
  this->perSigma = this->share > 0 ? 1 / (circle.radius * this->sigma) : 0;
}

double NearParticle::profile(double u, double v) const
{
  const auto of = [](double b2) { return std::max(0.0, std::exp(-b2) - std::exp(-9.0)); };
  return nearPeak *
    ((1 - this->share) * of(this->offset2(u, v)) + this->share * of(this->circleOffset2(u, v)));
}

double NearParticle::column(double u, double v) const
{
  const double before = 0.5 + gaussianCumulative(this->along(u, v));
  return this->profile(u, v) * before / (this->sigma * this->sigma);
}

Vec3 TileCone::ray(const Camera& camera, double x, double y)
{
  const Vec3 ray = { (x - camera.centerX) / camera.scale, (y - camera.centerY) / camera.scale, 1 };
  return (1 / length(ray)) * ray;
}

TileCone::TileCone(const Camera& camera, int left_, int bottom_)
{
  const double half = tileSide / 2.0;
  this->left = (left_ - camera.centerX) / camera.scale;
  this->bottom = (bottom_ - camera.centerY) / camera.scale;
  this->right = this->left + tileSide / camera.scale;
  this->top = this->bottom + tileSide / camera.scale;
  this->middle = ray(camera, left_ + half, bottom_ + half);
  for (const int x : { left_, left_ + tileSide })
  {
    for (const int y : { bottom_, bottom_ + tileSide })
    {
      this->cosine = std::min(this->cosine, dot(this->middle, ray(camera, x, y)));
    }
  }
  this->sine = std::sqrt(std::max(0.0, 1 - this->cosine * this->cosine));
}

bool TileCone::misses(const NearParticle& particle) const
{
  return this->raysMiss(particle) && (particle.share == 0 || this->missesCircle(particle));
}

bool TileCone::missesCircle(const NearParticle& particle) const
{
  const double du = particle.u - std::clamp(particle.u, this->left, this->right);
  const double dv = particle.v - std::clamp(particle.v, this->bottom, this->top);
  return std::hypot(du, dv) * particle.perSigma >= end;
}

bool TileCone::raysMiss(const NearParticle& particle) const
{
  const double distance2 = particle.distance2();
  const double along = dot(this->middle, { particle.x, particle.y, particle.z });
  const double beside = std::sqrt(std::max(0.0, distance2 - along * along));
  if (along >= this->cosine * std::sqrt(distance2))
  {
    return false; // its centre is in the cone
  }
  // As the nearest ray of the cone sees it.
  const double s = along * this->cosine + beside * this->sine;
  const double b = beside * this->cosine - along * this->sine;
  // Rays farther from it pass it closer again only behind the eye, and then by more than 3 sigma.
  const bool isFar = distance2 >= 2 * end * end;
  return s > 0 ? b >= end && isFar : s <= -end;
}
} // namespace galaxy
