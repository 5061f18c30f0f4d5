#ifndef galaxy_JoinParticles_h
#define galaxy_JoinParticles_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace galaxy
{
/// Sets of particles with plain arrays as one, as particlesOf() says: of none an empty one, of one
/// it itself. Field data but for the component table are the first one's. Throws where they have
/// more components than there are numbers for.
vtkSmartPointer<vtkPolyData> joinParticles(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);
} // namespace galaxy

#endif
