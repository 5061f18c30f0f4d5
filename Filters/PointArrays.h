#ifndef galaxy_PointArrays_h
#define galaxy_PointArrays_h

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <vector>

namespace galaxy
{
/// Pointers into the point arrays of particles, converting those of another type.
class PointArrays
{
public:
  using Converted = std::vector<vtkSmartPointer<vtkDataArray>>;

  /// The copies go to `converted`, what is wrong to `problem`.
  PointArrays(vtkPolyData* particles, Converted& converted, std::string& problem)
    : particles(particles)
    , converted(converted)
    , problem(problem)
  {
  }

  /// Null where the array is absent; says a problem where it has the wrong shape.
  template <typename Array>
  auto find(const char* name, int minChannels, int maxChannels)
    -> decltype(Array::New()->GetPointer(0))
  {
    vtkDataArray* array = this->particles->GetPointData()->GetArray(name);
    return array && this->fits(array, minChannels, maxChannels) ? this->as<Array>(array) : nullptr;
  }

  template <typename Array>
  auto as(vtkDataArray* array) -> decltype(Array::New()->GetPointer(0))
  {
    Array* typed = Array::SafeDownCast(array);
    if (!typed)
    {
      auto copy = vtkSmartPointer<Array>::New();
      copy->DeepCopy(array);
      this->converted.push_back(copy);
      typed = copy;
    }
    return typed->GetPointer(0);
  }

  /// What particles are drawn and written by, into members named for it.
  template <typename View>
  void fill(View& view)
  {
    view.position = this->as<vtkFloatArray>(this->particles->GetPoints()->GetData());
    view.smoothingLength = this->find<vtkFloatArray>("SmoothingLength", 1, 1);
    view.intensity = this->find<vtkFloatArray>("Intensity", 1, 1);
    view.color = this->find<vtkUnsignedCharArray>("Color", 3, 3);
    view.component = this->find<vtkUnsignedCharArray>("Component", 1, 1);
    view.emission = this->find<vtkFloatArray>("Emission", 1, 3);
    view.absorption = this->find<vtkFloatArray>("Absorption", 1, 3);
    view.emissionChannels = view.emission ? this->channels("Emission") : 3;
    view.absorptionChannels = view.absorption ? this->channels("Absorption") : 3;
  }

private:
  int channels(const char* name) const
  {
    return this->particles->GetPointData()->GetArray(name)->GetNumberOfComponents();
  }

  bool fits(vtkDataArray* array, int minChannels, int maxChannels)
  {
    const std::string name = std::string("point array ") + array->GetName();
    const int channels = array->GetNumberOfComponents();
    const vtkIdType points = this->particles->GetNumberOfPoints();
    if (channels < minChannels || channels > maxChannels || channels == 2)
    {
      this->problem = name + " must have " + std::to_string(maxChannels) + " components, not " +
        std::to_string(channels);
      return false;
    }
    if (array->GetNumberOfTuples() != points)
    {
      this->problem = name + " must have " + std::to_string(points) + " values, one a point, not " +
        std::to_string(array->GetNumberOfTuples());
      return false;
    }
    return true;
  }

  vtkPolyData* particles;
  Converted& converted;
  std::string& problem;
};
} // namespace galaxy

#endif
