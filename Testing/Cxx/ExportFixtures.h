#ifndef galaxy_ExportFixtures_h
#define galaxy_ExportFixtures_h

#include "Filters/Export/ExportParticles.h"
#include "Filters/Model/ParticleWriter.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace galaxy::testing
{
/// A folder that files are written to.
class ExportFolder : public TemporaryFolder
{
protected:
  std::size_t filesThere() const
  {
    const std::filesystem::directory_iterator first(this->folder);
    return static_cast<std::size_t>(std::distance(first, std::filesystem::directory_iterator()));
  }
};

/// No file may grow beyond this many bytes, which to a writer is what a full disk is.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->before);
    rlimit limit = this->before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &this->before); }

private:
  rlimit before;
};

inline std::string contentOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

inline bool exportTo(const std::string& file, const ParticleTable& table, ParticleFormat format,
  std::uint64_t largestBlock = 2147483647)
{
  ExportOptions options;
  options.format = format;
  options.largestBlock = largestBlock;
  return exportParticles(table, file, options);
}

inline std::string messageOf(
  const std::string& file, const ParticleTable& table, ParticleFormat format)
{
  return errorOf([&] { exportTo(file, table, format); });
}

/// Stars, gas, dust and a bulge in no order, every value another one.
inline Particles mixedParticles(std::size_t size, bool velocities = true)
{
  Particles particles = allocateParticles(size, velocities);
  particles.components.resize(4);
  particles.components[0].name = "stars";
  particles.components[1].name = "gas";
  particles.components[2].name = "dust";
  particles.components[2].absorbs = true;
  particles.components[2].absorption = { 0.8, 1.0, 1.3 };
  particles.components[3].name = "bulge";
  particles.components[3].brightness = 2.5;
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::uint8_t color[3] = { static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 7),
      200 };
    const auto component = static_cast<std::uint8_t>(random() % 4);
    const Vec3 position = { normal(random), normal(random), normal(random) };
    const Vec3 velocity = { 200 * normal(random), 200 * normal(random), 1e-30 * normal(random) };
    ParticleWriter(particles, i, component)
      .write(0, position, std::exp(9 * normal(random)), color, velocity);
    particles.smoothingLength[i] = 0.01f * (1 + random() % 100);
  }
  return particles;
}

/// The particles of the named types in the order of a Gadget file.
inline std::vector<std::size_t> gadgetOrder(
  const Particles& particles, const std::vector<int>& components)
{
  std::vector<std::size_t> order;
  for (const int component : components)
  {
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      if (particles.component[i] == component)
      {
        order.push_back(i);
      }
    }
  }
  return order;
}
} // namespace galaxy::testing

#endif
