#ifndef galaxy_AlgorithmProgress_h
#define galaxy_AlgorithmProgress_h

#include "Readers/Formats/Progress.h"

#include "vtkAlgorithm.h"

namespace galaxy
{
/// Passes the progress of VTK-free work that begins on as that of the algorithm, which can be told
/// to abort it.
inline Progress progressOf(vtkAlgorithm* self)
{
  self->SetAbortExecute(0); // what was aborted before has ended
  return [self](double fraction) {
    self->UpdateProgress(fraction);
    return !self->GetAbortExecute();
  };
}
}

#endif
