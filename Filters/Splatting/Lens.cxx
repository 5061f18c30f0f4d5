#include "Filters/Splatting/Lens.h"

#include "Filters/Splatting/NearParticle.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
double tangentOfField(const Camera& camera)
{
  const double x = std::max(std::abs(camera.centerX), std::abs(camera.width - camera.centerX));
  const double y = std::max(std::abs(camera.centerY), std::abs(camera.height - camera.centerY));
  return std::hypot(x, y) / camera.scale;
}
} // namespace

Lens::Lens(const Camera& camera, Kernel kernel)
  : eye(camera)
  , profile(kernel)
  , s2(NearParticle::sigmas(kernel) * NearParticle::sigmas(kernel) / 2)
  , field(1 / std::hypot(1, tangentOfField(camera)))
{
  if (!camera.parallel)
  {
    // It reaches the plane, cos(angle) < sin(radius), and into the field, cos(angle - radius) >
    // cos(field): then cos(field + radius) < sin(radius).
    const double sine = std::sqrt(1 - this->field * this->field);
    const double cotangent = (1 + sine) / this->field;
    this->reach2 = std::max(within * within, 1 + cotangent * cotangent);
  }
}

Vec3 Lens::seen(const Vec3& position) const
{
  const Vec3 d = position - this->eye.eye;
  return { dot(d, this->eye.right), dot(d, this->eye.up), dot(d, this->eye.forward) };
}

Lens::Circle Lens::circle(const Vec3& seen, double h) const
{
  if (this->eye.parallel)
  {
    return { seen.x, seen.y, 1 };
  }
  const double cosine = seen.z / length(seen);
  const double w = this->s2 * (h / seen.z) * (h / seen.z);
  const double area = (1 + w * (6 - 2 * cosine * cosine)) / cosine;
  const double out = 1 + w * (1.5 * (1 + cosine) + 6.5 * w);
  return { out * seen.x / seen.z, out * seen.y / seen.z, std::sqrt(area) / seen.z };
}

double Lens::smoothingLength(double x, double y, double radius, double distance) const
{
  if (this->eye.parallel)
  {
    return radius;
  }
  // The circle's own middle has its own radius but for the order of w.
  const double cosine = 1 / std::sqrt(1 + x * x + y * y), z = distance * cosine;
  const double first = radius * z * std::sqrt(cosine);
  const double w = this->s2 * (first / z) * (first / z);
  return first / std::sqrt(1 + w * (6 - 2 * cosine * cosine));
}

bool Lens::isNear(const Vec3& seen, double h) const
{
  const double d2 = dot(seen, seen), h2 = h * h;
  if (!(d2 < this->reach2 * h2 && (seen.z < h || d2 < within * within * h2)))
  {
    return false;
  }
  // The eye is in it, or it is on the axis, or cos(angle - radius) > cos(field).
  const double beside = std::sqrt(std::max(0.0, d2 - seen.z * seen.z));
  return d2 < h2 || (seen.z > 0 && beside < h) ||
    seen.z * std::sqrt(d2 - h2) + beside * h > d2 * this->field;
}

double Lens::circleShare(const Vec3& seen, double h)
{
  // From 3/2 of h away and 2/3 of h deep on.
  return std::clamp(std::min(2 * length(seen) / h - 3, 3 * seen.z / h - 2), 0.0, 1.0);
}
} // namespace galaxy
