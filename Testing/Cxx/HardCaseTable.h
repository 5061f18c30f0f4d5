#ifndef galaxy_HardCaseTable_h
#define galaxy_HardCaseTable_h

#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace galaxy
{
/// The table, printed when all tests are done.
class HardCaseTable : public ::testing::Environment
{
public:
  static void add(
    const char* name, const char* what, double expected, double got, double error, double allowed)
  {
    char line[256];
    std::snprintf(line, sizeof(line), "| %s | %s | %.9g | %.9g | %.2g | %.2g | %s |", name, what,
      expected, got, error, allowed, error <= allowed ? "pass" : "FAIL");
    lines().emplace_back(line);
  }
  void TearDown() override
  {
    std::printf(
      "\n| case | what | expected | got | error | allowed | |\n|---|---|---|---|---|---|---|\n");
    for (const std::string& line : lines())
    {
      std::printf("%s\n", line.c_str());
    }
  }

private:
  static std::vector<std::string>& lines()
  {
    static std::vector<std::string> all;
    return all;
  }
};
inline const auto* const hardCaseTable = ::testing::AddGlobalTestEnvironment(new HardCaseTable);

/// Relative to what is expected, or absolute where that is 0.
inline void check(const char* name, const char* what, double expected, double got, double allowed)
{
  const double error = std::abs(got - expected) / (expected != 0 ? std::abs(expected) : 1);
  HardCaseTable::add(name, what, expected, got, error, allowed);
  EXPECT_LE(error, allowed) << name << ' ' << what << ": " << got << " for " << expected;
}

/// The largest difference of two pictures, of the brightest pixel.
inline void checkSame(const char* name, const char* what, const RenderedImage& a,
  const RenderedImage& b, double allowed)
{
  const double light =
    largestDifference(a.radiance, b.radiance) / std::max(1e-300, largest(a.radiance));
  check(
    name, what, 0, std::max(light, largestDifference(a.transmittance, b.transmittance)), allowed);
}
} // namespace galaxy

#endif
