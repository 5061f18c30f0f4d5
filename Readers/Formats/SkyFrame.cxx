#include "Readers/Formats/SkyFrame.h"

#include <cmath>

namespace galaxy
{
namespace
{
constexpr double degree = 3.14159265358979323846 / 180;

Vec3 toDirection(const SkyPosition& sky)
{
  const double alpha = sky.ra * degree;
  const double delta = sky.dec * degree;
  return { std::cos(delta) * std::cos(alpha), std::cos(delta) * std::sin(alpha), std::sin(delta) };
}
} // namespace

SkyFrame::SkyFrame(const SkyPosition& centre, double distance)
  : distance(1000 * distance)
{
  const double alpha = centre.ra * degree;
  const double delta = centre.dec * degree;
  const Vec3 west = { std::sin(alpha), -std::cos(alpha), 0 };
  const Vec3 north = { -std::sin(delta) * std::cos(alpha), -std::sin(delta) * std::sin(alpha),
    std::cos(delta) };
  this->directions = { west, north, -1 * toDirection(centre) };
}

// Gnomonic: the line of sight meets the plane Z = 0 at D r / (r . r0).
bool SkyFrame::skyToPlane(const SkyPosition& sky, double& x, double& y) const
{
  const Vec3 r = toDirection(sky);
  const double cosine = -dot(r, this->directions[2]);
  if (!(cosine > 0))
  {
    return false;
  }
  x = this->distance * dot(r, this->directions[0]) / cosine;
  y = this->distance * dot(r, this->directions[1]) / cosine;
  return true;
}

SkyPosition SkyFrame::planeToSky(double x, double y) const
{
  const Vec3 p = this->centre() + x * this->directions[0] + y * this->directions[1];
  const double ra = std::atan2(p.y, p.x) / degree;
  return { ra < 0 ? ra + 360 : ra, std::atan2(p.z, std::hypot(p.x, p.y)) / degree };
}
} // namespace galaxy
