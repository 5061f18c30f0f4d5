#include "vtkSmoothingLength.h"

#include "Filters/AdoptBuffer.h"
#include "Filters/Model/SmoothingLength.h"
#include "Filters/PointArrays.h"
#include "Readers/AlgorithmProgress.h"
#include "Readers/ReportErrors.h"

#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <stdexcept>
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
  PointArrays::Converted converted;

  double share(std::size_t count) const { return double(count) / double(this->size); }
};

Points view(vtkPolyData* input, bool byLight)
{
  Points points;
  std::string problem;
  PointArrays arrays(input, points.converted, problem);
  points.size = static_cast<std::size_t>(input->GetNumberOfPoints());
  if (points.size == 0)
  {
    return points;
  }
  points.position = arrays.as<vtkFloatArray>(input->GetPoints()->GetData());
  points.component = arrays.find<vtkUnsignedCharArray>("Component", 1, 1);
  if (byLight)
  {
    points.intensity = arrays.find<vtkFloatArray>("Intensity", 1, 1);
    if (problem.empty() && !points.intensity)
    {
      problem = "Model Brightness needs the point array Intensity; choose another Model";
    }
  }
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
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
} // namespace

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
    vtkPolyData* input = vtkPolyData::GetData(inputVector[0], 0);
    vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
    const Points points = view(input, this->Model == BRIGHTNESS);
    Buffer<float> h(points.size);
    setAll(points, smoothing, h.data(), progressOf(this));
    output->ShallowCopy(input);
    output->GetPointData()->AddArray(adopt<vtkFloatArray>(h, "SmoothingLength", 1));
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
