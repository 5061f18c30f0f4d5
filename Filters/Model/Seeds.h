#ifndef galaxy_Seeds_h
#define galaxy_Seeds_h

#include "Filters/Model/LightMap.h"
#include "Filters/Model/Particles.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
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
  Buffer<float> light;         ///< kpc^2: the seed's share of the flux
  Buffer<std::uint8_t> color;  ///< 3 N: RGB_s
  Buffer<std::uint32_t> index; ///< the draw that a seed came from, before culling
  std::size_t drawn = 0;       ///< before culling
  double innerRadius = 0;      ///< kpc, of the range that was sampled
  double outerRadius = 0;      ///< kpc

  std::size_t size() const { return this->radius.size(); }
};

/// Some of a component's draws.
struct DrawRange
{
  std::size_t first = 0;
  std::size_t last = 0; ///< one beyond
  std::size_t size() const { return this->last - this->first; }
  bool holds(std::size_t draw) const { return draw >= this->first && draw < this->last; }
};

/// Where a component on this disc ends, kpc: its own outer radius, the last ring at the latest
/// (BeyondLastRing::HoldLast lets a component that names its radius go beyond).
double outerRadiusOf(const ComponentDescription& component, const TiltedDisk& disk);

/// Draws `count` seeds between the component's radii: in proportion to the light, or uniformly over
/// the warped surface (`sampling`), by the map of its layers or, without one, by its radial profile
/// exp(-r/scale_length), whose area is the disc's own. The seeds are a function of (key, count)
/// and the input, whatever the number of threads.
///
/// ImageDriven: see PixelDraws. Inside its pixel the k-th seed stands at the k-th point of a
/// two-dimensional golden-ratio sequence (Roberts 2018) from a random start. Where the disc folds
/// over itself on the sky a seed goes to one of the sheets at random, by their shares (DiskSheet).
/// SurfaceUniform: the density is uniform in the area of the warped surface (TiltedDisk::
/// areaElement); seeds on dark pixels are culled.
///
/// Light: every pixel's flux in equal parts among its seeds, to rounding. With NormalizeAt::None
/// (the paper's rule) nothing looks at how many fell on a pixel: a seed has its pixel's intensity
/// times what one draw covers on the sky in the mean (ImageDriven: the flux that it stands for in
/// the mean), so that only the total is right.
///
/// Throws Error (file, component) where the component's radii hold no part of the disc.
Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const LightMap* map, const RandomKey& key, std::size_t count, const std::string& file);

/// Those of the same seeds whose draws lie from `first` up to `last`: one process's part.
Seeds sampleSeeds(const TiltedDisk& disk, const ComponentDescription& component,
  const LightMap* map, const RandomKey& key, std::size_t count, const DrawRange& range,
  const std::string& file);
} // namespace galaxy

#endif
