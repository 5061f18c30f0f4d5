#include "vtkSplatSettings.h"

#include "Filters/Model/Looks.h"

#include "vtkObjectFactory.h"

#include <set>

vtkStandardNewMacro(vtkSplatSettings);

void vtkSplatSettings::SetFactor(FactorMap& factors, const char* component, double factor)
{
  if (!component)
  {
    return;
  }
  factors[component] = factor;
  this->Modified();
}

void vtkSplatSettings::ClearFactors(FactorMap& factors)
{
  if (!factors.empty())
  {
    factors.clear();
    this->Modified();
  }
}

void vtkSplatSettings::SetComponentSize(const char* component, double factor)
{
  this->SetFactor(this->Sizes, component, factor);
}

void vtkSplatSettings::ClearComponentSize()
{
  this->ClearFactors(this->Sizes);
}

void vtkSplatSettings::SetComponentBrightness(const char* component, double factor)
{
  this->SetFactor(this->Brightnesses, component, factor);
}

void vtkSplatSettings::ClearComponentBrightness()
{
  this->ClearFactors(this->Brightnesses);
}

void vtkSplatSettings::SetComponentColor(
  const char* component, double red, double green, double blue)
{
  if (component)
  {
    this->Colors[component] = { red, green, blue };
    this->Modified();
  }
}

void vtkSplatSettings::ClearComponentColor()
{
  if (!this->Colors.empty())
  {
    this->Colors.clear();
    this->Modified();
  }
}

void vtkSplatSettings::SetComponentVisibility(const char* component, int visible)
{
  this->SetFactor(this->Visibilities, component, visible);
}

void vtkSplatSettings::ClearComponentVisibility()
{
  this->ClearFactors(this->Visibilities);
}

std::string vtkSplatSettings::UnknownNames(
  const std::vector<galaxy::ComponentInfo>& components) const
{
  std::set<std::string> unknown;
  for (const FactorMap* factors : { &this->Sizes, &this->Brightnesses, &this->Visibilities })
  {
    for (const auto& factor : *factors)
    {
      unknown.insert(factor.first);
    }
  }
  for (const auto& color : this->Colors)
  {
    unknown.insert(color.first);
  }
  for (const galaxy::ComponentInfo& component : components)
  {
    unknown.erase(component.name);
  }
  std::string text;
  for (const std::string& name : unknown)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

void vtkSplatSettings::Apply(
  std::vector<galaxy::ComponentInfo>& components, std::vector<bool>& visible) const
{
  const auto factor = [](const FactorMap& factors, const std::string& name) {
    const auto found = factors.find(name);
    return found == factors.end() ? 1.0 : found->second;
  };
  visible.assign(components.size(), true);
  galaxy::applyLook(static_cast<galaxy::Look>(this->Look), components, visible);
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    galaxy::ComponentInfo& component = components[i];
    component.size *= factor(this->Sizes, component.name);
    component.brightness *= factor(this->Brightnesses, component.name);
    const auto color = this->Colors.find(component.name);
    if (color != this->Colors.end())
    {
      component.isRecolored = true;
      component.color = color->second;
    }
    const auto shown = this->Visibilities.find(component.name);
    if (shown != this->Visibilities.end())
    {
      visible[i] = shown->second != 0;
    }
  }
}

void vtkSplatSettings::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Kernel: " << (this->Kernel == GAUSSIAN ? "Gaussian" : "CubicSpline") << "\n";
  const char* levels[] = { "Overlapping", "Sorted", "Bounded", "Preview" };
  os << indent << "Accuracy: " << levels[this->Accuracy] << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "PreviewTime: " << this->PreviewTime << "\n";
  os << indent << "Look: " << this->Look << "\n";
  os << indent << "Slices: " << this->Slices << "\n";
}
