#include "Filters/Model/ScaleBar.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace galaxy;

TEST(ScaleBar, IsTheLongestRoundLength)
{
  for (double most = 1e-4; most < 1e5; most *= 1.07)
  {
    const ScaleBar bar = scaleBar(most, 0);
    EXPECT_LE(bar.length, most);
    EXPECT_GT(bar.length, most / 2.5 - 1e-12);
    const double power = std::pow(10, std::round(std::log10(bar.length) - 0.35));
    const double digit = bar.length / power;
    const double nearest = std::min({ std::abs(digit - 1), std::abs(digit - 2), std::abs(digit - 5),
      std::abs(digit - 0.5), std::abs(digit - 10) });
    EXPECT_LT(nearest, 1e-9) << bar.length;
  }
}

TEST(ScaleBar, LabelsHaveTheirUnits)
{
  EXPECT_EQ(lengthText(5), "5 kpc");
  EXPECT_EQ(lengthText(0.2), "200 pc");
  EXPECT_EQ(lengthText(2000), "2 Mpc");
  EXPECT_EQ(lengthText(0.99999), "1 kpc");
  EXPECT_EQ(lengthText(0.0004), "0.4 pc");
  EXPECT_EQ(angleText(M_PI / 180), "1°");
  EXPECT_EQ(angleText(M_PI / 180 / 60 * 12.34), "12.3'");
  EXPECT_EQ(angleText(M_PI / 180 / 3600 * 30), "30\"");
  // 5 kpc at 4.5 Mpc.
  EXPECT_EQ(scaleBar(7, 4500).label, "5 kpc = 3.82'");
  EXPECT_EQ(scaleBar(7, 0).label, "5 kpc");
}

TEST(ScaleBar, IsNoneWhereThereIsNoSize)
{
  for (const double most : { 0.0, -1.0, std::nan(""), double(INFINITY) })
  {
    EXPECT_EQ(scaleBar(most, 1).length, 0);
  }
}
} // namespace
