#include "vtkTiltedRingReader.h"

#include "Readers/DataObjects.h"
#include "Readers/Formats/RingPlane.h"
#include "Readers/Processes.h"
#include "Readers/PropertyChecks.h"
#include "Readers/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkTiltedRingReader);

namespace
{
constexpr double mostDistance = 1e6;     // Mpc, beyond all that is seen
constexpr double halfSky = 180.0 * 3600; // arcsec
}

vtkTiltedRingReader::vtkTiltedRingReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkTiltedRingReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!galaxy::isFirstProcess())
  {
    return 1;
  }
  return galaxy::reportErrors(this, [&] {
    // 0 says that there is none.
    galaxy::requireProperty(
      this->Distance >= 0 && this->Distance <= mostDistance, "Distance", "0 to 1e6 Mpc");
    galaxy::requireProperty(
      this->PixelScale >= 0 && this->PixelScale <= halfSky, "PixelScale", "0 to 648000 arcsec");
    galaxy::requireProperty(this->Disk >= 1, "Disk", "at least 1");
    galaxy::RingOptions options;
    options.disk = this->Disk;
    options.sides = static_cast<galaxy::RingSides>(this->Sides);
    options.distance = this->Distance;
    options.pixelScale = this->PixelScale;
    options.layerLaw = static_cast<galaxy::LayerLaw>(this->LayerLaw);
    options.galaxyName = this->GalaxyName;
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
  os << indent << "GalaxyName: " << this->GalaxyName << "\n";
  os << indent << "SpinSense: " << this->SpinSense << "\n";
}
