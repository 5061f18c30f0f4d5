#include "vtkParticleWriter.h"

#include "Filters/AllParticles.h"
#include "Filters/Export/ExportParticles.h"
#include "Filters/ParticleData.h"
#include "Filters/PointArrays.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Formats/Error.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkParticleWriter);

namespace
{
/// What other programs want of every particle, and what those get that lack it.
struct Wanted
{
  const char* array;
  const char* madeUp;
};
constexpr Wanted wanted[] = {
  { "Velocity", "velocities of 0 km/s" },
  { "SmoothingLength", "smoothing lengths of 0 kpc" },
  { "Intensity", "masses of 1" },
  { "Color", "white as color" },
  { "Component", "component 0" },
};
constexpr int numberWanted = sizeof(wanted) / sizeof(Wanted);

/// How many of this process's particles lack each of them, and how many there are.
std::array<double, numberWanted + 1> lackingOf(const std::vector<galaxy::PointSet>& sets)
{
  std::array<double, numberWanted + 1> lacking{};
  for (const galaxy::PointSet& set : sets)
  {
    const auto points = static_cast<double>(set.data->GetNumberOfPoints());
    for (int k = 0; k < numberWanted; ++k)
    {
      lacking[k] += set.data->GetPointData()->GetArray(wanted[k].array) ? 0 : points;
    }
    lacking[numberWanted] += points;
  }
  return lacking;
}

/// What has to be made up.
struct MadeUp
{
  std::string text;
  bool isOfOthers = false; ///< more than velocities, which a model has where they are asked for
};

/// Says it to the first process; to be called by all of them.
MadeUp madeUp(vtkDataObject* input)
{
  std::array<double, numberWanted + 1> own{}, all{};
  try
  {
    own = lackingOf(galaxy::pointSetsOf(input));
  }
  catch (const std::runtime_error&)
  {
    // gatherParticles() says it, on all processes.
  }
  all = own;
  if (galaxy::numberOfProcesses() > 1)
  {
    vtkMultiProcessController::GetGlobalController()->Reduce(
      own.data(), all.data(), numberWanted + 1, vtkCommunicator::SUM_OP, 0);
  }
  MadeUp result;
  std::ostringstream text;
  for (int k = 0; k < numberWanted; ++k)
  {
    if (all[k] > 0)
    {
      result.isOfOthers |= k > 0;
      text << (text.tellp() > 0 ? ", " : "") << wanted[k].madeUp << " (no point array "
           << wanted[k].array;
      if (all[k] < all[numberWanted])
      {
        text << " for " << static_cast<long long>(all[k]) << " particles";
      }
      text << ")";
    }
  }
  result.text = text.str();
  return result;
}

/// The table's components: the particles' own, or without a table as many as they tell of.
std::vector<galaxy::ComponentInfo> componentsOf(vtkPolyData* particles)
{
  std::vector<galaxy::ComponentInfo> components = galaxy::toComponents(particles->GetFieldData());
  auto numbers = galaxy::plainArray<vtkUnsignedCharArray>(particles, "Component");
  if (numbers && !particles->GetFieldData()->HasArray("ComponentName"))
  {
    components.resize(static_cast<std::size_t>(numbers->GetRange()[1]) + 1);
  }
  return components;
}

galaxy::ParticleTable viewTable(vtkPolyData* particles)
{
  galaxy::ParticleTable table;
  table.size = static_cast<std::size_t>(particles->GetNumberOfPoints());
  if (table.size == 0)
  {
    return table;
  }
  galaxy::fillView(particles, table);
  auto velocity = galaxy::plainArray<vtkFloatArray>(particles, "Velocity");
  table.velocity = velocity ? velocity->GetPointer(0) : nullptr;
  table.components = componentsOf(particles);
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

vtkTypeBool vtkParticleWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    galaxy::requestOwnPiece(inputVector[0]->GetInformationObject(0));
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkParticleWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

void vtkParticleWriter::WriteData()
{
  this->Report.clear();
  const bool written = galaxy::reportErrors(this, [this] {
    if (!this->FileName || !*this->FileName)
    {
      throw std::runtime_error("FileName must be set");
    }
    const MadeUp made = madeUp(this->GetInput());
    const galaxy::AllParticles all =
      galaxy::gatherParticles(this->GetInput(), galaxy::ParticleUse::Points);
    if (galaxy::isFirstProcess())
    {
      this->Export(all.particles, made.text);
      if (made.isOfOthers)
      {
        vtkWarningMacro(<< this->FileName << ": made up " << made.text
                        << "; give the particles what other programs are to read");
      }
    }
  });
  this->SetErrorCode(written ? vtkErrorCode::NoError : vtkErrorCode::CannotOpenFileError);
}

void vtkParticleWriter::Export(vtkPolyData* particles, const std::string& madeUp)
{
  galaxy::ExportOptions options;
  options.format = formatOf(this->Format, this->FileName);
  options.progress = galaxy::progressOf(this);
  galaxy::ParticleTable table = viewTable(particles);
  table.madeUp = madeUp;
  if (!galaxy::exportParticles(table, this->FileName, options))
  {
    throw galaxy::Error(
      this->FileName, "", "not written, for the writer was stopped; save it again");
  }
  this->Report = std::to_string(table.size) + " particles written" +
    (madeUp.empty() ? "" : "; made up: " + madeUp);
}

void vtkParticleWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "Report: " << this->Report << "\n";
}
