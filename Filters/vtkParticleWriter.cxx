#include "vtkParticleWriter.h"

#include "Filters/Export/ExportParticles.h"
#include "Filters/ParticleData.h"
#include "Filters/PointArrays.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/Error.h"
#include "Readers/ReportErrors.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkParticleWriter);

namespace
{
using galaxy::PointArrays;

/// Bytes of colours given as 0 to 1, as VTK understands colours of floats.
const unsigned char* bytesOfColors(vtkDataArray* colors, PointArrays::Converted& converted)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfComponents(3);
  bytes->SetNumberOfTuples(colors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double value = std::clamp(colors->GetComponent(i, channel), 0.0, 1.0);
      bytes->SetTypedComponent(i, channel, static_cast<unsigned char>(255 * value + 0.5));
    }
  }
  converted.push_back(bytes);
  return bytes->GetPointer(0);
}

/// Throws where a value is no index that fits into a byte.
std::size_t largestComponent(vtkDataArray* component)
{
  if (vtkUnsignedCharArray::SafeDownCast(component))
  {
    return static_cast<std::size_t>(component->GetRange()[1]); // every byte is one
  }
  double largest = 0;
  for (vtkIdType i = 0; i < component->GetNumberOfTuples(); ++i)
  {
    const double value = component->GetComponent(i, 0);
    if (!(value >= 0 && value <= 255 && value == std::floor(value)))
    {
      std::ostringstream text;
      text << "point array Component must have whole numbers 0 to 255, not " << value
           << " at point " << i;
      throw std::runtime_error(text.str());
    }
    largest = std::max(largest, value);
  }
  return static_cast<std::size_t>(largest);
}

/// The view's components: the polydata's table, or without one as many as the particles tell of.
void viewComponents(vtkPolyData* particles, galaxy::ParticleTable& table)
{
  table.components = galaxy::toComponents(particles->GetFieldData());
  vtkDataArray* component = particles->GetPointData()->GetArray("Component");
  if (!component)
  {
    return;
  }
  const std::size_t largest = largestComponent(component);
  if (!particles->GetFieldData()->HasArray("ComponentName"))
  {
    table.components.resize(largest + 1);
  }
}

galaxy::ParticleTable viewTable(vtkPolyData* particles, PointArrays::Converted& converted)
{
  galaxy::ParticleTable table;
  table.size = static_cast<std::size_t>(particles->GetNumberOfPoints());
  if (table.size == 0)
  {
    return table;
  }
  std::string problem;
  PointArrays arrays(particles, converted, problem);
  arrays.fill(table);
  table.velocity = arrays.find<vtkFloatArray>("Velocity", 3, 3);
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
  vtkDataArray* color = particles->GetPointData()->GetArray("Color");
  if (color && (color->GetDataType() == VTK_FLOAT || color->GetDataType() == VTK_DOUBLE))
  {
    table.color = bytesOfColors(color, converted);
  }
  viewComponents(particles, table);
  return table;
}

galaxy::ParticleFormat formatOf(int format, const std::string& file)
{
  switch (format)
  {
    case vtkParticleWriter::GADGET1:
      return galaxy::ParticleFormat::Gadget1;
    case vtkParticleWriter::GADGET2:
      return galaxy::ParticleFormat::Gadget2;
    case vtkParticleWriter::GADGET_HDF5:
      return galaxy::ParticleFormat::GadgetHDF5;
    case vtkParticleWriter::CSV:
      return galaxy::ParticleFormat::CSV;
    default:
      return galaxy::formatOfFile(file);
  }
}
}

vtkParticleWriter::~vtkParticleWriter()
{
  this->SetFileName(nullptr);
}

int vtkParticleWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkParticleWriter::WriteData()
{
  const bool written = galaxy::reportErrors(this, [this] {
    vtkPolyData* particles = vtkPolyData::SafeDownCast(this->GetInput());
    if (!this->FileName || !*this->FileName)
    {
      throw std::runtime_error("FileName must be set");
    }
    if (this->IsFirstProcess(particles))
    {
      this->Export(particles);
    }
  });
  this->SetErrorCode(written ? vtkErrorCode::NoError : vtkErrorCode::CannotOpenFileError);
}

bool vtkParticleWriter::IsFirstProcess(vtkPolyData* particles)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!processes || processes->GetNumberOfProcesses() == 1)
  {
    return true;
  }
  // A writer asks for the whole input, so that every process may well have all of it: then their
  // particles agree in number and bounds.
  double own[7], least[7], most[7];
  own[0] = static_cast<double>(particles->GetNumberOfPoints());
  particles->GetBounds(own + 1);
  processes->Reduce(own, least, 7, vtkCommunicator::MIN_OP, 0);
  processes->Reduce(own, most, 7, vtkCommunicator::MAX_OP, 0);
  const bool first = processes->GetLocalProcessId() == 0;
  if (first && !std::equal(least, least + 7, most))
  {
    vtkWarningMacro(<< this->FileName << " gets the " << particles->GetNumberOfPoints()
                    << " particles of the first process only; save from one process to get all");
  }
  return first;
}

void vtkParticleWriter::Export(vtkPolyData* particles)
{
  galaxy::ExportOptions options;
  options.format = formatOf(this->Format, this->FileName);
  options.progress = galaxy::progressOf(this);
  PointArrays::Converted converted;
  if (!galaxy::exportParticles(viewTable(particles, converted), this->FileName, options))
  {
    throw galaxy::Error(
      this->FileName, "", "not written, for the writer was stopped; save it again");
  }
}

void vtkParticleWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
  os << indent << "Format: " << this->Format << "\n";
}
