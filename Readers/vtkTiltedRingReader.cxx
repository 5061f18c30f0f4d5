#include "vtkTiltedRingReader.h"

#include "Readers/DataObjects.h"
#include "Readers/Formats/RingPlane.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkTiltedRingReader);

vtkTiltedRingReader::vtkTiltedRingReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkTiltedRingReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return galaxy::reportErrors(this, [&] {
    galaxy::RingOptions options;
    options.disk = this->Disk;
    options.sides = static_cast<galaxy::RingSides>(this->Sides);
    options.distance = this->Distance;
    options.pixelScale = this->PixelScale;
    options.layerLaw = static_cast<galaxy::LayerLaw>(this->LayerLaw);
    const galaxy::RingTable table = galaxy::readRingTable(this->FileName, options);
    const double unit = this->Distance > 0 ? galaxy::kpcPerArcsec(this->Distance) : 1;
    const auto sense = static_cast<galaxy::SpinSense>(this->SpinSense);
    galaxy::toPolyData(
      table, unit, galaxy::spinOf(table.code, sense), vtkPolyData::GetData(outputVector, 0));
  });
}

void vtkTiltedRingReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "PixelScale: " << this->PixelScale << "\n";
  os << indent << "Disk: " << this->Disk << "\n";
  os << indent << "Sides: " << this->Sides << "\n";
  os << indent << "LayerLaw: " << this->LayerLaw << "\n";
  os << indent << "SpinSense: " << this->SpinSense << "\n";
}
