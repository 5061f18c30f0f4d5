#include "Filters/Model/SpheroidShape.h"

#include "Filters/Model/SineCosine.h"

#include <algorithm>

namespace galaxy
{
namespace
{
constexpr double degree = 3.14159265358979323846 / 180;

SemiAxes orientedAxes(double positionAngle, double inclination, double spin)
{
  const auto [sinPA, cosPA] = sineCosine(std::remainder(positionAngle, 360) * degree);
  const auto [sinI, cosI] = sineCosine(inclination * degree);
  const Vec3 a = { -sinPA, cosPA, 0 };
  const Vec3 n = { -sinI * cosPA, -sinI * sinPA, spin * cosI };
  return { a, cross(n, a), n };
}

SemiAxes directionsOf(const SpheroidDescription& spheroid, const TiltedDisk& disk)
{
  if (spheroid.oriented)
  {
    return orientedAxes(spheroid.positionAngle, spheroid.inclination, disk.spin());
  }
  if (spheroid.tilted)
  {
    const RingFrame ring = disk.frame(0);
    return { ring.a, ring.b, ring.n };
  }
  return { Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } };
}

SemiAxes scaled(const SemiAxes& axes, double x, double y, double z)
{
  return { x * axes[0], y * axes[1], z * axes[2] };
}
} // namespace

SpheroidShape::SpheroidShape(const SpheroidDescription& spheroid, const TiltedDisk& disk)
  : scale(scaleOf(spheroid))
  , spin(disk.spin())
  , ellipsoids(spheroid.ellipsoids)
{
  const std::array<double, 3>& sigma = spheroid.sigma;
  const std::array<double, 2>& ratios = spheroid.axisRatios;
  const SemiAxes directions = directionsOf(spheroid, disk);
  this->unit = spheroid.profile == SpheroidProfile::Gaussian
    ? scaled(directions, sigma[0], sigma[1], sigma[2])
    : scaled(directions, this->scale, this->scale * ratios[0], this->scale * ratios[1]);
}

SemiAxes SpheroidShape::semiAxes(double s) const
{
  if (this->ellipsoids.empty())
  {
    return scaled(this->unit, s, s, s);
  }
  const double semiMajor = s * this->scale;
  const EllipsoidShell shell = this->ellipsoidAt(semiMajor);
  return scaled(orientedAxes(shell.positionAngle, shell.inclination, this->spin), semiMajor,
    semiMajor * shell.axisRatios[0], semiMajor * shell.axisRatios[1]);
}

EllipsoidShell SpheroidShape::ellipsoidAt(double semiMajor) const
{
  const auto outer = std::upper_bound(this->ellipsoids.begin(), this->ellipsoids.end(), semiMajor,
    [](double radius, const EllipsoidShell& shell) { return radius < shell.semiMajor; });
  if (outer == this->ellipsoids.begin())
  {
    return this->ellipsoids.front();
  }
  if (outer == this->ellipsoids.end())
  {
    return this->ellipsoids.back();
  }
  const EllipsoidShell& p = *(outer - 1);
  const EllipsoidShell& q = *outer;
  const double t = (semiMajor - p.semiMajor) / (q.semiMajor - p.semiMajor);
  const auto between = [t](double first, double second) { return first + t * (second - first); };
  return { semiMajor,
    { between(p.axisRatios[0], q.axisRatios[0]), between(p.axisRatios[1], q.axisRatios[1]) },
    between(p.positionAngle, q.positionAngle), between(p.inclination, q.inclination) };
}
} // namespace galaxy
