#include "Filters/Splatting/JointParticles.h"

#include "Filters/Splatting/Projection.h"
#include "Readers/Formats/ComponentLimit.h"
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
  std::size_t size = 0, at = 0, first = 0;
  for (const ParticleView& part : parts)
  {
    size += part.size;
  }
  const bool asArrays = keepsColors(parts);
  const bool absorb = std::any_of(parts.begin(), parts.end(), absorbs);
  const std::size_t light = asArrays ? absorb ? 6 : 3 : 1;
  requireMemoryOfCopies(size, 4 + light, asArrays ? 1 : 4);
  this->arrays.position.resize(3 * size);
  this->arrays.smoothingLength.resize(size);
  this->arrays.component.resize(size);
  this->arrays.intensity.resize(asArrays ? 0 : size);
  this->arrays.color.resize(asArrays ? 0 : 3 * size);
  this->arrays.emission.resize(asArrays ? 3 * size : 0);
  this->arrays.absorption.resize(asArrays && absorb ? 3 * size : 0);
  for (const ParticleView& part : parts)
  {
    this->add(part, at, first);
    at += part.size;
    first += tableOf(part).size();
    if (first > mostComponents)
    {
      throw Error("particles", "", "more than 256 components in one view; hide some of them");
    }
  }
}

/// From particle `at` on; `first` is the number of the part's first component.
void JointParticles::add(const ParticleView& part, std::size_t at, std::size_t first)
{
  const auto put = [&](auto& to, const auto* from, std::size_t width, int otherwise) {
    const auto start = to.begin() + width * at;
    from ? std::copy_n(from, width * part.size, start)
         : std::fill_n(start, width * part.size, otherwise);
  };
  put(this->arrays.position, part.position, 3, 0);
  put(this->arrays.smoothingLength, part.smoothingLength, 1, 0);
  const std::size_t last = tableOf(part).size() - 1;
  for (std::size_t i = 0; i < part.size; ++i)
  {
    const std::size_t k = part.component ? std::min<std::size_t>(part.component[i], last) : 0;
    this->arrays.component[at + i] = static_cast<std::uint8_t>(first + k);
  }
  if (!this->arrays.emission.empty())
  {
    this->addLight(part, at);
    return;
  }
  put(this->arrays.intensity, part.intensity, 1, 0);
  put(this->arrays.color, part.color, 3, 255);
}

void JointParticles::addLight(const ParticleView& part, std::size_t at)
{
  // As they are without the factors, which may change later.
  std::vector<ComponentInfo> table = tableOf(part);
  for (ComponentInfo& info : table)
  {
    info.brightness = info.light = 1;
  }
  ParticleView plain = part;
  plain.components = &table;
  const Projection projection(plain, { Camera(), Kernel::Gaussian });
  for (std::size_t i = 0; i < part.size; ++i)
  {
    ParticleLight light = projection.light(i);
    for (int c = 0; c < 3; ++c)
    {
      light.L[c] *= static_cast<float>(projection.lightUnit());
      light.K[c] *= static_cast<float>(projection.depthUnit());
    }
    std::copy_n(light.L, 3, &this->arrays.emission[3 * (at + i)]);
    if (!this->arrays.absorption.empty())
    {
      std::copy_n(light.K, 3, &this->arrays.absorption[3 * (at + i)]);
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
  ParticleView view = this->arrays.view();
  view.components = &this->components;
  view.visible = &this->visible;
  return view;
}
} // namespace galaxy
