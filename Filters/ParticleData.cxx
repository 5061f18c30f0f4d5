#include "ParticleData.h"

#include "Filters/AdoptBuffer.h"
#include "Filters/PointArrays.h"
#include "Filters/Vertices.h"
#include "vtkSplatSettings.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace galaxy
{
namespace
{
/// As the engine has it: a particle beyond that has no place, nor one with larger a kernel.
constexpr double largestPlace = 1e30;

bool isPlace(const double point[3])
{
  return std::all_of(point, point + 3, [](double value) { return std::abs(value) < largestPlace; });
}

/// Of the points that have a place.
void finiteBounds(vtkPolyData* particles, double bounds[6])
{
  particles->GetBounds(bounds);
  const double low[3] = { bounds[0], bounds[2], bounds[4] };
  const double high[3] = { bounds[1], bounds[3], bounds[5] };
  if (isPlace(low) && isPlace(high))
  {
    return;
  }
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < particles->GetNumberOfPoints(); ++i)
  {
    double point[3];
    particles->GetPoint(i, point);
    if (isPlace(point))
    {
      box.AddPoint(point);
    }
  }
  box.GetBounds(bounds);
}

/// The largest of any particle, with the settings' size factors, kpc.
double largestSmoothingLength(vtkPolyData* particles, vtkSplatSettings& settings)
{
  vtkDataArray* h = particles->GetPointData()->GetArray("SmoothingLength");
  if (!h)
  {
    return 0;
  }
  std::vector<ComponentInfo> components = toComponents(particles->GetFieldData());
  std::vector<bool> visible;
  settings.Apply(components, visible);
  double factor = 0;
  for (const ComponentInfo& component : components)
  {
    factor = std::max(factor, component.size);
  }
  double range[2];
  h->GetFiniteRange(range);
  if (range[1] < largestPlace)
  {
    return std::max(0.0, factor * range[1]);
  }
  double largest = 0;
  for (vtkIdType i = 0; i < h->GetNumberOfTuples(); ++i)
  {
    const double own = h->GetComponent(i, 0);
    largest = own < largestPlace ? std::max(largest, own) : largest;
  }
  return factor * largest;
}
}

void toFieldData(const std::vector<ComponentInfo>& components, vtkFieldData* fields)
{
  vtkNew<vtkStringArray> names;
  vtkNew<vtkUnsignedCharArray> absorbs;
  vtkNew<vtkDoubleArray> absorption, size, brightness;
  names->SetName("ComponentName");
  absorbs->SetName("ComponentAbsorbs");
  absorption->SetName("ComponentAbsorption");
  absorption->SetNumberOfComponents(3);
  size->SetName("ComponentSize");
  brightness->SetName("ComponentBrightness");
  for (const ComponentInfo& component : components)
  {
    names->InsertNextValue(component.name);
    absorbs->InsertNextValue(component.absorbs ? 1 : 0);
    absorption->InsertNextTuple(component.absorption.data());
    size->InsertNextValue(component.size);
    brightness->InsertNextValue(component.brightness);
  }
  fields->AddArray(names);
  fields->AddArray(absorbs);
  fields->AddArray(absorption);
  fields->AddArray(size);
  fields->AddArray(brightness);
}

std::vector<ComponentInfo> toComponents(vtkFieldData* fields)
{
  auto names = vtkStringArray::SafeDownCast(fields->GetAbstractArray("ComponentName"));
  if (!names || names->GetNumberOfValues() == 0)
  {
    return { ComponentInfo{} };
  }
  const auto value = [fields](const char* name, vtkIdType i, int channel, double fallback) {
    vtkDataArray* array = fields->GetArray(name);
    return array && i < array->GetNumberOfTuples() && channel < array->GetNumberOfComponents()
      ? array->GetComponent(i, channel)
      : fallback;
  };
  std::vector<ComponentInfo> components(static_cast<std::size_t>(names->GetNumberOfValues()));
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    const auto i = static_cast<vtkIdType>(k);
    components[k].name = names->GetValue(i);
    components[k].absorbs = value("ComponentAbsorbs", i, 0, 0) != 0;
    for (int channel = 0; channel < 3; ++channel)
    {
      components[k].absorption[channel] = value("ComponentAbsorption", i, channel, 1);
    }
    components[k].size = value("ComponentSize", i, 0, 1);
    components[k].brightness = value("ComponentBrightness", i, 0, 1);
  }
  return components;
}

