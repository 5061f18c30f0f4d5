#ifndef galaxy_CopyToArray_h
#define galaxy_CopyToArray_h

#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <vector>

namespace galaxy
{
/// A VTK array of these values. Throws std::bad_alloc where there is no memory for it: VTK's own
/// arrays end the program there, as Debian builds them.
template <typename Array, typename T>
vtkSmartPointer<Array> copyToArray(const std::vector<T>& values, const char* name, int channels)
{
  T* copy = static_cast<T*>(std::malloc(std::max<std::size_t>(1, values.size() * sizeof(T))));
  if (!copy)
  {
    throw std::bad_alloc();
  }
  std::copy(values.begin(), values.end(), copy);
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(channels);
  array->SetArray(copy, static_cast<vtkIdType>(values.size()), 0, Array::VTK_DATA_ARRAY_FREE);
  return array;
}
}

#endif
