#ifndef galaxy_RayFixtures_h
#define galaxy_RayFixtures_h

#include "RenderFixtures.h"

#include <numeric>

namespace galaxy
{
/// What the eye sees of spherical Gaussians, exp(-r^2/sigma^2) with sigma = h/3, along the rays
/// through a picture's pixels: in double precision, in closed form, without an image plane.
class Rays
{
public:
  /// Each pixel the mean of samples x samples rays.
  Rays(const Scene& scene, const Camera& camera, int samples = 2)
    : scene(scene)
    , camera(camera)
    , samples(samples)
  {
    this->nearestFirst.resize(scene.h.size());
    std::iota(this->nearestFirst.begin(), this->nearestFirst.end(), 0);
    std::sort(this->nearestFirst.begin(), this->nearestFirst.end(),
      [this](int a, int b) { return length(this->fromEye(a)) < length(this->fromEye(b)); });
  }

  /// Through a point of the picture, of length 1.
  Vec3 ray(double x, double y) const
  {
    const Camera& c = this->camera;
    return normalized(
      ((x - c.centerX) / c.scale) * c.right + ((y - c.centerY) / c.scale) * c.up + c.forward);
  }
  /// From the camera's axis, of a pixel's middle.
  double angle(int column, int row) const
  {
    return std::acos(dot(this->ray(column + 0.5, row + 0.5), this->camera.forward));
  }

  /// Of channel 0, the particles one after the other as far as their middles are.
  struct Seen
  {
    double light = 0, depth = 0;
  };
  Seen pixel(int column, int row) const
  {
    Seen mean;
    for (int k = 0; k < this->samples * this->samples; ++k)
    {
      const Seen one = this->along(this->ray(column + (k % this->samples + 0.5) / this->samples,
        row + (k / this->samples + 0.5) / this->samples));
      mean.light += one.light / (this->samples * this->samples);
      mean.depth += one.depth / (this->samples * this->samples);
    }
    return mean;
  }

  Seen along(const Vec3& ray) const
  {
    Seen seen;
    for (const int i : this->nearestFirst)
    {
      const double sigma = this->scene.h[i] / 3.0;
      const Vec3 d = this->fromEye(i);
      const double s = dot(d, ray) / sigma;
      const double b2 = dot(d, d) / (sigma * sigma) - s * s;
      if (b2 > 30 || s < -6)
      {
        continue;
      }
      const double column = std::exp(-b2) * 0.5 * (1 + std::erf(s)) / (M_PI * sigma * sigma);
      const double t = this->scene.absorption[3 * i] * column;
      const double escaping = t > 0 ? -std::expm1(-t) / t : 1;
      seen.light += std::exp(-seen.depth) * this->scene.emission[3 * i] * column * escaping;
      seen.depth += t;
    }
    return seen;
  }

private:
  Vec3 fromEye(int i) const
  {
    const float* p = &this->scene.position[3 * i];
    return Vec3{ p[0], p[1], p[2] } - this->camera.eye;
  }

  const Scene& scene;
  Camera camera;
  int samples;
  std::vector<int> nearestFirst;
};
} // namespace galaxy

#endif
