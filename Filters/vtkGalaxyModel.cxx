#include "vtkGalaxyModel.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/ParticleData.h"
#include "Readers/DataObjects.h"
#include "Readers/ReportErrors.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <sstream>

vtkStandardNewMacro(vtkGalaxyModel);

namespace
{
std::string inWords(const galaxy::BuildReport& report)
{
  std::ostringstream text;
  for (const galaxy::ComponentReport& component : report.components)
  {
    text << component.name << ": " << component.seedsKept << " of " << component.seedsDrawn
         << " seeds, " << component.particles << " particles of h = " << component.smoothingLength
         << " kpc; images " << component.imageSeconds << " s, seeds " << component.seedSeconds
         << " s, particles " << component.thicknessSeconds << " s\n";
  }
  return text.str();
}
}

int vtkGalaxyModel::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkGalaxyModel::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return galaxy::reportErrors(this, [&] {
    const galaxy::Galaxy input =
      galaxy::toGalaxy(vtkPartitionedDataSetCollection::GetData(inputVector[0], 0));
    galaxy::BuildOptions options;
    options.particleScale = this->ParticleScale;
    options.seed = static_cast<std::uint64_t>(this->RandomSeed);
    options.velocities = this->Velocities;
    options.progress = [this](double fraction) {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    };
    galaxy::BuildReport report;
    galaxy::Particles particles = galaxy::buildGalaxy(input, options, &report);
    this->Report = inWords(report);
    if (!report.aborted)
    {
      galaxy::toPolyData(std::move(particles), vtkPolyData::GetData(outputVector, 0));
    }
  });
}

void vtkGalaxyModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParticleScale: " << this->ParticleScale << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "Velocities: " << this->Velocities << "\n";
  os << indent << "Report: " << this->Report << "\n";
}
