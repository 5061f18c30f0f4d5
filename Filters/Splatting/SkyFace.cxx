#include "Filters/Splatting/SkyFace.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// To the right, up and ahead: the first vertex ahead, five at atan(2) from it, and the opposite of
/// all.
Vec3 vertex(int face)
{
  if (face >= SkyFace::count / 2)
  {
    return -1 * vertex(face - SkyFace::count / 2);
  }
  const double angle = 2 * M_PI / 5 * (face - 1), sine = 2 / std::sqrt(5.0);
  return face == 0 ? Vec3{ 0, 0, 1 }
                   : Vec3{ sine * std::cos(angle), sine * std::sin(angle), 1 / std::sqrt(5.0) };
}

Vec3 axisOf(const Camera& ahead, int face)
{
  const Vec3 v = vertex(face);
  return v.x * ahead.right + v.y * ahead.up + v.z * ahead.forward;
}

/// Of a face at an angle from its axis, before the shares are made to be 1 together: smooth, and 0
/// where the face ends.
double weight(double cosine)
{
  const double t = std::max(0.0, cosine - std::sqrt(0.5));
  return t * t;
}
} // namespace

SkyFace::SkyFace(const Camera& ahead, int face, double scale)
{
  for (int k = 0; k < count / 2; ++k)
  {
    this->axes[k] = axisOf(ahead, k);
  }
  this->seen.eye = ahead.eye;
  this->seen.forward = axisOf(ahead, face);
  const Vec3 beside = std::abs(vertex(face).y) < 0.9 ? ahead.up : ahead.right;
  this->seen.right = normalized(cross(this->seen.forward, beside));
  this->seen.up = cross(this->seen.right, this->seen.forward);
  this->seen.scale = scale;
  // Two pixels more than 45 degrees to all sides, for the interpolation. What no memory holds is
  // refused where it is drawn.
  constexpr double largest = 1 << 29;
  const double half = std::ceil(scale) + 2;
  const int side = 2 * static_cast<int>(half < largest ? half : largest);
  this->seen.width = this->seen.height = side;
  this->seen.centerX = this->seen.centerY = 0.5 * side;
}

double SkyFace::farthest()
{
  return M_PI / 4;
}

double SkyFace::nearest(int face)
{
  return std::max(0.0, std::acos(vertex(face).z) - farthest());
}

double SkyFace::share(const Vec3& direction, double& x, double& y) const
{
  const double cosine = dot(direction, this->seen.forward);
  const double own = weight(cosine);
  if (own <= 0)
  {
    return 0;
  }
  x = this->seen.centerX + this->seen.scale * dot(direction, this->seen.right) / cosine;
  y = this->seen.centerY + this->seen.scale * dot(direction, this->seen.up) / cosine;
  double all = 0;
  for (int face = 0; face < count / 2; ++face)
  {
    // Of two opposite ones, one shows it at most.
    all += weight(std::abs(dot(direction, this->axes[face])));
  }
  return own / all;
}
} // namespace galaxy
