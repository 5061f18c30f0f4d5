#include "Filters/Splatting/NearParticle.h"

#include "Filters/Splatting/Knobs.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
double NearParticle::column(double u, double v) const
{
  const double end = std::exp(-9.0);
  const double profile = std::max(0.0, std::exp(-this->offset2(u, v)) - end);
  const double before = 0.5 + gaussianCumulative(this->along(u, v));
  return nearPeak * profile * before / (this->sigma * this->sigma);
}

Vec3 TileCone::ray(const Camera& camera, double x, double y)
{
  const Vec3 ray = { (x - camera.centerX) / camera.scale, (y - camera.centerY) / camera.scale, 1 };
  return (1 / length(ray)) * ray;
}

TileCone::TileCone(const Camera& camera, int left, int bottom)
{
  const double half = tileSide / 2.0;
  this->middle = ray(camera, left + half, bottom + half);
  for (const int x : { left, left + tileSide })
  {
    for (const int y : { bottom, bottom + tileSide })
    {
      this->cosine = std::min(this->cosine, dot(this->middle, ray(camera, x, y)));
    }
  }
  this->sine = std::sqrt(std::max(0.0, 1 - this->cosine * this->cosine));
}

bool TileCone::misses(const NearParticle& particle) const
{
  constexpr double end = 3 + 1e-5; // pixels' rays are known to float
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
