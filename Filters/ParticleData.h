#ifndef galaxy_ParticleData_h
#define galaxy_ParticleData_h

#include "Filters/Model/Particles.h"
#include "Filters/Splatting/Render.h"

#include <string>
#include <vector>

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

/// Adds the component table.
void toFieldData(const std::vector<ComponentInfo>& components, vtkFieldData* fields);

/// The component table; one unnamed component that emits where there is none.
std::vector<ComponentInfo> toComponents(vtkFieldData* fields);

/// Particles with plain arrays (PointArrays.h) as the engine draws them.
struct ParticleInput
{
  ParticleView view;
  std::vector<ComponentInfo> components;
  std::vector<bool> visible;
};

/// Sees the particles in place, with the settings applied to their component table; `input` and
/// they must outlive the view.
void viewParticles(vtkPolyData* particles, vtkSplatSettings& settings, ParticleInput& input);

/// Bounds of the particles with their kernels, kpc, with the settings' size factors, but for
/// particles at no finite place; uninitialized where there are none.
void boundsOfKernels(vtkPolyData* particles, vtkSplatSettings& settings, double bounds[6]);

/// The engine's options for the settings.
RenderOptions renderOptions(vtkSplatSettings& settings);

/// One line of text: particles drawn and culled, seconds by stage.
std::string describe(const RenderStatistics& statistics);
}

#endif
