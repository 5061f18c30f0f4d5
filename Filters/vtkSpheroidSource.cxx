#include "vtkSpheroidSource.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/Placement.h"
#include "Filters/ParticleData.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkSpheroidSource);

namespace
{
galaxy::SpheroidDescription describe(vtkSpheroidSource& source)
{
  galaxy::SpheroidDescription spheroid;
  spheroid.profile = static_cast<galaxy::SpheroidProfile>(source.GetProfile());
  std::transform(source.GetSigma(), source.GetSigma() + 3, spheroid.sigma.begin(),
    [](double sigma) { return std::max(0.0, sigma); });
  spheroid.effectiveRadius = source.GetEffectiveRadius();
  spheroid.sersicIndex = source.GetSersicIndex();
  spheroid.scaleRadius = source.GetScaleRadius();
  spheroid.concentration = source.GetConcentration();
  std::copy_n(source.GetAxisRatios(), 2, spheroid.axisRatios.begin());
  if (source.GetTruncation() > 0)
  {
    spheroid.truncation = std::max(source.GetTruncation(), galaxy::leastTruncation(spheroid));
  }
  spheroid.tilted = false;
  spheroid.centralBrightness = source.GetCentralBrightness();
  if (source.GetLuminosity() > 0)
  {
    spheroid.luminosity = source.GetLuminosity();
  }
  spheroid.clusters = source.GetClusters();
  spheroid.clusterRadius = source.GetClusterRadius();
  return spheroid;
}
} // namespace

vtkSpheroidSource::vtkSpheroidSource()
{
  this->SetNumberOfInputPorts(0);
}

int vtkSpheroidSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  galaxy::ComponentDescription component;
  component.name = "spheroid";
  component.type = galaxy::ComponentType::Spheroid;
  component.particles = this->NumberOfParticles;
  if (this->SmoothingLength > 0)
  {
    component.smoothing.model = galaxy::SmoothingModel::Constant;
    component.smoothing.length = this->SmoothingLength;
  }
  std::copy_n(this->Color, 3, component.color.begin());
  component.spheroid = describe(*this);

  galaxy::Galaxy input;
  input.description.file = "Spheroid";
  input.description.distance = 1;
  input.description.components.push_back(component);
  input.rings.rings.resize(1);
  galaxy::BuildOptions options;
  options.seed = static_cast<std::uint64_t>(this->RandomSeed);
  return galaxy::reportErrors(this, [&] {
    galaxy::Particles particles = galaxy::buildGalaxy(input, options);
    galaxy::Placement placement;
    placement.centre = { this->Center[0], this->Center[1], this->Center[2] };
    galaxy::placeParticles(placement, particles);
    galaxy::toPolyData(std::move(particles), vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkSpheroidSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfParticles: " << this->NumberOfParticles << "\n";
  os << indent << "Profile: " << this->Profile << "\n";
  os << indent << "EffectiveRadius: " << this->EffectiveRadius << "\n";
  os << indent << "SersicIndex: " << this->SersicIndex << "\n";
  os << indent << "ScaleRadius: " << this->ScaleRadius << "\n";
  os << indent << "Concentration: " << this->Concentration << "\n";
  os << indent << "Truncation: " << this->Truncation << "\n";
  os << indent << "Clusters: " << this->Clusters << "\n";
  os << indent << "ClusterRadius: " << this->ClusterRadius << "\n";
  os << indent << "Luminosity: " << this->Luminosity << "\n";
  os << indent << "CentralBrightness: " << this->CentralBrightness << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
