#ifndef galaxy_ReportErrors_h
#define galaxy_ReportErrors_h

#include "Readers/Formats/Progress.h"

#include "vtkObject.h"

#include <cstdio>
#include <exception>
#include <new>

namespace galaxy
{
/// As an error of the object. What says so takes memory too, and nothing may be thrown into VTK.
inline void say(vtkObject* self, const char* what, const char* cure = "") noexcept
{
  try
  {
    vtkErrorWithObjectMacro(self, << what << cure);
  }
  catch (const std::exception&)
  {
    std::fputs(what, stderr);
    std::fputs("\n", stderr);
  }
}

/// Does the work of a VTK request: 1 where it succeeds, and where the user has aborted it, which
/// leaves no data; where it throws, the object reports why and the request fails with 0. `cure`
/// says what to do where memory runs out.
template <typename Work>
int reportErrors(
  vtkObject* self, const Work& work, const char* cure = "use a smaller ParticleScale") noexcept
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
    say(self, "not enough memory; ", cure);
  }
  catch (const std::exception& error)
  {
    say(self, error.what());
  }
  return 0;
}
}

#endif
