#include "vtkDiskThickness.h"

#include "Filters/SeedData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/WidthTable.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDiskThickness);

namespace
{
galaxy::ThicknessDescription describe(vtkDiskThickness& filter)
{
  galaxy::ThicknessDescription thickness;
  thickness.model = static_cast<galaxy::ThicknessModel>(filter.GetModel());
  thickness.law = static_cast<galaxy::LayerLaw>(filter.GetLaw());
  thickness.reading = static_cast<galaxy::TaperReading>(filter.GetReading());
  thickness.childLight = static_cast<galaxy::ChildLight>(filter.GetChildLight());
  thickness.children =
    filter.GetChildren() == 0 ? galaxy::usualChildren(thickness.model) : filter.GetChildren();
  thickness.maximumChildren = filter.GetMaximumChildren();
  thickness.sigma = filter.GetSigma();
  thickness.compression = filter.GetCompression();
  thickness.scaleLength = filter.GetScaleLength();
  thickness.scaleHeight = filter.GetScaleHeight();
  thickness.taperThickness = filter.GetTaperThickness();
  thickness.edgeRadius = filter.GetEdgeRadius();
  thickness.flareLength = filter.GetFlareLength();
  thickness.velocityScaling = static_cast<galaxy::VelocityScaling>(filter.GetVelocityScaling());
  thickness.referenceVelocity = filter.GetReferenceVelocity();
  thickness.velocityExponent = filter.GetVelocityExponent();
  thickness.gasDispersion = filter.GetGasDispersion();
  thickness.stellarSurfaceDensity = filter.GetStellarSurfaceDensity();
  thickness.gasSurfaceDensity = filter.GetGasSurfaceDensity();
  thickness.fwhmCentre = filter.GetFWHMCentre();
  thickness.fwhmEdge = filter.GetFWHMEdge();
  thickness.fwhmMaximum = filter.GetFWHMMaximum();
  const char* table = filter.GetProfileTable();
  if (table != nullptr && *table != '\0')
  {
    thickness.profileTable = galaxy::readWidthTable(table);
  }
  return thickness;
}
} // namespace

vtkDiskThickness::~vtkDiskThickness()
{
  this->SetProfileTable(nullptr);
}

int vtkDiskThickness::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto change = [this](galaxy::ComponentDescription& component) {
    component.hasDust = false;
    if (this->Model != FROM_DESCRIPTION)
    {
      const bool rotationKnown = component.thickness.rotationKnown;
      component.thickness = describe(*this);
      component.thickness.rotationKnown = rotationKnown;
    }
  };
  return galaxy::reportErrors(this, [&] {
    galaxy::seedsToParticles(vtkPolyData::GetData(inputVector[0], 0), this->RandomSeed,
      this->Velocities, change, galaxy::progressOf(this), vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkDiskThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Law: " << this->Law << "\n";
  os << indent << "Reading: " << this->Reading << "\n";
  os << indent << "ChildLight: " << this->ChildLight << "\n";
  os << indent << "Children: " << this->Children << "\n";
  os << indent << "MaximumChildren: " << this->MaximumChildren << "\n";
  os << indent << "Compression: " << this->Compression << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "ScaleLength: " << this->ScaleLength << "\n";
  os << indent << "ScaleHeight: " << this->ScaleHeight << "\n";
  os << indent << "TaperThickness: " << this->TaperThickness << "\n";
  os << indent << "FWHMCentre: " << this->FWHMCentre << "\n";
  os << indent << "FWHMEdge: " << this->FWHMEdge << "\n";
  os << indent << "EdgeRadius: " << this->EdgeRadius << "\n";
  os << indent << "FlareLength: " << this->FlareLength << "\n";
  os << indent << "FWHMMaximum: " << this->FWHMMaximum << "\n";
  os << indent << "VelocityScaling: " << this->VelocityScaling << "\n";
  os << indent << "ReferenceVelocity: " << this->ReferenceVelocity << "\n";
  os << indent << "VelocityExponent: " << this->VelocityExponent << "\n";
  os << indent << "ProfileTable: " << (this->ProfileTable ? this->ProfileTable : "none") << "\n";
  os << indent << "GasDispersion: " << this->GasDispersion << "\n";
  os << indent << "StellarSurfaceDensity: " << this->StellarSurfaceDensity << "\n";
  os << indent << "GasSurfaceDensity: " << this->GasSurfaceDensity << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "Velocities: " << this->Velocities << "\n";
}