void toPolyData(Particles&& particles, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(adopt<vtkFloatArray>(particles.position, "Points", 3));
  output->SetPoints(points);
  addVertices(output);
  vtkPointData* arrays = output->GetPointData();
  arrays->AddArray(adopt<vtkFloatArray>(particles.smoothingLength, "SmoothingLength", 1));
  arrays->AddArray(adopt<vtkFloatArray>(particles.intensity, "Intensity", 1));
  arrays->AddArray(adopt<vtkUnsignedCharArray>(particles.color, "Color", 3));
  arrays->AddArray(adopt<vtkUnsignedCharArray>(particles.component, "Component", 1));
  if (!particles.velocity.empty())
  {
    arrays->AddArray(adopt<vtkFloatArray>(particles.velocity, "Velocity", 3));
  }
  toFieldData(particles.components, output->GetFieldData());
}

void viewParticles(vtkPolyData* particles, vtkSplatSettings& settings, ParticleInput& input)
{
  input.components = toComponents(particles->GetFieldData());
  settings.Apply(input.components, input.visible);
  ParticleView& view = input.view;
  view.size = static_cast<std::size_t>(particles->GetNumberOfPoints());
  view.components = &input.components;
  view.visible = &input.visible;
  if (view.size > 0)
  {
    fillView(particles, view);
  }
}

void boundsOfKernels(vtkPolyData* particles, vtkSplatSettings& settings, double bounds[6])
{
  vtkMath::UninitializeBounds(bounds);
  if (!particles || particles->GetNumberOfPoints() == 0)
  {
    return;
  }
  finiteBounds(particles, bounds);
  const double h = largestSmoothingLength(particles, settings);
  for (int axis = 0; axis < 3 && bounds[0] <= bounds[1]; ++axis)
  {
    bounds[2 * axis] -= h;
    bounds[2 * axis + 1] += h;
  }
}

RenderOptions renderOptions(vtkSplatSettings& settings)
{
  RenderOptions options;
  options.kernel =
    settings.GetKernel() == vtkSplatSettings::CUBIC_SPLINE ? Kernel::CubicSpline : Kernel::Gaussian;
  options.accuracy = static_cast<Accuracy>(settings.GetAccuracy());
  options.previewTime = settings.GetPreviewTime();
  options.slices = settings.GetSlices();
  return options;
}

std::string describe(const RenderStatistics& statistics)
{
  std::ostringstream text;
  text << statistics.drawn << " particles drawn, " << statistics.culled << " culled";
  if (statistics.invalid)
  {
    text << ", " << statistics.invalid << " invalid";
  }
  if (statistics.tooBright)
  {
    text << "; " << statistics.tooBright
         << " values of radiance are more than 3.4e38, the most that single precision holds, and "
            "given "
            "as that: choose a larger unit of luminosity";
  }
  if (statistics.sampled)
  {
    text << "; a random " << statistics.sampled << " stand for all";
  }
  if (statistics.faint || statistics.untouched)
  {
    text << "; " << statistics.faint << " splats too faint to matter, " << statistics.untouched
         << " behind what lets no light through";
  }
  if (statistics.bound.light > 0 || statistics.bound.share > 0)
  {
    text << "; off by no more than " << statistics.bound.light << " (luminosity per kpc^2) and "
         << 100 * statistics.bound.share << " %";
  }
  if (statistics.thickest > 0)
  {
    // A pair of an emitter and an absorber of t that share one place is off by t/2 in Sorted.
    text << "; thickest particle of optical depth " << statistics.thickest
         << " (Sorted may be off by half of that where it overlaps light)";
  }
  if (statistics.raySums > 0)
  {
    // Every sum takes some nanoseconds of one core.
    text << "; " << statistics.raySums << " sums along rays";
    if (statistics.raySums > 1e9)
    {
      text << ", a second of a core for each 1e8 or so: fewer Slices, a smaller picture or larger "
              "absorbers cost less";
    }
  }
  if (statistics.coarse)
  {
    text << "; " << statistics.coarse << " tiles had too little room for so many slices";
  }
  for (const auto& stage : statistics.seconds)
  {
    text << "; " << stage.first << " " << stage.second << " s";
  }
  return text.str();
}
}
