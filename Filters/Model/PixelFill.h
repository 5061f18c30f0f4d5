#ifndef galaxy_PixelFill_h
#define galaxy_PixelFill_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/LightMap.h"
#include "Filters/Model/ParticleWriter.h"
#include "Filters/Model/Random.h"
#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/RingTable.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace galaxy
{
/// The vertical structure of a component's layer.
struct VerticalLayer
{
  LayerLaw law = LayerLaw::Gaussian;
  std::function<double(double r)> scaleHeight; ///< kpc
};

/// Writes one particle of this weight for each of these pixels, seen on it from Earth, at a height
/// over the disc drawn from the layer: the particle stands on the ring's normal through the point
/// of the disc that is seen beside the pixel by just as much as the height shifts it. Of the law
/// only what lies below normalFocalHeight is used, as for the children of seeds. Where the disc
/// shows several sheets, one is chosen by their shares. Velocities, where they are written, are the
/// ring's and normal deviates of `dispersion` (km/s) along every axis.
void fillPixels(const std::vector<std::uint32_t>& pixels, const LightMap& map,
  const TiltedDisk& disk, const DiskInverse& inverse, const VerticalLayer& layer, double dispersion,
  const RandomKey& key, float weight, const ParticleWriter& writer);
} // namespace galaxy

#endif
