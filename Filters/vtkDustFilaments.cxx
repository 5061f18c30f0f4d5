#include "vtkDustFilaments.h"

#include "Filters/SeedData.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDustFilaments);

int vtkDustFilaments::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto change = [this](galaxy::ComponentDescription& component) {
    component.role = galaxy::ComponentRole::Absorbs;
    component.hasDust = true;
    if (this->Model == FROM_DESCRIPTION)
    {
      return;
    }
    galaxy::DustDescription dust;
    dust.model = static_cast<galaxy::DustModel>(this->Model);
    dust.steps = this->Steps;
    dust.stepLength = this->StepLength;
    dust.velocityDispersion = this->VelocityDispersion;
    dust.verticalDispersion = this->VerticalDispersion;
    dust.scaleHeight = this->ScaleHeight;
    dust.dampingTime = this->DampingTime;
    component.dust = dust;
  };
  return galaxy::reportErrors(this, [&] {
    galaxy::seedsToParticles(vtkPolyData::GetData(inputVector[0], 0), this->RandomSeed, change,
      vtkPolyData::GetData(outputVector, 0));
  });
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
  os << indent << "DampingTime: " << this->DampingTime << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
