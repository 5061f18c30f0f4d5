#include "Testing/Cxx/ExportFixtures.h"

#include <omp.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace galaxy::testing
{
namespace
{
using TestExportCSV = ExportFolder;

std::vector<float> numbersOf(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<float> values;
  for (std::string text; std::getline(stream, text, ',');)
  {
    values.push_back(std::strtof(text.c_str(), nullptr));
  }
  return values;
}
} // namespace

TEST_F(TestExportCSV, EveryFloatReadsBackAsItself)
{
  const Particles particles = mixedParticles(5000);
  ASSERT_TRUE(exportTo(this->path("m.csv"), tableOf(particles), ParticleFormat::CSV));
  std::ifstream file(this->path("m.csv"));
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line,
    "x_kpc,y_kpc,z_kpc,vx_km_s,vy_km_s,vz_km_s,smoothing_length_kpc,intensity,"
    "red,green,blue,component,absorbs");
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    ASSERT_TRUE(std::getline(file, line));
    const float* p = &particles.position[3 * i];
    const float* v = &particles.velocity[3 * i];
    const std::uint8_t* c = &particles.color[3 * i];
    const std::vector<float> expected = { p[0], p[1], p[2], v[0], v[1], v[2],
      particles.smoothingLength[i], particles.intensity[i], float(c[0]), float(c[1]), float(c[2]),
      float(particles.component[i]), particles.component[i] == 2 ? 1.0f : 0.0f };
    ASSERT_EQ(numbersOf(line), expected) << i;
  }
  EXPECT_FALSE(std::getline(file, line));
}

TEST_F(TestExportCSV, TheLongestNumbersFit)
{
  const float longest = -1.17549435e-38f;
  const std::vector<float> values(6 * 3000, longest);
  const std::vector<std::uint8_t> colors(3 * 3000, 255), components(3000, 255);
  ParticleTable table;
  table.size = 3000;
  table.position = table.velocity = table.smoothingLength = table.intensity = values.data();
  table.emission = table.absorption = values.data();
  table.color = colors.data();
  table.component = components.data();
  table.components.resize(256);
  ASSERT_TRUE(exportTo(this->path("m.csv"), table, ParticleFormat::CSV));
  std::ifstream file(this->path("m.csv"));
  std::string header, row;
  std::getline(file, header);
  EXPECT_NE(
    header.find(",emission_red,emission_green,emission_blue,absorption_red"), std::string::npos);
  for (std::size_t i = 0; i < table.size; ++i)
  {
    ASSERT_TRUE(std::getline(file, row));
    const std::vector<float> read = numbersOf(row);
    ASSERT_EQ(read.size(), 19u);
    ASSERT_EQ(read.front(), longest);
    ASSERT_EQ(read.back(), longest);
  }
}

TEST_F(TestExportCSV, ValuesThatAreNoNumbersStay)
{
  const float position[3] = { 0, 0, 0 };
  const float intensity[1] = { std::numeric_limits<float>::quiet_NaN() };
  const float h[1] = { std::numeric_limits<float>::infinity() };
  ParticleTable table;
  table.size = 1;
  table.position = position;
  table.intensity = intensity;
  table.smoothingLength = h;
  ASSERT_TRUE(exportTo(this->path("m.csv"), table, ParticleFormat::CSV));
  EXPECT_NE(contentOf(this->path("m.csv")).find("\n0,0,0,0,0,0,inf,nan,255,255,255,0,0\n"),
    std::string::npos);
}

TEST_F(TestExportCSV, IsTheSameForAnyNumberOfThreads)
{
  const Particles particles = mixedParticles(70000);
  omp_set_num_threads(1);
  ASSERT_TRUE(exportTo(this->path("one.csv"), tableOf(particles), ParticleFormat::CSV));
  omp_set_num_threads(3);
  ASSERT_TRUE(exportTo(this->path("three.csv"), tableOf(particles), ParticleFormat::CSV));
  EXPECT_TRUE(contentOf(this->path("one.csv")) == contentOf(this->path("three.csv")));
}
} // namespace galaxy::testing
