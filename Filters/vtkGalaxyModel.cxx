#include "vtkGalaxyModel.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/ModelReport.h"
#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "Filters/ViewpointData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/DataObjects.h"
#include "Readers/PropertyChecks.h"
#include "Readers/ReportErrors.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkGalaxyModel);

int vtkGalaxyModel::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkGalaxyModel::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // A reader that failed has said so.
  if (vtkPartitionedDataSetCollection::GetData(inputVector[0], 0)
        ->GetNumberOfPartitionedDataSets() == 0)
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    const galaxy::Galaxy input =
      galaxy::toGalaxy(vtkPartitionedDataSetCollection::GetData(inputVector[0], 0));
    galaxy::BuildOptions options;
    options.particleScale = this->ParticleScale;
    options.seed = galaxy::seedOf(this->RandomSeed);
    options.velocities = this->Velocities;
    options.viewPixel = this->ViewPixel;
    options.progress = galaxy::progressOf(this);
    galaxy::BuildReport report;
    galaxy::Particles particles = galaxy::buildGalaxy(input, options, &report);
    this->Report = galaxy::inWords(report);
    this->ReportJSON = galaxy::asJSON(report);
    const std::string shortened = galaxy::shortOnes(report);
    if (!shortened.empty())
    {
      vtkWarningMacro(
        << input.description.file << ": the pixels under " << shortened
        << " have less light than light_fraction asks for, and gave only that share "
           "of it; give a smaller light_fraction, a larger spheroid, or more particles");
    }
    const std::string unasked = galaxy::darkOnes(report, false);
    if (!unasked.empty())
    {
      vtkWarningMacro(<< input.description.file << ": no particles for " << unasked
                      << ", though its images have light; raise `particles` or ParticleScale");
    }
    const std::string dark = galaxy::darkOnes(report, true);
    if (!dark.empty())
    {
      vtkWarningMacro(
        << input.description.file << ": no particles for " << dark
        << ", for no seed lies on a lit pixel; check the galaxy's ra, dec (degrees) and distance, "
           "its inclination (edge-on, a flat disc covers no pixel), its images' coordinates and "
           "the layers' clip and threshold");
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
    galaxy::toPolyData(std::move(particles), output);
    galaxy::setSkyPlace(input.description, output);
    galaxy::toFieldData(galaxy::outlookOf(input), output->GetFieldData());
  });
}

void vtkGalaxyModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ParticleScale: " << this->ParticleScale << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "ViewPixel: " << this->ViewPixel << "\n";
  os << indent << "Velocities: " << this->Velocities << "\n";
  os << indent << "Report: " << this->Report << "\n";
}
