#include "Filters/Export/GadgetFields.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace galaxy
{
namespace
{
/// A field of one channel, value(i) for particle i.
template <typename T, typename Value>
auto gatherValues(Value value)
{
  return [value](const std::size_t* particles, std::size_t count, char* to) {
    for (std::size_t k = 0; k < count; ++k)
    {
      const T v = static_cast<T>(value(particles[k]));
      std::memcpy(to + k * sizeof(T), &v, sizeof(T));
    }
  };
}

/// A field of three channels.
template <typename T, typename Value>
auto gatherTriples(Value value)
{
  return [value](const std::size_t* particles, std::size_t count, char* to) {
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto v = value(particles[k]);
      const T triple[3] = { static_cast<T>(v[0]), static_cast<T>(v[1]), static_cast<T>(v[2]) };
      std::memcpy(to + k * sizeof(triple), triple, sizeof(triple));
    }
  };
}

/// An array as it is.
auto gatherArray(const float* source, int channels)
{
  const std::size_t bytes = channels * sizeof(float);
  return [source, channels, bytes](const std::size_t* particles, std::size_t count, char* to) {
    for (std::size_t k = 0; k < count; ++k)
    {
      std::memcpy(to + k * bytes, source + particles[k] * channels, bytes);
    }
  };
}

float densityOf(const ParticleTable& table, std::size_t i)
{
  const double pi = 3.14159265358979323846;
  const double h = table.smoothingLengthOf(i);
  return h > 0 ? static_cast<float>(table.intensityOf(i) / (4 * pi / 3 * h * h * h)) : 0;
}

/// What a Gadget file without extensions holds.
std::vector<GadgetField> standardFields(const ParticleTable& table)
{
  const auto number = [](std::size_t i) { return i + 1; };
  const Element ids = elementOfIds(table.size);
  const auto real = Element::Float32;
  return {
    { "POS ", "Coordinates", "kpc", real, 3, false, gatherArray(table.position, 3) },
    { "VEL ", "Velocities", "km/s", real, 3, false,
      gatherTriples<float>([&table](std::size_t i) { return table.velocityOf(i); }) },
    ids == Element::UInt32
      ? GadgetField{ "ID  ", "ParticleIDs", "", ids, 1, false, gatherValues<std::uint32_t>(number) }
      : GadgetField{ "ID  ", "ParticleIDs", "", ids, 1, false,
          gatherValues<std::uint64_t>(number) },
    { "MASS", "Masses", "luminosity; absorbers: kpc^2", real, 1, false,
      gatherValues<float>([&table](std::size_t i) { return table.intensityOf(i); }) },
    { "U   ", "InternalEnergy", "(km/s)^2", real, 1, true,
      gatherValues<float>([](std::size_t) { return 0; }) },
    { "RHO ", "Density", "luminosity/kpc^3", real, 1, true,
      gatherValues<float>([&table](std::size_t i) { return densityOf(table, i); }) },
    { "HSML", "SmoothingLength", "kpc", real, 1, false,
      gatherValues<float>([&table](std::size_t i) { return table.smoothingLengthOf(i); }) },
  };
}

std::vector<GadgetField> ownFields(const ParticleTable& table, bool smallIntegers)
{
  const auto component = [&table](std::size_t i) { return table.componentOf(i); };
  const auto color = [&table](std::size_t i) { return table.colorOf(i); };
  std::vector<GadgetField> fields;
  if (smallIntegers)
  {
    using Byte = std::uint8_t;
    fields = { { "COMP", "Component", "", Element::UInt8, 1, false, gatherValues<Byte>(component) },
      { "COL ", "Color", "", Element::UInt8, 3, false, gatherTriples<Byte>(color) } };
  }
  else
  {
    const auto real = Element::Float32;
    fields = { { "COMP", "Component", "", real, 1, false, gatherValues<float>(component) },
      { "COL ", "Color", "", real, 3, false, gatherTriples<float>(color) } };
  }
  const auto add = [&fields](const char* block, const char* name, const char* unit,
                     const float* source, int channels) {
    if (source)
    {
      fields.push_back(
        { block, name, unit, Element::Float32, channels, false, gatherArray(source, channels) });
    }
  };
  add("EMIS", "Emission", "luminosity", table.emission, table.emissionChannels);
  add("ABSO", "Absorption", "kpc^2", table.absorption, table.absorptionChannels);
  std::stable_sort(fields.begin(), fields.end(),
    [](const GadgetField& a, const GadgetField& b) { return a.channels < b.channels; });
  return fields;
}
} // namespace

std::size_t bytesOf(Element element)
{
  switch (element)
  {
    case Element::UInt8:
      return 1;
    case Element::UInt64:
      return 8;
    case Element::UInt32:
    case Element::Float32:
      break;
  }
  return 4;
}

Element elementOfIds(std::size_t particles)
{
  return particles > std::numeric_limits<std::uint32_t>::max() ? Element::UInt64 : Element::UInt32;
}

std::vector<GadgetField> gadgetFields(const ParticleTable& table, bool smallIntegers)
{
  std::vector<GadgetField> fields = standardFields(table);
  for (GadgetField& field : ownFields(table, smallIntegers))
  {
    fields.push_back(std::move(field));
  }
  return fields;
}
} // namespace galaxy
