#include "ViewpointData.h"

#include "Readers/DataObjects.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

namespace galaxy
{
namespace
{
void addViewpoint(vtkFieldData* fields, const char* name, const Viewpoint& view)
{
  const Vec3 &p = view.position, &f = view.focalPoint, &u = view.viewUp;
  setFieldNumbers(fields, name, { p.x, p.y, p.z, f.x, f.y, f.z, u.x, u.y, u.z, view.viewAngle });
}

void addDirection(vtkFieldData* fields, const char* name, const Vec3& v)
{
  setFieldNumbers(fields, name, { v.x, v.y, v.z });
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
  setFieldNumbers(fields, "Distance", { distance });
  setFieldNumbers(fields, "FieldHalfSize", { halfSize });
}
}
