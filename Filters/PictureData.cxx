#include "PictureData.h"

#include "Readers/DataObjects.h"
#include "Readers/Formats/GalaxyDescription.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace galaxy
{
namespace
{
void setNumbers(vtkDataObject* object, const char* name, std::initializer_list<double> values)
{
  setFieldNumbers(object->GetFieldData(), name, values);
}

void setVector(vtkDataObject* object, const char* name, const Vec3& v)
{
  setNumbers(object, name, { v.x, v.y, v.z });
}

/// A field array of one row of `size` numbers, or null.
vtkDataArray* numbers(vtkDataObject* object, const char* name, int size)
{
  vtkDataArray* array = object->GetFieldData()->GetArray(name);
  const bool fits =
    array && array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == size;
  return fits ? array : nullptr;
}

double number(vtkDataObject* object, const char* name, double fallback)
{
  vtkDataArray* array = numbers(object, name, 1);
  return array ? array->GetComponent(0, 0) : fallback;
}

Vec3 vector(vtkDataObject* object, const char* name, const Vec3& fallback)
{
  vtkDataArray* v = numbers(object, name, 3);
  return v ? Vec3{ v->GetComponent(0, 0), v->GetComponent(0, 1), v->GetComponent(0, 2) } : fallback;
}

std::string text(vtkDataObject* object, const char* name, const std::string& fallback)
{
  auto array = vtkStringArray::SafeDownCast(object->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? array->GetValue(0) : fallback;
}

std::optional<SkyPlace> skyPlaceOf(vtkDataObject* object)
{
  vtkDataArray* centre = numbers(object, "SkyCentre", 2);
  const double distance = number(object, "SkyDistance", 0);
  if (!centre || !(distance > 0))
  {
    return std::nullopt;
  }
  return SkyPlace{ text(object, "GalaxyName", ""),
    { centre->GetComponent(0, 0), centre->GetComponent(0, 1) }, distance };
}

std::optional<PictureCamera> cameraOf(vtkDataObject* object)
{
  if (!numbers(object, "CameraPosition", 3))
  {
    return std::nullopt;
  }
  PictureCamera camera;
  camera.projection = text(object, "Projection", camera.projection);
  camera.position = vector(object, "CameraPosition", camera.position);
  camera.focalPoint = vector(object, "CameraFocalPoint", camera.focalPoint);
  camera.viewUp = vector(object, "CameraViewUp", camera.viewUp);
  camera.parallel = number(object, "CameraParallelProjection", 0) != 0;
  camera.parallelScale = number(object, "CameraParallelScale", camera.parallelScale);
  camera.viewAngle = number(object, "CameraViewAngle", camera.viewAngle);
  camera.domeAngle = number(object, "DomeAngle", camera.domeAngle);
  return camera;
}

const float* channels(vtkImageData* image, const char* name, PictureInput& input)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 3)
  {
    throw std::runtime_error(std::string("the image must have a point array ") + name +
      " of 3 components, as SplatImage makes it");
  }
  auto typed = vtkFloatArray::SafeDownCast(array);
  if (!typed)
  {
    auto copy = vtkSmartPointer<vtkFloatArray>::New();
    copy->DeepCopy(array);
    input.converted.push_back(copy);
    typed = copy;
  }
  return typed->GetPointer(0);
}
}

void setSkyPlace(const GalaxyDescription& galaxy, vtkDataObject* output)
{
  setFieldString(output, "GalaxyName", galaxy.name);
  setNumbers(output, "SkyCentre", { galaxy.centre.ra, galaxy.centre.dec });
  setNumbers(output, "SkyDistance", { 1000 * galaxy.distance });
}

std::string placesHint(const std::vector<vtkDataObject*>& together)
{
  std::vector<SkyPlace> places;
  std::string names;
  for (vtkDataObject* object : together)
  {
    const std::optional<SkyPlace> place = skyPlaceOf(object);
    const auto isSame = [&place](const SkyPlace& other) {
      return other.centre.ra == place->centre.ra && other.centre.dec == place->centre.dec &&
        other.distance == place->distance;
    };
    if (place && std::none_of(places.begin(), places.end(), isSame))
    {
      names += (names.empty() ? "" : ", ") + place->name;
      places.push_back(*place);
    }
  }
  return places.size() < 2 ? ""
                           : names +
      " stand in one place, each at the origin of its own frame; name their .galaxy files in a "
      ".galaxygroup and open that, and they stand where the sky has them";
}

void passSkyPlace(vtkDataObject* input, vtkDataObject* output)
{
  for (const char* name : { "GalaxyName", "SkyCentre", "SkyDistance" })
  {
    if (vtkAbstractArray* array = input->GetFieldData()->GetAbstractArray(name))
    {
      output->GetFieldData()->AddArray(array);
    }
  }
}

void setCamera(const PictureCamera& camera, vtkDataObject* output)
{
  setFieldString(output, "Projection", camera.projection);
  setVector(output, "CameraPosition", camera.position);
  setVector(output, "CameraFocalPoint", camera.focalPoint);
  setVector(output, "CameraViewUp", camera.viewUp);
  setNumbers(output, "CameraParallelProjection", { camera.parallel ? 1.0 : 0.0 });
  setNumbers(output, "CameraParallelScale", { camera.parallelScale });
  setNumbers(output, "CameraViewAngle", { camera.viewAngle });
  setNumbers(output, "DomeAngle", { camera.domeAngle });
}

PictureInput viewPicture(vtkImageData* image)
{
  PictureInput input;
  int size[3];
  image->GetDimensions(size);
  if (size[2] > 1)
  {
    throw std::runtime_error("the image must be one slice deep");
  }
  LightPicture& picture = input.picture;
  picture.width = size[0];
  picture.height = size[1];
  picture.radiance = channels(image, "Radiance", input);
  picture.transmittance = channels(image, "Transmittance", input);
  picture.camera = cameraOf(image);
  picture.sky = skyPlaceOf(image);
  return input;
}
}
