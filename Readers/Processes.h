#ifndef galaxy_Processes_h
#define galaxy_Processes_h

#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace galaxy
{
inline int numberOfProcesses()
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  return all ? all->GetNumberOfProcesses() : 1;
}

/// Whether this is the one of several MPI processes that reads and makes what must exist once,
/// whichever piece it is asked for.
inline bool isFirstProcess()
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  return !all || all->GetLocalProcessId() == 0;
}

/// Asks an input for what this process has of it. A writer would ask for the whole, which makes
/// each process do all the work again.
inline void requestOwnPiece(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), all ? all->GetLocalProcessId() : 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), numberOfProcesses());
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}
}

#endif
