#include "Filters/Export/ExportParticles.h"

#include "Filters/Export/ExportProgress.h"
#include "Filters/Export/GadgetBinary.h"
#include "Filters/Export/GadgetHDF5.h"
#include "Filters/Export/ParticleCSV.h"
#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

namespace galaxy
{
namespace
{
bool isSound(const ParticleTable& table, std::size_t i)
{
  const float* p = table.position + 3 * i;
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) &&
    table.componentOf(i) < table.components.size();
}

/// Other programs sort particles into trees, in which one without a place makes them fail or hang.
void check(const ParticleTable& table, const std::string& file)
{
  if (table.size == 0)
  {
    throw Error(file, "", "there are no particles to write; check the writer's input");
  }
  std::size_t first = table.size;
#pragma omp parallel for reduction(min : first)
  for (std::size_t i = 0; i < table.size; ++i)
  {
    first = isSound(table, i) ? first : std::min(first, i);
  }
  if (first == table.size)
  {
    return;
  }
  const std::string particle = "particle " + std::to_string(first);
  const std::size_t component = table.componentOf(first);
  throw Error(file, particle,
    component < table.components.size()
      ? "its position must be finite"
      : "its component must be below " + std::to_string(table.components.size()) +
        ", the component table's size, not " + std::to_string(component));
}

void write(const ParticleTable& table, const std::string& file, const ExportOptions& options)
{
  switch (options.format)
  {
    case ParticleFormat::Gadget1:
      return writeGadgetBinary(table, file, 1, options.largestBlock, options.progress);
    case ParticleFormat::Gadget2:
      return writeGadgetBinary(table, file, 2, options.largestBlock, options.progress);
    case ParticleFormat::GadgetHDF5:
      return writeGadgetHDF5(table, file, options.progress);
    case ParticleFormat::CSV:
      return writeParticleCSV(table, file, options.progress);
  }
}
} // namespace

ParticleFormat formatOfFile(const std::string& file)
{
  static const std::map<std::string, ParticleFormat> formats = {
    { ".g1", ParticleFormat::Gadget1 },
    { ".gad", ParticleFormat::Gadget2 },
    { ".gadget", ParticleFormat::Gadget2 },
    { ".g2", ParticleFormat::Gadget2 },
    { ".hdf5", ParticleFormat::GadgetHDF5 },
    { ".h5", ParticleFormat::GadgetHDF5 },
    { ".csv", ParticleFormat::CSV },
  };
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const auto format = formats.find(extension);
  if (format == formats.end())
  {
    throw Error(file, "", "its extension must be .g1, .gad, .gadget, .g2, .hdf5, .h5 or .csv");
  }
  return format->second;
}

bool exportParticles(
  const ParticleTable& table, const std::string& file, const ExportOptions& options)
{
  check(table, file);
  try
  {
    write(table, file, options);
    return true;
  }
  catch (const ExportAborted&)
  {
    return false;
  }
}
} // namespace galaxy
