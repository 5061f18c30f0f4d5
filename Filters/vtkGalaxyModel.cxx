#include "vtkGalaxyModel.h"

#include "Filters/Model/GalaxyBuilder.h"
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

#include <iomanip>
#include <sstream>

vtkStandardNewMacro(vtkGalaxyModel);

namespace
{
std::string inWords(const galaxy::BuildReport& report)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  for (const galaxy::ComponentReport& component : report.components)
  {
    text << component.name << ": " << component.particles
         << " particles of h = " << component.smoothingLength << " kpc";
    if (component.seedsDrawn > 0)
    {
      text << " from " << component.seedsKept << " of " << component.seedsDrawn << " seeds";
    }
    if (component.flux > 0)
    {
      text << "; " << std::setprecision(1) << 100 * component.light / component.flux
           << " % of its images' light lies on the disc" << std::setprecision(2);
    }
    if (component.dark.blank + component.dark.negative > 0)
    {
      text << "; of the pixels of its images " << component.dark.blank << " are blank and "
           << component.dark.negative << " negative";
    }
    if (component.bins > 1)
    {
      text << "; so few seeds that pixels were joined " << component.bins << " x "
           << component.bins;
    }
    text << "; " << component.seconds.total() << " s\n";
  }
  return text.str();
}

std::string asJSON(const galaxy::BuildReport& report)
{
  std::ostringstream text;
  text << std::setprecision(9) << "[";
  for (const galaxy::ComponentReport& component : report.components)
  {
    const galaxy::StageSeconds& seconds = component.seconds;
    text << (&component == &report.components.front() ? "" : ", ")
         << "{\"component\": " << std::quoted(component.name)
         << ", \"seeds_drawn\": " << component.seedsDrawn
         << ", \"seeds_kept\": " << component.seedsKept
         << ", \"particles\": " << component.particles << ", \"filled\": " << component.filled
         << ", \"blank_pixels\": " << component.dark.blank
         << ", \"negative_pixels\": " << component.dark.negative << ", \"bins\": " << component.bins
         << ", \"flux\": " << component.flux << ", \"light\": " << component.light
         << ", \"smoothing_length\": " << component.smoothingLength
         << ", \"seconds\": {\"images\": " << seconds.images << ", \"light\": " << seconds.light
         << ", \"seeds\": " << seconds.seeds << ", \"thickness\": " << seconds.thickness
         << ", \"photometry\": " << seconds.photometry << ", \"smoothing\": " << seconds.smoothing
         << "}}";
  }
  text << "]";
  return text.str();
}

/// The components without particles that have light, or whose every seed fell on darkness.
std::string darkOnes(const galaxy::BuildReport& report, bool haveSeeds)
{
  std::string names;
  for (const galaxy::ComponentReport& component : report.components)
  {
    const bool isMissed =
      haveSeeds ? component.seedsDrawn > 0 : component.seedsDrawn == 0 && component.flux > 0;
    if (isMissed && component.particles == 0)
    {
      names += (names.empty() ? "" : ", ") + component.name;
    }
  }
  return names;
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
    this->Report = inWords(report);
    this->ReportJSON = asJSON(report);
    const std::string unasked = darkOnes(report, false);
    if (!unasked.empty())
    {
      vtkWarningMacro(<< input.description.file << ": no particles for " << unasked
                      << ", though its images have light; raise `particles` or ParticleScale");
    }
    const std::string dark = darkOnes(report, true);
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
