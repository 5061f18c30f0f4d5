#include "JoinParticles.h"

#include "Filters/ParticleData.h"
#include "Filters/PointArrays.h"
#include "Readers/Formats/AvailableMemory.h"

#include "vtkFieldData.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace galaxy
{
namespace
{
using Parts = std::vector<vtkSmartPointer<vtkPolyData>>;

bool isSame(const ComponentInfo& a, const ComponentInfo& b)
{
  return a.name == b.name && a.absorbs == b.absorbs && a.absorption == b.absorption &&
    a.size == b.size && a.brightness == b.brightness;
}

/// The components of all parts, and for each part where its own are among them.
struct JoinedTable
{
  std::vector<ComponentInfo> components;
  std::vector<std::vector<unsigned char>> places;

  explicit JoinedTable(const Parts& parts)
  {
    for (vtkPolyData* part : parts)
    {
      this->places.emplace_back();
      for (const ComponentInfo& component : toComponents(part->GetFieldData()))
      {
        this->places.back().push_back(this->placeOf(component));
      }
    }
  }

  unsigned char placeOf(const ComponentInfo& component)
  {
    const auto found = std::find_if(this->components.begin(), this->components.end(),
      [&](const ComponentInfo& other) { return isSame(component, other); });
    const auto place = static_cast<std::size_t>(found - this->components.begin());
    if (found == this->components.end())
    {
      this->components.push_back(component);
    }
    if (place > 255)
    {
      throw std::runtime_error("the particles have more than 256 components together; hand on "
                               "fewer of them, or give alike ones the same names and factors");
    }
    return static_cast<unsigned char>(place);
  }
};

template <typename Array>
bool someHave(const Parts& parts, const char* name)
{
  return std::any_of(parts.begin(), parts.end(),
    [name](vtkPolyData* part) { return plainArray<Array>(part, name) != nullptr; });
}

vtkIdType sizeOf(const Parts& parts)
{
  vtkIdType size = 0;
  for (vtkPolyData* part : parts)
  {
    size += part->GetNumberOfPoints();
  }
  return size;
}

/// An array for all particles, filled part by part by `fill(part, its number, where)`.
template <typename Array, typename Fill>
vtkSmartPointer<Array> joined(const Parts& parts, const char* name, int channels, Fill fill)
{
  // VTK's arrays end the program where there is no memory for them.
  requireMemory(double(sizeof(typename Array::ValueType)) * channels * double(sizeOf(parts)),
    "particles", name, "joining them", "use a smaller ParticleScale or show fewer");
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(channels);
  array->SetNumberOfTuples(sizeOf(parts));
  auto* at = array->GetPointer(0);
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    fill(parts[k].Get(), k, at);
    at += channels * parts[k]->GetNumberOfPoints();
  }
  return array;
}

/// Where some parts have the array, all get it.
template <typename Array, typename T>
void join(const Parts& parts, const char* name, int channels, T otherwise, vtkPolyData* to)
{
  if (!someHave<Array>(parts, name))
  {
    return;
  }
  const auto fill = [&](vtkPolyData* part, std::size_t, T* at) {
    auto own = plainArray<Array>(part, name);
    const vtkIdType values = channels * part->GetNumberOfPoints();
    own ? std::copy_n(own->GetPointer(0), values, at) : std::fill_n(at, values, otherwise);
  };
  to->GetPointData()->AddArray(joined<Array>(parts, name, channels, fill));
}

/// A part's light of one kind, red, green and blue: its own, or what its Intensity amounts to.
void fillLight(vtkPolyData* part, bool isAbsorption, float* at)
{
  const char* name = isAbsorption ? "Absorption" : "Emission";
  ParticleView own;
  fillView(part, own);
  const auto size = static_cast<std::size_t>(part->GetNumberOfPoints());
  const float* array = isAbsorption ? own.absorption : own.emission;
  const int channels = array ? plainArray<vtkFloatArray>(part, name)->GetNumberOfComponents() : 3;
  const std::vector<ComponentInfo> components = toComponents(part->GetFieldData());
  const bool isOther = own.emission || own.absorption || !own.intensity;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t k = std::min<std::size_t>(own.component ? own.component[i] : 0, //
      components.size() - 1);
    for (int c = 0; c < 3; ++c)
    {
      float& value = at[3 * i + c];
      value = array ? array[channels * i + (channels == 3 ? c : 0)] : 0;
      if (!isOther && components[k].absorbs == isAbsorption)
      {
        value = own.intensity[i] *
          (isAbsorption ? static_cast<float>(components[k].absorption[c])
                        : (own.color ? own.color[3 * i + c] : 255) / 255.0F);
      }
    }
  }
}

void joinLight(const Parts& parts, vtkPolyData* to)
{
  const bool absorb = someHave<vtkFloatArray>(parts, "Absorption") ||
    std::any_of(parts.begin(), parts.end(), [](vtkPolyData* part) {
      const std::vector<ComponentInfo> components = toComponents(part->GetFieldData());
      return std::any_of(components.begin(), components.end(),
        [](const ComponentInfo& component) { return component.absorbs; });
    });
  for (const bool isAbsorption : { false, true })
  {
    if (!isAbsorption || absorb)
    {
      to->GetPointData()->AddArray(
        joined<vtkFloatArray>(parts, isAbsorption ? "Absorption" : "Emission", 3,
          [&](vtkPolyData* part, std::size_t, float* at) { fillLight(part, isAbsorption, at); }));
    }
  }
}

void joinComponents(const Parts& parts, vtkPolyData* to)
{
  const JoinedTable table(parts);
  to->GetPointData()->AddArray(joined<vtkUnsignedCharArray>(
    parts, "Component", 1, [&](vtkPolyData* part, std::size_t k, unsigned char* at) {
      auto own = plainArray<vtkUnsignedCharArray>(part, "Component");
      const std::vector<unsigned char>& places = table.places[k];
      for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
      {
        const std::size_t number = own ? own->GetValue(i) : 0;
        at[i] = places[std::min(number, places.size() - 1)];
      }
    }));
  toFieldData(table.components, to->GetFieldData());
}
} // namespace

vtkSmartPointer<vtkPolyData> joinParticles(const Parts& parts)
{
  if (parts.size() == 1)
  {
    return parts.front();
  }
  auto all = vtkSmartPointer<vtkPolyData>::New();
  if (parts.empty())
  {
    return all;
  }
  all->GetFieldData()->ShallowCopy(parts.front()->GetFieldData());
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(
    joined<vtkFloatArray>(parts, "Points", 3, [](vtkPolyData* part, std::size_t, float* at) {
      auto own = vtkFloatArray::SafeDownCast(part->GetPoints()->GetData());
      std::copy_n(own->GetPointer(0), 3 * part->GetNumberOfPoints(), at);
    }));
  all->SetPoints(points);
  join<vtkFloatArray, float>(parts, "SmoothingLength", 1, 0, all);
  join<vtkFloatArray, float>(parts, "Intensity", 1, 1, all);
  join<vtkFloatArray, float>(parts, "Velocity", 3, 0, all);
  join<vtkUnsignedCharArray, unsigned char>(parts, "Color", 3, 255, all);
  joinComponents(parts, all);
  if (someHave<vtkFloatArray>(parts, "Emission") || someHave<vtkFloatArray>(parts, "Absorption"))
  {
    joinLight(parts, all);
  }
  return all;
}
} // namespace galaxy
