#ifndef galaxy_PointArrays_h
#define galaxy_PointArrays_h

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

/// The point arrays of particles, as the engine and the writers see them: `SmoothingLength`,
/// `Intensity`, `Emission`, `Absorption` and `Velocity` as float32, `Color` as three bytes,
/// `Component` as one.
namespace galaxy
{
/// The same particles with these arrays, and the points, in these types: a Color of floats is 0 to
/// 1, of 16 bits 0 to 65535, of other integers 0 to 255; of one or two channels grey, a fourth is
/// left out. Throws where a value has no place in its type, or an array another shape.
vtkSmartPointer<vtkPolyData> withPlainArrays(vtkPolyData* particles);

/// Null where there is none.
template <typename Array>
Array* plainArray(vtkPolyData* particles, const char* name)
{
  return Array::SafeDownCast(particles->GetPointData()->GetAbstractArray(name));
}

/// What plain particles are drawn and written by, into members named for it.
template <typename View>
void fillView(vtkPolyData* particles, View& view)
{
  const auto floats = [&](const char* name) {
    auto array = plainArray<vtkFloatArray>(particles, name);
    return array ? array->GetPointer(0) : nullptr;
  };
  const auto bytes = [&](const char* name) {
    auto array = plainArray<vtkUnsignedCharArray>(particles, name);
    return array ? array->GetPointer(0) : nullptr;
  };
  const auto channels = [&](const char* name) {
    auto array = plainArray<vtkFloatArray>(particles, name);
    return array ? array->GetNumberOfComponents() : 3;
  };
  view.position = vtkFloatArray::SafeDownCast(particles->GetPoints()->GetData())->GetPointer(0);
  view.smoothingLength = floats("SmoothingLength");
  view.intensity = floats("Intensity");
  view.color = bytes("Color");
  view.component = bytes("Component");
  view.emission = floats("Emission");
  view.absorption = floats("Absorption");
  view.emissionChannels = channels("Emission");
  view.absorptionChannels = channels("Absorption");
}
} // namespace galaxy

#endif
