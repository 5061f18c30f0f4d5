// Builds a galaxy and writes its particles, to see whether another compiler, library or machine
// makes the same ones: five float32 arrays x y z h I, one after the other (kpc).
// Use: galaxy_model_particles FILE.galaxy OUTPUT [SCALE]
#include "Filters/Model/GalaxyBuilder.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>

namespace
{
using namespace galaxy;

/// 64-bit FNV-1a.
template <typename T>
std::uint64_t digestOf(const Buffer<T>& values, std::size_t first, std::size_t last)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  std::uint64_t digest = 0xcbf29ce484222325;
  for (std::size_t k = first * sizeof(T); k < last * sizeof(T); ++k)
  {
    digest = (digest ^ bytes[k]) * 0x100000001b3;
  }
  return digest;
}

void print(const Particles& particles, const BuildReport& report)
{
  std::size_t first = 0;
  while (first < particles.size())
  {
    const std::uint8_t component = particles.component[first];
    const std::size_t last = first + report.components[component].particles;
    std::printf("%-16s %10zu particles, places %016llx, h %016llx, light %016llx\n",
      report.components[component].name.c_str(), last - first,
      static_cast<unsigned long long>(digestOf(particles.position, 3 * first, 3 * last)),
      static_cast<unsigned long long>(digestOf(particles.smoothingLength, first, last)),
      static_cast<unsigned long long>(digestOf(particles.intensity, first, last)));
    first = last;
  }
}

void write(const Particles& particles, const std::string& file)
{
  std::ofstream out(file, std::ios::binary);
  const auto put = [&out](float value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      put(particles.position[3 * i + axis]);
    }
  }
  for (const Buffer<float>* values : { &particles.smoothingLength, &particles.intensity })
  {
    for (const float value : *values)
    {
      put(value);
    }
  }
}
} // namespace

int main(int argc, char** argv)
{
  if (argc < 3)
  {
    std::fprintf(stderr, "use: galaxy_model_particles FILE.galaxy OUTPUT [SCALE]\n");
    return 2;
  }
  try
  {
    BuildOptions options;
    options.particleScale = argc > 3 ? std::atof(argv[3]) : 1;
    BuildReport report;
    const Particles particles = buildGalaxy(readGalaxy(argv[1]), options, &report);
    print(particles, report);
    write(particles, argv[2]);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
