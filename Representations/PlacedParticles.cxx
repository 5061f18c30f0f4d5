#include "PlacedParticles.h"

#include "Filters/AdoptBuffer.h"
#include "Filters/ParticleData.h"

#include "vtkBoundingBox.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace galaxy
{
namespace
{
template <typename T>
void place(const vtkMatrix4x4& matrix, const T* from, T* to)
{
  const double p[3] = { from[0], from[1], from[2] };
  for (int row = 0; row < 3; ++row)
  {
    const double* m = matrix.Element[row];
    to[row] = static_cast<T>(m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3]);
  }
}

/// By which lengths grow, in whatever direction.
double scaleOf(const vtkMatrix4x4& matrix)
{
  double squares[3], products = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto product = [&matrix](int a, int b) {
      double sum = 0;
      for (int row = 0; row < 3; ++row)
      {
        sum += matrix.Element[row][a] * matrix.Element[row][b];
      }
      return sum;
    };
    squares[i] = product(i, i);
    products = std::max(products, std::abs(product(i, (i + 1) % 3)));
  }
  const double most = *std::max_element(squares, squares + 3);
  const double least = *std::min_element(squares, squares + 3);
  if (!(least > 0) || most - least > 1e-6 * most || products > 1e-6 * most)
  {
    throw std::runtime_error("Scale must be the same along all axes, and not 0, for particles are "
                             "round; stretch where they lie with the filter Transform");
  }
  return std::sqrt(most);
}

void placePoints(const vtkMatrix4x4& matrix, vtkPolyData* particles)
{
  auto old = vtkFloatArray::SafeDownCast(particles->GetPoints()->GetData());
  const auto size = static_cast<std::int64_t>(particles->GetNumberOfPoints());
  Buffer<float> places(3 * static_cast<std::size_t>(size));
  const float* from = old->GetPointer(0);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < size; ++i)
  {
    place(matrix, from + 3 * i, places.data() + 3 * i);
  }
  vtkNew<vtkPoints> points;
  points->SetData(adopt<vtkFloatArray>(places, "Points", 3));
  particles->SetPoints(points);
}

/// The labels of a group's members stay where the members are.
void placeMembers(const vtkMatrix4x4& matrix, double scale, vtkFieldData* fields)
{
  auto old = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray("MemberPosition"));
  auto separation = vtkDoubleArray::SafeDownCast(fields->GetAbstractArray("GroupSeparation"));
  if (old && old->GetNumberOfComponents() == 3)
  {
    vtkNew<vtkDoubleArray> positions;
    positions->DeepCopy(old);
    for (vtkIdType i = 0; i < positions->GetNumberOfTuples(); ++i)
    {
      place(matrix, old->GetPointer(3 * i), positions->GetPointer(3 * i));
    }
    fields->AddArray(positions);
  }
  if (separation && separation->GetNumberOfValues() == 1)
  {
    vtkNew<vtkDoubleArray> scaled;
    scaled->SetName(separation->GetName());
    scaled->InsertNextValue(scale * separation->GetValue(0));
    fields->AddArray(scaled);
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> placed(vtkPolyData* particles, vtkMatrix4x4* matrix)
{
  if (!particles || particles->GetNumberOfPoints() == 0 || matrix->IsIdentity())
  {
    return particles;
  }
  const double scale = scaleOf(*matrix);
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->ShallowCopy(particles);
  placePoints(*matrix, moved);
  placeMembers(*matrix, scale, moved->GetFieldData());
  std::vector<ComponentInfo> components = toComponents(moved->GetFieldData());
  for (ComponentInfo& component : components)
  {
    component.size *= scale;
    component.brightness *= scale * scale;
  }
  toFieldData(components, moved->GetFieldData());
  return moved;
}

void placeBounds(vtkMatrix4x4* matrix, double bounds[6])
{
  if (!vtkMath::AreBoundsInitialized(bounds) || matrix->IsIdentity())
  {
    return;
  }
  vtkBoundingBox box;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = bounds[2 * axis + (corner >> axis & 1)];
    }
    place(*matrix, point, point);
    box.AddPoint(point);
  }
  box.GetBounds(bounds);
}
} // namespace galaxy
