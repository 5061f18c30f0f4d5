#ifndef galaxy_ParticleData_h
#define galaxy_ParticleData_h

#include "Filters/Model/Particles.h"
#include "Filters/Splatting/Render.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkFieldData;
class vtkPolyData;
class vtkSplatSettings;

/// Particles as vtkPolyData and back: point arrays `SmoothingLength`, `Intensity`, `Color`,
/// `Component`, optionally `Velocity`, `Emission`, `Absorption`; the component table as the field
/// arrays `ComponentName`, `ComponentAbsorbs`, `ComponentAbsorption`, `ComponentSize` and
/// `ComponentBrightness`.
namespace galaxy
{
/// Hands the particles over without copying them.
void toPolyData(Particles&& particles, vtkPolyData* output);

/// The component table; one unnamed component that emits where there is none.
std::vector<ComponentInfo> toComponents(vtkFieldData* fields);

/// Particles of a vtkPolyData as the engine draws them, with what had to be converted for it.
struct ParticleInput
{
  ParticleView view;
  std::vector<ComponentInfo> components;
  std::vector<bool> visible;
  std::vector<vtkSmartPointer<vtkDataArray>> converted; ///< arrays of other types, as the engine's
  std::string problem;                                  ///< why viewParticles failed
};

/// Sees the particles in place, with the settings applied to their component table. False, with
/// `problem` said, where an array is missing or does not fit; `input` must outlive the view.
bool viewParticles(vtkPolyData* particles, vtkSplatSettings& settings, ParticleInput& input);

/// Bounds of the particles with their kernels, kpc, with the settings' size factors; uninitialized
/// where there are none.
void boundsOfKernels(vtkPolyData* particles, vtkSplatSettings& settings, double bounds[6]);

/// The engine's options for the settings.
RenderOptions renderOptions(vtkSplatSettings& settings);

/// One line of text: particles drawn and culled, seconds by stage.
std::string describe(const RenderStatistics& statistics);
}

#endif
