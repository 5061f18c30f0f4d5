#include "vtkDiskThickness.h"

#include "Filters/SeedData.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDiskThickness);

int vtkDiskThickness::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto change = [this](galaxy::ComponentDescription& component) {
    component.hasDust = false;
    if (this->Model == FROM_DESCRIPTION)
    {
      return;
    }
    galaxy::ThicknessDescription& thickness = component.thickness;
    thickness.model = static_cast<galaxy::ThicknessModel>(this->Model);
    thickness.children = this->Children;
    thickness.sigma = this->Sigma;
    thickness.scaleLength = this->ScaleLength;
    thickness.scaleHeight = this->ScaleHeight;
  };
  return galaxy::reportErrors(this, [&] {
    galaxy::seedsToParticles(vtkPolyData::GetData(inputVector[0], 0), this->RandomSeed, change,
      vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkDiskThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Children: " << this->Children << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ScaleLength: " << this->ScaleLength << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
