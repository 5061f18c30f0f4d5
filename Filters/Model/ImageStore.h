#ifndef galaxy_ImageStore_h
#define galaxy_ImageStore_h

#include "Filters/Model/CombineImages.h"
#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/ImageReport.h"
#include "Filters/Model/LightMap.h"
#include "Filters/Model/OpticalDepth.h"
#include "Filters/Model/RingGeometry.h"
#include "Filters/Model/SkyImage.h"
#include "Readers/Formats/Galaxy.h"
#include "Readers/Formats/SkyFrame.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace galaxy
{
/// The images of a galaxy, each prepared when first asked for, and the light that components make
/// of them. Errors name the description file and the image or component.
class ImageStore
{
public:
  /// `radius`, kpc: where the components end.
  ImageStore(const Galaxy& input, const TiltedDisk& disk, double radius);

  /// Prepares the images of a component.
  void prepare(const ComponentDescription& component);
  /// A component's light, or its optical depth in V where that is calibrated, within `radius` kpc.
  /// `beyond` gets the flux of what its images show outside.
  LightMap lightOf(const ComponentDescription& component, double radius, double* beyond = nullptr);
  /// What became of the images whose light a component has been asked for.
  std::vector<ImageReport> reportOf(const ComponentDescription& component) const;
  /// The sharpest beam among a component's images, kpc.
  double beamOf(const ComponentDescription& component) const;

private:
  const SkyImage& prepared(const std::string& name);
  CleanImage combined(const ImageDescription& description);
  std::size_t indexOf(const std::string& name) const;
  SeedLayer layerOf(const ComponentDescription& component, const LayerDescription& layer);
  SeedLayer calibratedLayerOf(
    const ComponentDescription& component, const LayerDescription& layer, SeedLayer uncalibrated);
  DepthImage depthImageOf(const std::string& name) const;
  DiskInverse inverseOf(const ComponentDescription& component) const;
  LightMap::ChangeColor dereddeningOf(const ComponentDescription& component);

  const GalaxyDescription& galaxy;
  const std::vector<Image>& images;
  const TiltedDisk& disk;
  SkyFrame sky;
  double radius;
  std::map<std::string, std::unique_ptr<SkyImage>> skyImages;
  std::map<std::string, SkyLevel> skies; ///< of the images that were read
  std::map<const LayerDescription*, std::array<double, 2>> clips;
};

/// From a component's light map, or from its profile where it has no images, to what its particles
/// carry: the optical depth of intensity 1 for absorbers that are not calibrated otherwise, else 1.
/// (Of a profile, intensity and depth are across the disc, as FaceOn has it.)
double lightFactor(const ComponentDescription& component);
} // namespace galaxy

#endif
