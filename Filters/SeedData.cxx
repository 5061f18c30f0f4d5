#include "SeedData.h"

#include "Filters/AdoptBuffer.h"
#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/RingGeometry.h"
#include "Filters/Model/SightLines.h"
#include "Filters/ParticleData.h"
#include "Filters/PictureData.h"
#include "Filters/Vertices.h"
#include "Readers/DataObjects.h"
#include "Readers/Formats/Error.h"
#include "Readers/Processes.h"
#include "Readers/PropertyChecks.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <algorithm>

namespace galaxy
{
namespace
{
/// What was drawn, in the order of the field array `SeedSampling`.
enum Sampling
{
  Drawn,
  InnerRadius,
  OuterRadius,
  SamplingSize
};

Buffer<float> positionsOf(const SeedData& data)
{
  const GalaxyDescription& galaxy = data.galaxy.description;
  const TiltedDisk disk(
    data.galaxy.rings, galaxy.distance, galaxy.spin, galaxy.interpolation, galaxy.beyondLastRing);
  const bool isSeen = hasDiskWithImages(galaxy);
  const Seeds& seeds = data.seeds;
  const auto count = static_cast<std::int64_t>(seeds.size());
  Buffer<float> positions(3 * seeds.size());
  parallelFor<std::int64_t>(0, count, [&](std::int64_t i) {
    const Vec3 p = disk.position(seeds.radius[i], seeds.azimuth[i]);
    const double f = isSeen ? nearness(1000 * galaxy.distance, p.z) : 1;
    positions[3 * i] = static_cast<float>(f * p.x);
    positions[3 * i + 1] = static_cast<float>(f * p.y);
    positions[3 * i + 2] = static_cast<float>(p.z);
  });
  return positions;
}

template <typename Array, typename T>
Buffer<T> copyOf(vtkPolyData* input, const char* name, int channels, const std::string& file)
{
  auto array = Array::SafeDownCast(input->GetPointData()->GetArray(name));
  if (!array || array->GetNumberOfComponents() != channels)
  {
    throw Error(file, name, "no such point array; the input must come from DiskSeeds");
  }
  Buffer<T> buffer(static_cast<std::size_t>(array->GetNumberOfValues()));
  std::copy_n(array->GetPointer(0), buffer.size(), buffer.data());
  return buffer;
}
}

ComponentDescription& SeedData::description()
{
  auto& components = this->galaxy.description.components;
  const auto found = std::find_if(components.begin(), components.end(),
    [this](const ComponentDescription& c) { return c.name == this->component; });
  if (found == components.end())
  {
    throw Error(this->galaxy.description.file, this->component,
      "there is no such component; choose one of the .galaxy file's");
  }
  return *found;
}

void toPolyData(SeedData&& data, vtkPolyData* output)
{
  Buffer<float> positions = positionsOf(data);
  Seeds& seeds = data.seeds;
  vtkNew<vtkPoints> points;
  points->SetData(adopt<vtkFloatArray>(positions, "Points", 3));
  output->SetPoints(points);
  addVertices(output);
  toFieldData(data.galaxy, output);
  setFieldString(output, "SeedComponent", data.component);
  vtkNew<vtkDoubleArray> sampling;
  sampling->SetName("SeedSampling");
  sampling->SetNumberOfValues(SamplingSize);
  sampling->SetValue(Drawn, static_cast<double>(seeds.drawn));
  sampling->SetValue(InnerRadius, seeds.innerRadius);
  sampling->SetValue(OuterRadius, seeds.outerRadius);
  output->GetFieldData()->AddArray(sampling);

  vtkPointData* arrays = output->GetPointData();
  arrays->AddArray(adopt<vtkFloatArray>(seeds.radius, "Radius", 1));
  arrays->AddArray(adopt<vtkFloatArray>(seeds.azimuth, "Azimuth", 1));
  arrays->AddArray(adopt<vtkFloatArray>(seeds.intensity, "Intensity", 1));
  arrays->AddArray(adopt<vtkFloatArray>(seeds.light, "Light", 1));
  arrays->AddArray(adopt<vtkUnsignedCharArray>(seeds.color, "Color", 3));
  arrays->AddArray(adopt<vtkUnsignedIntArray>(seeds.index, "Draw", 1));
}

SeedData toSeeds(vtkPolyData* input)
{
  SeedData data;
  data.galaxy = galaxyOfFieldData(input);
  const std::string& file = data.galaxy.description.file;
  data.component = fieldString(input, "SeedComponent", file);
  vtkDataArray* sampling = input->GetFieldData()->GetArray("SeedSampling");
  if (!sampling || sampling->GetNumberOfTuples() != SamplingSize)
  {
    throw Error(file, "SeedSampling", "no such field array; the input must come from DiskSeeds");
  }
  Seeds& seeds = data.seeds;
  seeds.drawn = static_cast<std::size_t>(sampling->GetTuple1(Drawn));
  seeds.innerRadius = sampling->GetTuple1(InnerRadius);
  seeds.outerRadius = sampling->GetTuple1(OuterRadius);
  seeds.radius = copyOf<vtkFloatArray, float>(input, "Radius", 1, file);
  seeds.azimuth = copyOf<vtkFloatArray, float>(input, "Azimuth", 1, file);
  seeds.intensity = copyOf<vtkFloatArray, float>(input, "Intensity", 1, file);
  seeds.light = copyOf<vtkFloatArray, float>(input, "Light", 1, file);
  seeds.color = copyOf<vtkUnsignedCharArray, std::uint8_t>(input, "Color", 3, file);
  seeds.index = copyOf<vtkUnsignedIntArray, std::uint32_t>(input, "Draw", 1, file);
  return data;
}

void seedsToParticles(vtkPolyData* input, int randomSeed, bool velocities,
  const std::function<void(ComponentDescription&)>& change, const Progress& progress,
  vtkPolyData* output)
{
  if (input->GetNumberOfPoints() == 0 && !isFirstProcess())
  {
    return;
  }
  SeedData data = toSeeds(input);
  change(data.description());
  BuildOptions options;
  options.seed = seedOf(randomSeed);
  options.velocities = velocities;
  options.progress = progress;
  toPolyData(buildFromSeeds(data.galaxy, data.component, data.seeds, options), output);
  setSkyPlace(data.galaxy.description, output);
}
}
