#include "vtkSplatImageWriter.h"

#include "Filters/Export/ExportPicture.h"
#include "Filters/PictureData.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/Error.h"
#include "Readers/ReportErrors.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"

#include <stdexcept>

vtkStandardNewMacro(vtkSplatImageWriter);

vtkSplatImageWriter::~vtkSplatImageWriter()
{
  this->SetFileName(nullptr);
}

int vtkSplatImageWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkSplatImageWriter::WriteData()
{
  // Every process has the whole picture.
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (processes && processes->GetLocalProcessId() != 0)
  {
    return;
  }
  const bool written = galaxy::reportErrors(this, [this] { this->Export(); });
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
