#include "vtkSpheroidSource.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/Placement.h"
#include "Filters/ParticleData.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkSpheroidSource);

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
  component.smoothingLength = this->SmoothingLength;
  std::copy_n(this->Color, 3, component.color.begin());
  std::copy_n(this->Sigma, 3, component.spheroid.sigma.begin());
  component.spheroid.tilted = false;
  component.spheroid.centralBrightness = this->CentralBrightness;

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
  os << indent << "CentralBrightness: " << this->CentralBrightness << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
