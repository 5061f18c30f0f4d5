#include "vtkDiskSeeds.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/SeedData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/DataObjects.h"
#include "Readers/Formats/Error.h"
#include "Readers/Processes.h"
#include "Readers/PropertyChecks.h"
#include "Readers/ReportErrors.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDiskSeeds);

namespace
{
std::string firstDisk(const galaxy::GalaxyDescription& description)
{
  for (const galaxy::ComponentDescription& component : description.components)
  {
    if (component.type == galaxy::ComponentType::Disk)
    {
      return component.name;
    }
  }
  throw galaxy::Error(
    description.file, "component", "the galaxy has no disc to seed; add a component of type Disk");
}
}

int vtkDiskSeeds::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkDiskSeeds::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!galaxy::isFirstProcess())
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    galaxy::SeedData data;
    data.galaxy = galaxy::toGalaxy(vtkPartitionedDataSetCollection::GetData(inputVector[0], 0));
    data.component = this->Component.empty() ? firstDisk(data.galaxy.description) : this->Component;
    if (this->Sampling != FROM_DESCRIPTION)
    {
      data.description().sampling = static_cast<galaxy::SeedSampling>(this->Sampling);
    }
    galaxy::BuildOptions options;
    options.particleScale = this->ParticleScale;
    options.seed = galaxy::seedOf(this->RandomSeed);
    options.viewPixel = this->ViewPixel;
    options.progress = galaxy::progressOf(this);
    data.seeds = galaxy::buildSeeds(data.galaxy, data.component, options);
    galaxy::toPolyData(std::move(data), vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkDiskSeeds::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Sampling: " << this->Sampling << "\n";
  os << indent << "ParticleScale: " << this->ParticleScale << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "ViewPixel: " << this->ViewPixel << "\n";
}
