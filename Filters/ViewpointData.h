#ifndef galaxy_ViewpointData_h
#define galaxy_ViewpointData_h

#include "Filters/Model/Viewpoints.h"

class vtkFieldData;

/// Where a galaxy is looked at from, as field arrays of one tuple each, whose values the ranges of
/// the data information hold: so they reach the client without the particles.
///
/// `CameraEarth`, `CameraFaceOn`, `CameraEdgeOn`, `CameraMajorAxis`: position, focal point, view up
/// (kpc) and view angle (degrees), ten numbers. `DiskNormal` and `MajorAxis` (directions),
/// `FieldHalfSize` (kpc that those views show to each side). A camera for each image, which shows
/// its field from Earth: `CameraEarth:` and the image's name.
namespace galaxy
{
void toFieldData(const Outlook& outlook, vtkFieldData* fields);

/// Of many galaxies about the first one's centre: `CameraEarth` and `FieldHalfSize`.
void toFieldData(double distance, double halfSize, vtkFieldData* fields);
}

#endif
