#include "vtkFITSImageReader.h"

#include "Readers/AlgorithmProgress.h"
#include "Readers/DataObjects.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/ReportErrors.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(vtkFITSImageReader);

vtkFITSImageReader::vtkFITSImageReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkFITSImageReader::~vtkFITSImageReader() = default;

void vtkFITSImageReader::AddMaskValue(double value)
{
  this->MaskValues.push_back(value);
  this->Modified();
}

void vtkFITSImageReader::RemoveAllMaskValues()
{
  if (!this->MaskValues.empty())
  {
    this->MaskValues.clear();
    this->Modified();
  }
}

galaxy::FitsSelection vtkFITSImageReader::Selection() const
{
  galaxy::FitsSelection selection;
  selection.hdu = this->HDU;
  selection.extension = this->Extension;
  selection.plane = this->Plane;
  if (this->Planes[0] >= 0 || this->Planes[1] >= 0)
  {
    selection.planes = { this->Planes[0], this->Planes[1] };
  }
  if (this->VelocityRange[0] != 0 || this->VelocityRange[1] != 0)
  {
    selection.velocityRange = { this->VelocityRange[0], this->VelocityRange[1] };
  }
  selection.maskValues = this->MaskValues;
  return selection;
}

bool vtkFITSImageReader::ReadIfModified()
{
  if (this->ImageTime > this->GetMTime())
  {
    return this->Image != nullptr;
  }
  this->Image.reset();
  galaxy::reportErrors(this, [&] {
    this->Image = std::make_unique<galaxy::Image>(
      galaxy::readFitsImage(this->FileName, this->Selection(), galaxy::progressOf(this)));
  });
  // Not before: whoever aborts the reading modifies this object, and RequestData is not to read
  // again what RequestInformation was told to leave.
  this->ImageTime.Modified();
  return this->Image != nullptr;
}

int vtkFITSImageReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // A file that cannot be read has been reported; its image is empty.
  const bool read = this->ReadIfModified();
  const int extent[6] = { 0, read ? this->Image->width - 1 : -1, 0,
    read ? this->Image->height - 1 : -1, 0, read ? 0 : -1 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
  return 1;
}

int vtkFITSImageReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (!this->ReadIfModified())
  {
    return this->GetAbortExecute();
  }
  return galaxy::reportErrors(
    this, [&] { galaxy::toImageData(*this->Image, vtkImageData::GetData(outputVector, 0)); },
    "cut out or bin the image first");
}

void vtkFITSImageReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "HDU: " << this->HDU << "\n";
  os << indent << "Extension: " << this->Extension << "\n";
  os << indent << "Plane: " << this->Plane << "\n";
  os << indent << "Planes: " << this->Planes[0] << " " << this->Planes[1] << "\n";
  os << indent << "VelocityRange: " << this->VelocityRange[0] << " " << this->VelocityRange[1]
     << "\n";
  os << indent << "MaskValues:";
  for (const double value : this->MaskValues)
  {
    os << " " << value;
  }
  os << "\n";
}
