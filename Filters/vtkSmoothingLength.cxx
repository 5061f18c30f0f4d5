#include "vtkSmoothingLength.h"

#include "Filters/AdoptBuffer.h"
#include "Filters/AllParticles.h"
#include "Filters/Model/SmoothingLength.h"
#include "Filters/PointArrays.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Vertices.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/Processes.h"
#include "Readers/ReportErrors.h"

#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <exception>
#include <stdexcept>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSmoothingLength);

namespace
{
using namespace galaxy;

struct Points
{
  std::size_t size = 0;
  const float* position = nullptr;
  const float* intensity = nullptr;         ///< null where there is none
  const unsigned char* component = nullptr; ///< null where there is none

  double share(std::size_t count) const { return double(count) / double(this->size); }
};

Points view(vtkPolyData* particles, bool byLight)
{
  Points points;
  points.size = static_cast<std::size_t>(particles->GetNumberOfPoints());
  if (points.size == 0)
  {
    return points;
  }
  ParticleView all;
  fillView(particles, all);
  points.position = all.position;
  points.component = all.component;
  points.intensity = byLight ? all.intensity : nullptr;
  if (byLight && !all.intensity)
  {
    throw std::runtime_error(
      "Model Brightness needs the point array Intensity; choose another Model");
  }
  return points;
}

/// The particles of one component, wherever they stand, copied together and back.
void setComponent(const Points& points, const std::vector<std::size_t>& members,
  const SmoothingDescription& smoothing, float* h, const Progress& progress)
{
  std::vector<float> position(3 * members.size()), light(members.size()), own(members.size());
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    std::copy_n(points.position + 3 * members[k], 3, &position[3 * k]);
    light[k] = points.intensity ? points.intensity[members[k]] : 0;
  }
  smoothingLengths(position.data(), light.data(), own.size(), smoothing, own.data(), progress);
  for (std::size_t k = 0; k < members.size(); ++k)
  {
    h[members[k]] = own[k];
  }
}

/// In place where the components stand one after the other, as those of a galaxy do.
void setSortedComponents(
  const Points& points, const SmoothingDescription& smoothing, float* h, const Progress& progress)
{
  const unsigned char* end = points.component + points.size;
  for (std::size_t first = 0, last = 0; first < points.size; first = last)
  {
    last =
      std::upper_bound(points.component + first, end, points.component[first]) - points.component;
    smoothingLengths(points.position + 3 * first,
      points.intensity ? points.intensity + first : nullptr, last - first, smoothing, h + first,
      partOf(progress, points.share(first), points.share(last)));
  }
}

void setAll(
  const Points& points, const SmoothingDescription& smoothing, float* h, const Progress& progress)
{
  if (!points.component)
  {
    smoothingLengths(points.position, points.intensity, points.size, smoothing, h, progress);
    return;
  }
  if (std::is_sorted(points.component, points.component + points.size))
  {
    setSortedComponents(points, smoothing, h, progress);
    return;
  }
  std::array<std::vector<std::size_t>, 256> members;
  for (std::size_t i = 0; i < points.size; ++i)
  {
    members[points.component[i]].push_back(i);
  }
  std::size_t done = 0;
  for (const std::vector<std::size_t>& component : members)
  {
    const double begin = points.share(done);
    done += component.size();
    setComponent(points, component, smoothing, h, partOf(progress, begin, points.share(done)));
  }
}
constexpr int lengthsTag = 0x6a1b;

/// Work of the first process that the others wait for: it fails for all of them where it throws.
template <typename Work>
void onFirstProcess(const Work& work)
{
  std::exception_ptr failure;
  try
  {
    isFirstProcess() ? work() : void();
  }
  catch (...)
  {
    failure = std::current_exception();
  }
  int isDone = !failure;
  if (numberOfProcesses() > 1)
  {
    vtkMultiProcessController::GetGlobalController()->Broadcast(&isDone, 1, 0);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  if (!isDone)
  {
    throw Aborted("", "", "the first process says why");
  }
}

/// The first process has the lengths of all particles; each gets those of its own.
Buffer<float> ownShare(Buffer<float>&& all, const std::vector<vtkIdType>& first, vtkIdType own)
{
  if (numberOfProcesses() == 1)
  {
    return std::move(all);
  }
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  std::vector<vtkIdType> counts(static_cast<std::size_t>(numberOfProcesses()));
  processes->Gather(&own, counts.data(), 1, 0);
  Buffer<float> share(static_cast<std::size_t>(own));
  if (!isFirstProcess())
  {
    processes->Receive(share.data(), own, 0, lengthsTag);
    return share;
  }
  for (std::size_t to = 1; to < counts.size(); ++to)
  {
    processes->Send(all.data() + first[to], counts[to], static_cast<int>(to), lengthsTag);
  }
  std::copy_n(all.data(), own, share.data());
  return share;
}

/// The output is the input with these lengths, one after the other in its sets of points.
void addLengths(Buffer<float>&& h, vtkDataObject* output)
{
  std::size_t at = 0;
  for (const PointSet& set : pointSetsOf(output))
  {
    Buffer<float> own(static_cast<std::size_t>(set.data->GetNumberOfPoints()));
    std::copy_n(h.data() + at, own.size(), own.data());
    at += own.size();
    set.data->GetPointData()->AddArray(adopt<vtkFloatArray>(own, "SmoothingLength", 1));
    auto points = vtkPolyData::SafeDownCast(set.data);
    if (points && points->GetNumberOfCells() == 0)
    {
      addVertices(points);
    }
  }
}
} // namespace

int vtkSmoothingLength::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

int vtkSmoothingLength::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  SmoothingDescription smoothing;
  smoothing.model = static_cast<SmoothingModel>(this->Model);
  smoothing.factor = this->Factor;
  smoothing.neighbours = this->Neighbours;
  smoothing.length = this->Length;
  smoothing.exponent = this->Exponent;
  smoothing.minimum = this->Minimum;
  if (this->Maximum != 0)
  {
    smoothing.maximum = this->Maximum;
  }
  return reportErrors(this, [&] {
    vtkDataObject* input = vtkDataObject::GetData(inputVector[0], 0);
    vtkDataObject* output = vtkDataObject::GetData(outputVector, 0);
    const AllParticles all = gatherParticles(input, ParticleUse::Points);
    Buffer<float> h;
    onFirstProcess([&] {
      const Points points = view(all.particles, this->Model == BRIGHTNESS);
      h.resize(points.size);
      setAll(points, smoothing, h.data(), progressOf(this));
    });
    output->ShallowCopy(input);
    addLengths(
      ownShare(std::move(h), all.first, input->GetNumberOfElements(vtkDataObject::POINT)), output);
  });
}

void vtkSmoothingLength::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->Model << "\n";
  os << indent << "Factor: " << this->Factor << "\n";
  os << indent << "Neighbours: " << this->Neighbours << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "Exponent: " << this->Exponent << "\n";
  os << indent << "Minimum: " << this->Minimum << "\n";
  os << indent << "Maximum: " << this->Maximum << "\n";
}
