#include "ViewpointData.h"

#include "Readers/DataObjects.h"

#include "vtkFieldData.h"

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
  for (const ImageField& field : outlook.fields)
  {
    addViewpoint(fields, ("CameraEarth:" + field.image).c_str(), field.view);
  }
}

void toFieldData(double distance, double halfSize, vtkFieldData* fields)
{
  addViewpoint(fields, "CameraEarth", earthView(distance, halfSize));
  setFieldNumbers(fields, "FieldHalfSize", { halfSize });
}
}
