#ifndef galaxy_GalaxyBuilder_h
#define galaxy_GalaxyBuilder_h

#include "Filters/Model/Particles.h"
#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Galaxy.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace galaxy
{
struct BuildOptions
{
  double particleScale = 1; ///< factor on every component's `particles`
  std::uint64_t seed = 1;   ///< of the random numbers
  bool velocities = false;  ///< fill Particles::velocity
  /// Called from the calling thread with the fraction done; returning false aborts.
  std::function<bool(double)> progress;
};

struct ComponentReport
{
  std::string name;
  std::size_t seedsDrawn = 0; ///< 0 for spheroids
  std::size_t seedsKept = 0;
  std::size_t particles = 0;
  double smoothingLength = 0; ///< kpc
  double imageSeconds = 0;    ///< preparing the images that no earlier component had asked for
  double seedSeconds = 0;
  double thicknessSeconds = 0; ///< or filaments, or the spheroid
};

struct BuildReport
{
  std::vector<ComponentReport> components;
  bool aborted = false; ///< then there are no particles
};

/// The whole model, every component in the description's order. Emitters carry their luminosity
/// (intensity times kpc^2 of sky), absorbers their cross-section (optical depth times kpc^2); the
/// factors `size` and `brightness` go to the component table only. The particles are a function of
/// the input, the scale and the seed, whatever the number of threads.
/// Throws Error naming the description file and the component or image.
Particles buildGalaxy(
  const Galaxy& input, const BuildOptions& options = {}, BuildReport* report = nullptr);

/// The seeds of one disc component, as buildGalaxy draws them.
Seeds buildSeeds(
  const Galaxy& input, const std::string& componentName, const BuildOptions& options = {});

/// The particles that buildGalaxy makes of those seeds: thickness or filaments. The component table
/// has this one component.
Particles buildFromSeeds(const Galaxy& input, const std::string& componentName, const Seeds& seeds,
  const BuildOptions& options = {});
} // namespace galaxy

#endif
