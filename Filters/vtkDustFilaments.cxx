#include "vtkDustFilaments.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/ParticleData.h"
#include "Filters/SeedData.h"
#include "Readers/Formats/Error.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDustFilaments);

int vtkDustFilaments::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    galaxy::SeedData data = galaxy::toSeeds(vtkPolyData::GetData(inputVector[0], 0));
    galaxy::ComponentDescription& component = data.description();
    component.role = galaxy::ComponentRole::Absorbs;
    component.hasDust = true;
    if (this->Model != FROM_DESCRIPTION)
    {
      galaxy::DustDescription& dust = component.dust;
      dust.model = static_cast<galaxy::DustModel>(this->Model);
      dust.steps = this->Steps;
      dust.stepLength = this->StepLength;
      dust.velocityDispersion = this->VelocityDispersion;
      dust.verticalDispersion = this->VerticalDispersion;
      dust.scaleHeight = this->ScaleHeight;
    }
    galaxy::BuildOptions options;
    options.seed = static_cast<std::uint64_t>(this->RandomSeed);
    galaxy::toPolyData(galaxy::buildFromSeeds(data.galaxy, data.component, data.seeds, options),
      vtkPolyData::GetData(outputVector, 0));
  }
  catch (const galaxy::Error& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkDustFilaments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Steps: " << this->Steps << "\n";
  os << indent << "StepLength: " << this->StepLength << "\n";
  os << indent << "VelocityDispersion: " << this->VelocityDispersion << "\n";
  os << indent << "VerticalDispersion: " << this->VerticalDispersion << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
