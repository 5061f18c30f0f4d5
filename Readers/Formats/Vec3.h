#ifndef galaxy_Vec3_h
#define galaxy_Vec3_h

#include <cmath>

namespace galaxy
{
/// A vector in a galaxy's frame: X to the West, Y to the North, Z toward the observer.
struct Vec3
{
  double x = 0;
  double y = 0;
  double z = 0;
};

constexpr Vec3 operator+(const Vec3& p, const Vec3& q)
{
  return { p.x + q.x, p.y + q.y, p.z + q.z };
}
constexpr Vec3 operator-(const Vec3& p, const Vec3& q)
{
  return { p.x - q.x, p.y - q.y, p.z - q.z };
}
constexpr Vec3 operator*(double s, const Vec3& p)
{
  return { s * p.x, s * p.y, s * p.z };
}
constexpr double dot(const Vec3& p, const Vec3& q)
{
  return p.x * q.x + p.y * q.y + p.z * q.z;
}
constexpr Vec3 cross(const Vec3& p, const Vec3& q)
{
  return { p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x };
}
inline double length(const Vec3& p)
{
  return std::sqrt(dot(p, p));
}
inline Vec3 normalized(const Vec3& p)
{
  return (1 / length(p)) * p;
}
} // namespace galaxy

#endif
