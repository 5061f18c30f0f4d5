#ifndef galaxy_AdoptBuffer_h
#define galaxy_AdoptBuffer_h

#include "Filters/Model/Particles.h"

#include "vtkSmartPointer.h"

namespace galaxy
{
/// A VTK array that takes over a buffer's memory.
template <typename Array, typename T>
vtkSmartPointer<Array> adopt(Buffer<T>& buffer, const char* name, int channels)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(channels);
  const auto size = static_cast<vtkIdType>(buffer.size());
  array->SetArray(buffer.release(), size, 0, Array::VTK_DATA_ARRAY_FREE);
  return array;
}
}

#endif
