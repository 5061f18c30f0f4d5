#ifndef galaxy_RingFixtures_h
#define galaxy_RingFixtures_h

#include "Readers/Formats/RingTable.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace galaxy::testing
{
/// 1 kpc is 1 arcsec at this distance in Mpc.
constexpr double arcsecDistance = 0.64800 / 3.14159265358979323846 * 1000;

inline RingOptions atArcsecDistance()
{
  RingOptions options;
  options.distance = arcsecDistance;
  return options;
}

/// The rows of two rings, whatever a test makes of the blanks.
inline std::string twoRows(const std::string& separator = " ")
{
  std::string text;
  for (const char c : std::string("10 100 2 45 80\n20 101 3 46 81\n"))
  {
    text += c == ' ' ? separator : std::string(1, c);
  }
  return text;
}

/// Expects the two rings, lengths times `scale`.
inline void expectTwoRings(
  const std::string& text, const RingOptions& options = {}, double scale = 1, double height = 1)
{
  RingTable table;
  const std::string error = errorOf([&] { table = parseRingTable(text, "some.rings", options); });
  ASSERT_EQ(error, "") << text;
  ASSERT_EQ(table.rings.size(), 2u) << text;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const Ring& ring = table.rings[k];
    const double one = static_cast<double>(k);
    EXPECT_NEAR(ring.radius, scale * (10 + 10 * one), 1e-9 * scale) << text;
    EXPECT_NEAR(ring.rotationVelocity, 100 + one, 1e-9) << text;
    EXPECT_NEAR(ring.scaleHeight, height * scale * (2 + one), 1e-9 * scale) << text;
    EXPECT_NEAR(ring.inclination, 45 + one, 1e-9) << text;
    EXPECT_NEAR(ring.positionAngle, 80 + one, 1e-9) << text;
  }
}

inline std::string refusalOf(const std::string& text, const RingOptions& options = {})
{
  return errorOf([&] { parseRingTable(text, "some.rings", options); });
}

/// Expects an Error whose message holds the words.
inline void expectRefusal(
  const std::string& text, const std::string& words, const RingOptions& options = {})
{
  const std::string message = refusalOf(text, options);
  EXPECT_NE(message.find(words), std::string::npos) << text << "gave: " << message;
}
} // namespace galaxy::testing

#endif
