#include "vtkSplatImageWriter.h"

#include "Filters/Export/ExportPicture.h"
#include "Filters/PictureData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/Error.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <stdexcept>

vtkStandardNewMacro(vtkSplatImageWriter);

vtkSplatImageWriter::~vtkSplatImageWriter()
{
  this->SetFileName(nullptr);
}

vtkTypeBool vtkSplatImageWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    galaxy::requestOwnPiece(inputVector[0]->GetInformationObject(0));
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkSplatImageWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkSplatImageWriter::WriteData()
{
  // It has the whole picture.
  if (!galaxy::isFirstProcess())
  {
    return;
  }
  const bool written = galaxy::reportErrors(
    this, [this] { this->Export(); }, "close other data");
  this->SetErrorCode(written ? vtkErrorCode::NoError : vtkErrorCode::CannotOpenFileError);
}

void vtkSplatImageWriter::Export()
{
  if (!this->FileName || !*this->FileName)
  {
    throw std::runtime_error("FileName must be set");
  }
  galaxy::PictureExportOptions options;
  options.pixel = this->PixelType == HALF ? galaxy::ExrPixel::Half : galaxy::ExrPixel::Float;
  options.progress = galaxy::progressOf(this);
  const galaxy::PictureInput input =
    galaxy::viewPicture(vtkImageData::SafeDownCast(this->GetInput()));
  if (!galaxy::exportPicture(input.picture, this->FileName, options))
  {
    throw galaxy::Error(
      this->FileName, "", "not written, for the writer was stopped; save it again");
  }
}

void vtkSplatImageWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
  os << indent << "PixelType: " << (this->PixelType == HALF ? "Half" : "Float") << "\n";
}
