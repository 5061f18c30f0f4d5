#include "Filters/Splatting/JointParticles.h"

#include "Filters/Splatting/Projection.h"
#include "Readers/Formats/Error.h"

#include <algorithm>

namespace galaxy
{
namespace
{
bool hasArrays(const ParticleView& part)
{
  return part.emission || part.absorption;
}

bool absorbs(const ParticleView& part)
{
  const auto isAbsorber = [](const ComponentInfo& component) { return component.absorbs; };
  return part.absorption ||
    (part.components && std::any_of(part.components->begin(), part.components->end(), isAbsorber));
}

std::vector<ComponentInfo> tableOf(const ParticleView& part)
{
  return part.components && !part.components->empty() ? *part.components
                                                      : std::vector<ComponentInfo>(1);
}
} // namespace

bool JointParticles::keepsColors(const std::vector<ParticleView>& parts)
{
  return std::any_of(parts.begin(), parts.end(), hasArrays);
}

JointParticles::JointParticles(const std::vector<ParticleView>& parts)
{
  std::size_t size = 0, first = 0;
  for (const ParticleView& part : parts)
  {
    size += part.size;
  }
  const bool asArrays = keepsColors(parts);
  this->position.reserve(3 * size);
  this->smoothingLength.reserve(size);
  this->component.reserve(size);
  if (asArrays)
  {
    this->emission.reserve(3 * size);
    if (std::any_of(parts.begin(), parts.end(), absorbs))
    {
      this->absorption.reserve(3 * size);
    }
  }
  else
  {
    this->intensity.reserve(size);
    this->color.reserve(3 * size);
  }
  for (const ParticleView& part : parts)
  {
    this->add(part, first);
    first += tableOf(part).size();
    if (first > 256)
    {
      throw Error("particles", "", "more than 256 components in one view; hide some of them");
    }
  }
}

/// `first` is the number of the part's first component.
void JointParticles::add(const ParticleView& part, std::size_t first)
{
  const auto append = [&part](auto& to, const auto* from, std::size_t width, int otherwise) {
    from ? to.insert(to.end(), from, from + width * part.size)
         : to.insert(to.end(), width * part.size, otherwise);
  };
  append(this->position, part.position, 3, 0);
  append(this->smoothingLength, part.smoothingLength, 1, 0);
  const std::size_t last = tableOf(part).size() - 1;
  for (std::size_t i = 0; i < part.size; ++i)
  {
    const std::size_t k = part.component ? std::min<std::size_t>(part.component[i], last) : 0;
    this->component.push_back(static_cast<std::uint8_t>(first + k));
  }
  if (this->emission.capacity() > 0)
  {
    this->addLight(part);
    return;
  }
  append(this->intensity, part.intensity, 1, 0);
  append(this->color, part.color, 3, 255);
}

void JointParticles::addLight(const ParticleView& part)
{
  // As they are without the factors, which may change later.
  std::vector<ComponentInfo> table = tableOf(part);
  for (ComponentInfo& info : table)
  {
    info.brightness = info.light = 1;
  }
  ParticleView plain = part;
  plain.components = &table;
  const Projection projection(plain, Camera());
  for (std::size_t i = 0; i < part.size; ++i)
  {
    const ParticleLight light = projection.light(i);
    this->emission.insert(this->emission.end(), light.L, light.L + 3);
    if (this->absorption.capacity() > 0)
    {
      this->absorption.insert(this->absorption.end(), light.K, light.K + 3);
    }
  }
}

ParticleView JointParticles::view(const std::vector<ParticleView>& parts)
{
  this->components.clear();
  this->visible.clear();
  for (const ParticleView& part : parts)
  {
    const std::vector<ComponentInfo> table = tableOf(part);
    this->components.insert(this->components.end(), table.begin(), table.end());
    for (std::size_t k = 0; k < table.size(); ++k)
    {
      this->visible.push_back(!part.visible || k >= part.visible->size() || (*part.visible)[k]);
    }
  }
  const auto dataOf = [](const auto& values) { return values.empty() ? nullptr : values.data(); };
  ParticleView view;
  view.size = this->smoothingLength.size();
  view.position = dataOf(this->position);
  view.smoothingLength = dataOf(this->smoothingLength);
  view.intensity = dataOf(this->intensity);
  view.color = dataOf(this->color);
  view.component = dataOf(this->component);
  view.emission = dataOf(this->emission);
  view.absorption = dataOf(this->absorption);
  view.components = &this->components;
  view.visible = &this->visible;
  return view;
}
} // namespace galaxy
