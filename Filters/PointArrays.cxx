#include "PointArrays.h"

#include "Readers/Formats/AvailableMemory.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace galaxy
{
namespace
{
[[noreturn]] void fail(vtkDataArray* array, const std::string& what)
{
  throw std::runtime_error(std::string("point array ") + array->GetName() + " must have " + what);
}

[[noreturn]] void fail(vtkDataArray* array, const std::string& what, double seen, vtkIdType point)
{
  std::ostringstream text;
  text << what << ", not " << seen << " at point " << point;
  fail(array, text.str());
}

void requireChannels(vtkDataArray* array, bool fits, const std::string& wanted)
{
  if (!fits)
  {
    fail(array, wanted + " components, not " + std::to_string(array->GetNumberOfComponents()));
  }
}

/// VTK's arrays end the program where there is no memory for them.
void requireMemoryOfCopy(vtkDataArray* array, int bytesOfTuple)
{
  const char* name = array->GetName();
  requireMemory(double(bytesOfTuple) * double(array->GetNumberOfTuples()), "point array",
    name ? name : "", "a copy of it", "use a smaller ParticleScale or fewer points");
}

vtkSmartPointer<vtkFloatArray> asFloats(vtkDataArray* array)
{
  requireMemoryOfCopy(array, static_cast<int>(sizeof(float)) * array->GetNumberOfComponents());
  auto floats = vtkSmartPointer<vtkFloatArray>::New();
  floats->DeepCopy(array);
  return floats;
}

/// What a colour channel's largest value is, and what to do about others.
struct ColorScale
{
  double white = 255;
  bool isWhole = true;
  const char* range = "whole numbers 0 to 255 where it is of such integers; give it as unsigned "
                      "char (0 to 255), unsigned short (0 to 65535) or float (0 to 1)";

  explicit ColorScale(int type)
  {
    if (type == VTK_UNSIGNED_SHORT)
    {
      this->white = 65535;
    }
    else if (type == VTK_FLOAT || type == VTK_DOUBLE)
    {
      this->white = 1;
      this->isWhole = false;
      this->range = "values 0 to 1 where it is of floats; divide it by what white is, with "
                    "Calculator";
    }
  }

  /// Rounding may have put it just beyond an end.
  bool has(double value) const
  {
    const double slack = this->isWhole ? 0 : 1e-5;
    return value >= -slack && value <= this->white + slack &&
      (!this->isWhole || value == std::floor(value));
  }
};

vtkSmartPointer<vtkUnsignedCharArray> asColors(vtkDataArray* array)
{
  const int channels = array->GetNumberOfComponents();
  requireChannels(array, channels >= 1 && channels <= 4, "1 to 4");
  const ColorScale scale(array->GetDataType());
  requireMemoryOfCopy(array, 3);
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(array->GetName());
  bytes->SetNumberOfComponents(3);
  bytes->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double value = array->GetComponent(i, channels < 3 ? 0 : c);
      if (!scale.has(value))
      {
        fail(array, scale.range, value, i);
      }
      const double share = std::min(std::max(value / scale.white, 0.0), 1.0);
      bytes->SetTypedComponent(i, c, static_cast<unsigned char>(255 * share + 0.5));
    }
  }
  return bytes;
}

vtkSmartPointer<vtkUnsignedCharArray> asComponents(vtkDataArray* array)
{
  requireMemoryOfCopy(array, 1);
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetName(array->GetName());
  bytes->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!(value >= 0 && value <= 255 && value == std::floor(value)))
    {
      fail(array, "whole numbers 0 to 255", value, i);
    }
    bytes->SetTypedComponent(i, 0, static_cast<unsigned char>(value));
  }
  return bytes;
}

/// The array where it is there, of one value a point.
vtkDataArray* find(vtkPolyData* particles, const char* name)
{
  vtkDataArray* array = particles->GetPointData()->GetArray(name);
  const vtkIdType points = particles->GetNumberOfPoints();
  if (array && array->GetNumberOfTuples() != points)
  {
    fail(array,
      std::to_string(points) + " values, one a point, not " +
        std::to_string(array->GetNumberOfTuples()));
  }
  return array;
}

void plainFloats(vtkPolyData* particles, const char* name, bool mayBeOne, bool mayBeThree)
{
  vtkDataArray* array = find(particles, name);
  if (!array)
  {
    return;
  }
  const int channels = array->GetNumberOfComponents();
  requireChannels(array, (mayBeOne && channels == 1) || (mayBeThree && channels == 3),
    mayBeOne && mayBeThree ? "1 or 3"
      : mayBeOne           ? "1"
                           : "3");
  if (!vtkFloatArray::SafeDownCast(array))
  {
    particles->GetPointData()->AddArray(asFloats(array));
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> withPlainArrays(vtkPolyData* particles)
{
  auto plain = vtkSmartPointer<vtkPolyData>::New();
  plain->ShallowCopy(particles);
  if (plain->GetNumberOfPoints() == 0)
  {
    return plain;
  }
  if (!vtkFloatArray::SafeDownCast(plain->GetPoints()->GetData()))
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(asFloats(plain->GetPoints()->GetData()));
    plain->SetPoints(points);
  }
  plainFloats(plain, "SmoothingLength", true, false);
  plainFloats(plain, "Intensity", true, false);
  plainFloats(plain, "Emission", true, true);
  plainFloats(plain, "Absorption", true, true);
  plainFloats(plain, "Velocity", false, true);
  vtkDataArray* color = find(plain, "Color");
  if (color && !(vtkUnsignedCharArray::SafeDownCast(color) && color->GetNumberOfComponents() == 3))
  {
    plain->GetPointData()->AddArray(asColors(color));
  }
  vtkDataArray* component = find(plain, "Component");
  if (component)
  {
    requireChannels(component, component->GetNumberOfComponents() == 1, "1");
    if (!vtkUnsignedCharArray::SafeDownCast(component))
    {
      plain->GetPointData()->AddArray(asComponents(component));
    }
  }
  return plain;
}
} // namespace galaxy
