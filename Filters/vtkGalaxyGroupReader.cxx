#include "vtkGalaxyGroupReader.h"

#include "Filters/GroupData.h"
#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "Filters/ViewpointData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Processes.h"
#include "Readers/PropertyChecks.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkGalaxyGroupReader);

vtkGalaxyGroupReader::vtkGalaxyGroupReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkGalaxyGroupReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!galaxy::isFirstProcess())
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    galaxy::requirePositive(this->Magnification, "Magnification");
    galaxy::requirePositive(this->Separation, "Separation");
    galaxy::GroupDescription group = galaxy::readGroupDescription(this->FileName);
    group.magnification *= this->Magnification;
    group.separation *= this->Separation;
    galaxy::BuildOptions options;
    options.particleScale = this->ParticleScale;
    options.seed = galaxy::seedOf(this->RandomSeed);
    options.progress = galaxy::progressOf(this);
    const std::vector<galaxy::GroupPlace> places = galaxy::placesOf(group);
    galaxy::Particles particles = galaxy::buildGroup(group, places, options);
    vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
    if (particles.size() > 0)
    {
      const double distance = 1000 * places.front().galaxy.distance;
      galaxy::toFieldData(
        distance, galaxy::halfSizeOf(particles, distance), output->GetFieldData());
    }
    galaxy::toPolyData(std::move(particles), output);
    galaxy::toFieldData(places, group.separation, output->GetFieldData());
    // The frame is the first member's; with other distances between them the sky is not theirs.
    if (group.separation == 1 && !places.empty())
    {
      galaxy::setSkyPlace(places.front().galaxy, output);
    }
  });
}

void vtkGalaxyGroupReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Magnification: " << this->Magnification << "\n";
  os << indent << "Separation: " << this->Separation << "\n";
  os << indent << "ParticleScale: " << this->ParticleScale << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
