#ifndef galaxy_SeedData_h
#define galaxy_SeedData_h

#include "Filters/Model/Seeds.h"
#include "Readers/Formats/Galaxy.h"

#include <functional>
#include <string>

class vtkPolyData;

/// Seeds as vtkPolyData and back: points on the disc as the Earth sees them (SightLines), point
/// arrays `Radius`, `Azimuth`, `Intensity`, `Light`, `Color` and `Draw`; the galaxy's rings and
/// description, the component's name and what was drawn as field arrays.
namespace galaxy
{
/// The seeds of one component, with all that turning them into particles needs.
struct SeedData
{
  Galaxy galaxy; ///< without images
  std::string component;
  Seeds seeds;

  /// The component's description, for a filter to change.
  ComponentDescription& description();
};

void toPolyData(SeedData&& data, vtkPolyData* output);
/// The inverse. Throws Error where an array is missing.
SeedData toSeeds(vtkPolyData* input);

/// The particles of the seeds in `input`, after `change` has adapted the component's description;
/// with the array Velocity where asked.
void seedsToParticles(vtkPolyData* input, int randomSeed, bool velocities,
  const std::function<void(ComponentDescription&)>& change, const Progress& progress,
  vtkPolyData* output);
}

#endif
