#ifndef galaxy_ReportErrors_h
#define galaxy_ReportErrors_h

#include "Readers/Formats/Progress.h"

#include "vtkObject.h"

#include <exception>
#include <new>

namespace galaxy
{
/// Does the work of a VTK request: 1 where it succeeds, and where the user has aborted it, which
/// leaves no data; where it throws, the object reports why and the request fails with 0.
template <typename Work>
int reportErrors(vtkObject* self, const Work& work)
{
  try
  {
    work();
    return 1;
  }
  catch (const Aborted&)
  {
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(self, << "not enough memory; use a smaller ParticleScale");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(self, << error.what());
  }
  return 0;
}
}

#endif
