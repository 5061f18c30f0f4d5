#ifndef galaxy_GalaxyBuilder_h
#define galaxy_GalaxyBuilder_h

#include "Filters/Model/BuildOptions.h"
#include "Filters/Model/DrawnLayer.h"
#include "Filters/Model/ImageReport.h"
#include "Filters/Model/Particles.h"
#include "Filters/Model/PixelCount.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Galaxy.h"

#include <cstdint>
#include <string>
#include <vector>

namespace galaxy
{
/// Seconds of the stages of a component, in their order.
struct StageSeconds
{
  double images = 0;     ///< preparing those that no earlier component had asked for
  double light = 0;      ///< the map of what the component should look like
  double seeds = 0;      ///< sampling
  double thickness = 0;  ///< children, filaments or the spheroid
  double photometry = 0; ///< normalisation to the pixels' fluxes
  double smoothing = 0;  ///< smoothing lengths

  double total() const
  {
    return this->images + this->light + this->seeds + this->thickness + this->photometry +
      this->smoothing;
  }
};

struct ComponentReport
{
  std::string name;
  std::size_t seedsDrawn = 0; ///< 0 for spheroids
  std::size_t seedsKept = 0;
  std::size_t particles = 0;
  std::size_t filled = 0;          ///< of them, those added for pixels that no other fell on
  PixelCount dark;                 ///< of its images, whole, as read
  std::vector<ImageReport> images; ///< in the order of its layers
  int bins = 1;               ///< pixels of the images along a side of those that are kept exactly
  double flux = 0;            ///< of its images, whole, less what spheroids take, kpc^2
  double light = 0;           ///< that the particles show to the Earth; the rest lies off the disc
  double asked = 0;           ///< of a spheroid that takes its light: what it was to take, kpc^2
  double end = 0;             ///< of a spheroid, kpc along its first axis
  double beyond = 0;          ///< the share of its profile's light that lies there and is left out
  double smoothingLength = 0; ///< kpc, mean
  std::vector<LayerHeight> layer; ///< how thick a disk is drawn, by radius
  StageSeconds seconds;
};

struct BuildReport
{
  std::vector<ComponentReport> components; ///< in the description's order
};

/// The whole model. Emitters carry their luminosity
/// (intensity times kpc^2 of sky), absorbers their cross-section (optical depth times kpc^2); the
/// factors `size` and `brightness` go to the component table only. The particles are a function of
/// the input, the scale and the seed, whatever the number of threads. They stand component by
/// component in the description's order, but for spheroids that take their light from a disk's
/// pixels, which stand before it.
///
/// Seen from Earth, at the galaxy's distance D, the particles of a disk with images are their sum:
/// with NormalizeAt::Child the light on each pixel, L (D/(D - Z))^2 summed over the particles that
/// are seen on it, is its flux to rounding. A lit pixel on the disc that no particle falls on gets
/// one of its own. Where there are fewer seeds than lit pixels, pixels are first joined 2 x 2 until
/// there are not.
///
/// Rings and images know of parallel sight lines only. Disks of a galaxy with images, and spheroids
/// that take their light from those, are therefore built along these and, when finished, moved to
/// those from Earth (moveToSightLines): in parallel projection they are off their images by Z/D of
/// the place, and the light by twice that. All else is what the description says, in kpc.
///
/// Throws Error naming the description file and the component or image.
Particles buildGalaxy(
  const Galaxy& input, const BuildOptions& options = {}, BuildReport* report = nullptr);

/// The seeds of one disc component, as buildGalaxy draws them.
Seeds buildSeeds(
  const Galaxy& input, const std::string& componentName, const BuildOptions& options = {});

/// The particles that buildGalaxy makes of those seeds: thickness or filaments, which share the
/// seeds' light (NormalizeAt::Seed; there is no image to look at). The component table has this one
/// component.
Particles buildFromSeeds(const Galaxy& input, const std::string& componentName, const Seeds& seeds,
  const BuildOptions& options = {});
} // namespace galaxy

#endif
