#ifndef galaxy_Seeds_h
#define galaxy_Seeds_h

#include "Filters/Model/IntensityScale.h"
#include "Filters/Model/Particles.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
#include "Filters/Model/SkyImage.h"
#include "Readers/Formats/GalaxyDescription.h"

#include <vector>

namespace galaxy
{
/// Points in the plane of a disc before it has a thickness.
struct Seeds
{
  Buffer<float> radius;        ///< kpc
  Buffer<float> azimuth;       ///< radians from the receding axis, in the sense of rotation
  Buffer<float> intensity;     ///< I_p
  Buffer<float> light;         ///< kpc^2: intensity times the seed's share of area
  Buffer<std::uint8_t> color;  ///< 3 N: RGB_s
  Buffer<std::uint32_t> index; ///< the draw that a seed came from, before culling
  std::size_t drawn = 0;       ///< before culling
  double innerRadius = 0;      ///< kpc, of the range that was sampled
  double outerRadius = 0;      ///< kpc

  std::size_t size() const { return this->radius.size(); }
  /// The share of a draw of the disc's own area, kpc^2.
  double areaPerDraw() const;
};

/// One image of a component and how it counts.
struct SeedLayer
{
  const SkyImage* image;
  IntensityScale scale;
  double threshold; ///< lower intensities count as none
  double weight;
  Color color;
};

/// Where a component on this disc ends, kpc: its own outer radius, the last ring at the latest
/// (BeyondLastRing::HoldLast lets a component that names its radius go beyond).
double outerRadiusOf(const ComponentDescription& component, const TiltedDisk& disk);

/// Draws `count` seeds uniformly over the disc's own plane (radius density proportional to r,
/// azimuth uniform) between the component's radii and culls the dark ones.
///
/// A seed of layers with intensities I_k and colours RGB_k has the colour sum_k weight_k I_k RGB_k:
/// its largest channel is the seed's intensity, the ratio its 8-bit colour. (An absorber's
/// intensity is sum_k weight_k I_k.) Its light is intensity J_sky / (N pdf), J_sky being the sky
/// area per dr dtheta (TiltedDisk::skyJacobian) and pdf the density of draws in (r, theta): this
/// importance weight makes the summed light of any region of the sky the image's integral over it,
/// in expectation and for any N, however the warp piles the seeds up. Where the disc folds over
/// itself on the sky, every sheet carries the image. With DiskProfile::Exponential the intensity is
/// exp(-r/scale_length) and the area the disc's own.
///
/// Throws Error (file, component) where the component's radii hold no part of the disc.
Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const std::vector<SeedLayer>& layers, const RandomKey& key, std::size_t count,
  const std::string& file);
} // namespace galaxy

#endif
