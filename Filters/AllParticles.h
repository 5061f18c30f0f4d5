#ifndef galaxy_AllParticles_h
#define galaxy_AllParticles_h

#include "Filters/ParticleSets.h"

#include "vtkType.h"

namespace galaxy
{
/// The particles of all MPI processes, on the first one.
struct AllParticles
{
  vtkSmartPointer<vtkPolyData> particles; ///< of none on the other processes
  std::vector<vtkIdType> first; ///< there, for each process: the number of its first particle
};

/// Brings them together as particlesOf() does, to be called by all processes. Those of a process
/// that has what the first one has, as where each has read the same file, are taken once. Throws on
/// all processes where it fails on one.
AllParticles gatherParticles(vtkDataObject* input, ParticleUse use);
} // namespace galaxy

#endif
