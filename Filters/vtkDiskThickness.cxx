#include "vtkDiskThickness.h"

#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/ParticleData.h"
#include "Filters/SeedData.h"
#include "Readers/Formats/Error.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDiskThickness);

int vtkDiskThickness::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  try
  {
    galaxy::SeedData data = galaxy::toSeeds(vtkPolyData::GetData(inputVector[0], 0));
    galaxy::ComponentDescription& component = data.description();
    component.hasDust = false;
    if (this->Model != FROM_DESCRIPTION)
    {
      galaxy::ThicknessDescription& thickness = component.thickness;
      thickness.model = static_cast<galaxy::ThicknessModel>(this->Model);
      thickness.children = this->Children;
      thickness.sigma = this->Sigma;
      thickness.scaleLength = this->ScaleLength;
      thickness.scaleHeight = this->ScaleHeight;
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
