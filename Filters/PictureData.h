#ifndef galaxy_PictureData_h
#define galaxy_PictureData_h

#include "Filters/Export/LightPicture.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImageData;

/// What a picture and its particles say of themselves in their field data. Of the galaxy:
/// `GalaxyName`, `SkyCentre` (right ascension and declination of the frame's origin, ICRS degrees)
/// and `SkyDistance` (kpc). Of the camera: `CameraPosition` and ParaView's other names,
/// `Projection` and `DomeAngle`.
namespace galaxy
{
struct GalaxyDescription;

void setSkyPlace(const GalaxyDescription& galaxy, vtkDataObject* output);
/// What to do about particles of galaxies whose frames are not one: shown together they all stand
/// at the origin, not where the sky has them. Empty where there is nothing to do.
std::string placesHint(const std::vector<vtkDataObject*>& together);
/// From the particles to their picture.
void passSkyPlace(vtkDataObject* input, vtkDataObject* output);
void setCamera(const PictureCamera& camera, vtkDataObject* output);

/// A picture seen in place, with what had to be converted for it.
struct PictureInput
{
  LightPicture picture;
  std::vector<vtkSmartPointer<vtkDataArray>> converted;
};
/// Throws std::runtime_error where Radiance or Transmittance is missing or does not fit. `input`
/// must outlive the view.
PictureInput viewPicture(vtkImageData* input);
}

#endif
