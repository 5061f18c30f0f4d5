#include "Vertices.h"

#include "Filters/AdoptBuffer.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <limits>
#include <numeric>

namespace galaxy
{
namespace
{
template <typename Array, typename T>
void addVerticesOf(vtkPolyData* points)
{
  const auto size = static_cast<std::size_t>(points->GetNumberOfPoints());
  Buffer<T> offsets(size + 1), connectivity(size);
  std::iota(offsets.begin(), offsets.end(), T{ 0 });
  std::iota(connectivity.begin(), connectivity.end(), T{ 0 });
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(
    adopt<Array>(offsets, "Offsets", 1), adopt<Array>(connectivity, "Connectivity", 1));
  points->SetVerts(vertices);
}
}

void addVertices(vtkPolyData* points)
{
  if (points->GetNumberOfPoints() < std::numeric_limits<std::int32_t>::max())
  {
    addVerticesOf<vtkTypeInt32Array, vtkTypeInt32>(points);
    return;
  }
  addVerticesOf<vtkTypeInt64Array, vtkTypeInt64>(points);
}
}
