#ifndef galaxy_NearParticle_h
#define galaxy_NearParticle_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/GaussianKernel.h"
#include "Filters/Splatting/Render.h"

#include <cmath>

namespace galaxy
{
/// A particle that the eye is in, or almost: it is no disc on the image plane. Every pixel looks
/// along its own ray, which passes the centre at a distance b of its own, and sees the part of the
/// column that lies before the eye: of exp(-r^2/sigma^2), with (1 + erf(s/sigma))/2 where s is how
/// far along the ray the centre is. A cubic spline is drawn as the Gaussian of its variance.
struct NearParticle
{
  double x, y, z; ///< of the centre, from the eye to the right, up and forward, in sigma
  double sigma;   ///< kpc

  NearParticle(const Vec3& position, double smoothingLength, Kernel kernel, const Camera& camera)
    : sigma(sigmas(kernel) * smoothingLength)
  {
    const Vec3 d = (1 / this->sigma) * (position - camera.eye);
    this->x = dot(d, camera.right);
    this->y = dot(d, camera.up);
    this->z = dot(d, camera.forward);
  }

  /// Nearer than so many smoothing lengths: at 2, the image plane and the rays' own distances agree
  /// to 1 % over the kernel's sigma.
  static constexpr double within = 2;

  /// Whether a particle is, at such a place from the eye; in a parallel projection none is.
  static bool is(const Vec3& fromEye, double smoothingLength, const Camera& camera)
  {
    return !camera.parallel && length(fromEye) < within * smoothingLength;
  }

  /// Of the kernel, in smoothing lengths.
  static constexpr double sigmas(Kernel kernel)
  {
    return kernel == Kernel::Gaussian ? 1.0 / 3 : 0.3873;
  }

  /// From the eye, sigma^2.
  double distance2() const { return this->x * this->x + this->y * this->y + this->z * this->z; }

  /// In sigma^2, b^2 of the ray through (u, v, 1), and s in sigma.
  double offset2(double u, double v) const
  {
    const double cx = this->y - this->z * v, cy = this->z * u - this->x,
                 cz = this->x * v - this->y * u;
    return (cx * cx + cy * cy + cz * cz) / (1 + u * u + v * v);
  }
  double along(double u, double v) const
  {
    return (this->x * u + this->y * v + this->z) / std::sqrt(1 + u * u + v * v);
  }

  /// The share of its light that a ray sees, per kpc^2.
  double column(double u, double v) const;
};

/// The directions that a tile's pixels look into.
class TileCone
{
public:
  TileCone() = default;
  TileCone(const Camera& camera, int left, int bottom);

  /// Through a point of the image: right, up and forward, of length 1.
  static Vec3 ray(const Camera& camera, double x, double y);

  /// Whether no ray of the tile passes the particle within 3 sigma, in front of the eye or no more
  /// than 3 sigma behind it, where the kernel ends.
  bool misses(const NearParticle& particle) const;

private:
  Vec3 middle;                 ///< right, up and forward, of length 1
  double cosine = 1, sine = 0; ///< of the angle from there to the farthest corner
};

/// The most of its light that a pixel can have, where a pixel is as large as one at the distance of
/// the smoothing length, 1 over the camera's scale.
inline float nearMostOfAPixel(Kernel kernel, const Camera& camera)
{
  const double sigma = camera.scale * NearParticle::sigmas(kernel);
  return static_cast<float>(gaussianPeak / (sigma * sigma));
}
} // namespace galaxy

#endif
