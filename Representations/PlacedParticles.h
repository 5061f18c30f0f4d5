#ifndef galaxy_PlacedParticles_h
#define galaxy_PlacedParticles_h

#include "vtkSmartPointer.h"

class vtkMatrix4x4;
class vtkPolyData;

namespace galaxy
{
/// The particles where a display puts them (its Position, Orientation, Scale ...). Scaled by s, h
/// is multiplied by s, luminosities and cross-sections by s squared, so that nothing becomes
/// brighter or denser. They themselves where they stay; throws where the axes are not scaled alike.
vtkSmartPointer<vtkPolyData> placed(vtkPolyData* particles, vtkMatrix4x4* place);

/// Bounds, or none (uninitialized), where they are put.
void placeBounds(vtkMatrix4x4* place, double bounds[6]);
} // namespace galaxy

#endif
