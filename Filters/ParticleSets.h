#ifndef galaxy_ParticleSets_h
#define galaxy_ParticleSets_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkPolyData;

/// Particles from whatever has points: one data set or the many of a composite one.
namespace galaxy
{
enum class ParticleUse
{
  Drawn, ///< need SmoothingLength, and Intensity, Emission or Absorption
  Points ///< need nothing but their points
};

/// A data set that has points, with what a composite one calls it.
struct PointSet
{
  vtkDataSet* data;
  std::string name;
};

/// All with points, in order. Throws where the data are of a kind that has none, as a table.
std::vector<PointSet> pointSetsOf(vtkDataObject* input);

/// Particles as one set, their arrays as PointArrays.h says. Of several sets only the arrays that
/// particles are known by are kept; where one lacks Intensity, Color, Component or Velocity, its
/// particles get 1, white, the first component and 0; components with equal entries in the sets'
/// tables are one. Where some have Emission or Absorption, the others get them from what they have.
/// Throws where sets do not have what their use needs.
vtkSmartPointer<vtkPolyData> particlesOf(vtkDataObject* input, ParticleUse use);
} // namespace galaxy

#endif
