#include "GroupData.h"

#include "Filters/Model/ScaleBar.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cstdio>

namespace galaxy
{
void toFieldData(const std::vector<GroupPlace>& places, double separation, vtkFieldData* fields)
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkDoubleArray> positions, distances, magnifications, separations;
  names->SetName("MemberName");
  positions->SetName("MemberPosition");
  positions->SetNumberOfComponents(3);
  distances->SetName("MemberDistance");
  magnifications->SetName("MemberMagnification");
  separations->SetName("GroupSeparation");
  for (const GroupPlace& place : places)
  {
    const Vec3& centre = place.placement.centre;
    names->InsertNextValue(place.galaxy.name);
    positions->InsertNextTuple3(centre.x, centre.y, centre.z);
    distances->InsertNextValue(1000 * place.galaxy.distance);
    magnifications->InsertNextValue(place.placement.magnification);
  }
  separations->InsertNextValue(separation);
  fields->AddArray(names);
  for (vtkDoubleArray* array :
    { positions.Get(), distances.Get(), magnifications.Get(), separations.Get() })
  {
    fields->AddArray(array);
  }
}

GroupLabels groupLabels(vtkFieldData* fields)
{
  GroupLabels labels;
  auto names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("MemberName"));
  vtkDataArray* positions = fields->GetArray("MemberPosition");
  vtkDataArray* distances = fields->GetArray("MemberDistance");
  vtkDataArray* magnifications = fields->GetArray("MemberMagnification");
  vtkDataArray* separation = fields->GetArray("GroupSeparation");
  const vtkIdType count = names ? names->GetNumberOfValues() : 0;
  for (vtkDataArray* array : { positions, distances, magnifications })
  {
    if (!array || array->GetNumberOfTuples() < count)
    {
      return labels;
    }
  }
  labels.isToScale = !separation || separation->GetComponent(0, 0) == 1;
  for (vtkIdType i = 0; i < count; ++i)
  {
    GroupLabels::Label label;
    label.text = names->GetValue(i) + ", " + lengthText(distances->GetComponent(i, 0));
    const double magnification = magnifications->GetComponent(i, 0);
    if (magnification != 1)
    {
      char text[40];
      std::snprintf(text, sizeof(text), " (×%.3g)", magnification);
      label.text += text;
      labels.isToScale = false;
    }
    for (int c = 0; c < 3; ++c)
    {
      label.position[c] = positions->GetComponent(i, c);
    }
    labels.members.push_back(label);
  }
  return labels;
}
}
