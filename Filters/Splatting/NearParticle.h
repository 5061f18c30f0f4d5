#ifndef galaxy_NearParticle_h
#define galaxy_NearParticle_h

#include "Filters/Splatting/GaussianKernel.h"
#include "Filters/Splatting/Lens.h"

#include <cmath>

namespace galaxy
{
/// A particle that the eye is in, or almost: it is no disc on the image plane. Every pixel looks
/// along its own ray, which passes the centre at a distance b of its own, and sees the part of the
/// column that lies before the eye: of exp(-r^2/sigma^2), with (1 + erf(s/sigma))/2 where s is how
/// far along the ray the centre is. A cubic spline is drawn as the Gaussian of its variance. Where
/// it is soon to be one, it is drawn as that in part, see Lens.
struct NearParticle
{
  double x, y, z; ///< of the centre, from the eye to the right, up and forward, in sigma
  double sigma;   ///< kpc
  /// The circle: its share, its middle on the image plane (focal length 1), and 1 / sigma there.
  double share, u, v, perSigma;

  NearParticle(const Vec3& position, double smoothingLength, const Lens& lens);

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
  /// The same of the circle.
  double circleOffset2(double u, double v) const
  {
    const double du = (u - this->u) * this->perSigma, dv = (v - this->v) * this->perSigma;
    return du * du + dv * dv;
  }
  double along(double u, double v) const
  {
    return (this->x * u + this->y * v + this->z) / std::sqrt(1 + u * u + v * v);
  }

  /// Of its whole column, per sigma^2.
  double profile(double u, double v) const;
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
  /// than 3 sigma behind it, where the kernel ends; nor on the image plane its circle.
  bool misses(const NearParticle& particle) const;

private:
  bool raysMiss(const NearParticle& particle) const;
  bool missesCircle(const NearParticle& particle) const;

  double left = 0, bottom = 0, right = 0, top = 0; ///< on the image plane, focal length 1
  Vec3 middle;                                     ///< right, up and forward, of length 1
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
