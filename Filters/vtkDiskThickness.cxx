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
    galaxy::ThicknessDescription thickness;
    thickness.model = static_cast<galaxy::ThicknessModel>(this->Model);
    thickness.law = static_cast<galaxy::LayerLaw>(this->Law);
    thickness.children = this->Children;
    thickness.sigma = this->Sigma;
    thickness.scaleLength = this->ScaleLength;
    thickness.scaleHeight = this->ScaleHeight;
    thickness.fwhmCentre = this->FWHMCentre;
    thickness.fwhmEdge = this->FWHMEdge;
    thickness.edgeRadius = this->EdgeRadius;
    thickness.flareLength = this->FlareLength;
    thickness.referenceVelocity = this->ReferenceVelocity;
    thickness.gasDispersion = this->GasDispersion;
    component.thickness = thickness;
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
  os << indent << "Law: " << this->Law << "\n";
  os << indent << "Children: " << this->Children << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ScaleLength: " << this->ScaleLength << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "FWHMCentre: " << this->FWHMCentre << "\n";
  os << indent << "FWHMEdge: " << this->FWHMEdge << "\n";
  os << indent << "EdgeRadius: " << this->EdgeRadius << "\n";
  os << indent << "FlareLength: " << this->FlareLength << "\n";
  os << indent << "ReferenceVelocity: " << this->ReferenceVelocity << "\n";
  os << indent << "GasDispersion: " << this->GasDispersion << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
}
