#include "ViewpointData.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <initializer_list>

namespace galaxy
{
namespace
{
void addTuple(vtkFieldData* fields, const char* name, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->InsertNextTuple(values.begin());
  fields->AddArray(array);
}

void addViewpoint(vtkFieldData* fields, const char* name, const Viewpoint& view)
{
  const Vec3 &p = view.position, &f = view.focalPoint, &u = view.viewUp;
  addTuple(fields, name, { p.x, p.y, p.z, f.x, f.y, f.z, u.x, u.y, u.z, view.viewAngle });
}

void addDirection(vtkFieldData* fields, const char* name, const Vec3& v)
{
  addTuple(fields, name, { v.x, v.y, v.z });
}
}

void toFieldData(const Outlook& outlook, vtkFieldData* fields)
{
  toFieldData(outlook.distance, outlook.halfSize, fields);
  addViewpoint(fields, "CameraFaceOn", faceOnView(outlook));
  addViewpoint(fields, "CameraEdgeOn", edgeOnView(outlook));
  addViewpoint(fields, "CameraMajorAxis", majorAxisView(outlook));
  addDirection(fields, "DiskNormal", outlook.normal);
  addDirection(fields, "MajorAxis", outlook.majorAxis);
  vtkNew<vtkStringArray> names;
  vtkNew<vtkDoubleArray> halfSizes;
  names->SetName("ImageName");
  halfSizes->SetName("ImageHalfSize");
  for (const ImageField& field : outlook.fields)
  {
    names->InsertNextValue(field.image);
    halfSizes->InsertNextValue(field.halfSize);
  }
  fields->AddArray(names);
  fields->AddArray(halfSizes);
}

void toFieldData(double distance, double halfSize, vtkFieldData* fields)
{
  addViewpoint(fields, "CameraEarth", earthView(distance, halfSize));
  addTuple(fields, "Distance", { distance });
  addTuple(fields, "FieldHalfSize", { halfSize });
}
}
