#include "vtkDustFilaments.h"

#include "Filters/SeedData.h"
#include "Readers/AlgorithmProgress.h"
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
    dust.noise = static_cast<galaxy::FractalKind>(this->Noise);
    dust.octaves = this->Octaves;
    dust.lacunarity = this->Lacunarity;
    dust.hurst = this->Hurst;
    dust.contrast = this->Contrast;
    dust.noiseScale = this->NoiseScale;
    dust.winding = this->Winding;
    dust.children = this->Children;
    dust.spread = this->Spread;
    component.dust = dust;
  };
  return galaxy::reportErrors(this, [&] {
    galaxy::seedsToParticles(vtkPolyData::GetData(inputVector[0], 0), this->RandomSeed,
      this->Velocities, change, galaxy::progressOf(this), vtkPolyData::GetData(outputVector, 0));
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
  os << indent << "Noise: " << this->Noise << "\n";
  os << indent << "Octaves: " << this->Octaves << "\n";
  os << indent << "Lacunarity: " << this->Lacunarity << "\n";
  os << indent << "Hurst: " << this->Hurst << "\n";
  os << indent << "Contrast: " << this->Contrast << "\n";
  os << indent << "NoiseScale: " << this->NoiseScale << "\n";
  os << indent << "Winding: " << this->Winding << "\n";
  os << indent << "Children: " << this->Children << "\n";
  os << indent << "Spread: " << this->Spread << "\n";
  os << indent << "RandomSeed: " << this->RandomSeed << "\n";
  os << indent << "Velocities: " << this->Velocities << "\n";
}
