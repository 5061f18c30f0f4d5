#include "Filters/Splatting/ToneMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using namespace galaxy;

std::vector<float> mapped(const ToneMap& map, std::vector<float> light)
{
  std::vector<float> display(light.size());
  applyToneMap(map, light.data(), display.data(), light.size() / 3);
  return display;
}

TEST(ToneMap, GreyFollowsTheAsinhFormula)
{
  for (const double Q : { 0.01, 1.0, 10.0, 1000.0 })
  {
    for (const float x : { 0.0f, 1e-6f, 0.01f, 0.3f, 1.0f })
    {
      const float y = mapped({ 1, Q, 1 }, { x, x, x })[1];
      EXPECT_NEAR(y, std::asinh(Q * x) / std::asinh(Q), 1e-7);
    }
  }
}

TEST(ToneMap, NoStretchIsLinear)
{
  const auto y = mapped({ 2, 0, 1 }, { 0.1f, 0.2f, 0.3f });
  EXPECT_FLOAT_EQ(y[0], 0.2f);
  EXPECT_FLOAT_EQ(y[1], 0.4f);
  EXPECT_FLOAT_EQ(y[2], 0.6f);
}

TEST(ToneMap, SmallStretchTendsToLinear)
{
  EXPECT_NEAR(mapped({ 1, 1e-3, 1 }, { 0.1f, 0.2f, 0.3f })[2], 0.3f, 1e-6);
}

TEST(ToneMap, KeepsTheHueEvenWhenTooBright)
{
  for (const float brightness : { 1e-4f, 0.1f, 1.0f, 50.0f, 1e30f })
  {
    const auto y = mapped({ 1, 10, 1 }, { 0.5f * brightness, brightness, 0.25f * brightness });
    EXPECT_NEAR(y[0] / y[1], 0.5, 1e-5) << brightness;
    EXPECT_NEAR(y[2] / y[1], 0.25, 1e-5) << brightness;
    EXPECT_LE(y[1], 1.0f);
  }
}

TEST(ToneMap, BrighterLightIsNeverDarker)
{
  float last = -1;
  for (double x = 1e-8; x < 1e8; x *= 1.1)
  {
    const float y = mapped({ 1, 10, 2.2 }, { float(0.3 * x), float(x), float(0.9 * x) })[1];
    EXPECT_GE(y, last);
    last = y;
  }
  EXPECT_EQ(last, 1.0f);
}

TEST(ToneMap, GammaIsAPowerOfTheStretchedValue)
{
  const float linear = mapped({ 1, 10, 1 }, { 0.2f, 0.2f, 0.2f })[0];
  const float display = mapped({ 1, 10, 2.2 }, { 0.2f, 0.2f, 0.2f })[0];
  EXPECT_NEAR(display, std::pow(linear, 1 / 2.2), 1e-7);
}

TEST(ToneMap, BlackAndWhitePointsAreOfEachChannel)
{
  ToneMap map{ 2, 0, 1 };
  map.black = { 0.1, 0, -0.2 };
  map.white = { 0.5, 2, 0.8 };
  const auto y = mapped(map, { 0.15f, 0.5f, 0.1f, 0.05f, 0.0f, 0.0f, 0.25f, 1.0f, 0.4f });
  const float expected[] = { 0.5f, 0.5f, 0.4f, 0, 0, 0.2f, 1, 1, 1 };
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(y[i], expected[i], 1e-6) << i;
  }
}

TEST(ToneMap, WhitePointsAreAnExposureOfEachChannel)
{
  ToneMap map{ 1, 10, 2.2 };
  map.white = { 0.5, 0.25, 2 };
  const auto y = mapped(map, { 0.1f, 0.1f, 0.1f });
  const auto same = mapped({ 1, 10, 2.2 }, { 0.2f, 0.4f, 0.05f });
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_FLOAT_EQ(y[c], same[c]);
  }
}

TEST(ToneMap, BlackPointsDarkenTheErrorToo)
{
  const ErrorBound plain = allowedError({ 1, 10, 1 }, 0.01);
  ToneMap map{ 1, 10, 1 };
  map.black = { 0, 0.5, 0 };
  const ErrorBound raised = allowedError(map, 0.01);
  EXPECT_LT(raised.light, plain.light / 3.9); // twice as steep, and half of it for the share
  EXPECT_LT(raised.share, plain.share);
  map.black = { 0, -0.5, 0 }; // lifts: nothing is nearer to black than its light
  EXPECT_EQ(allowedError(map, 0.01).share, plain.share);
  EXPECT_EQ(allowedError(map, 0.01).light, plain.light);
}

TEST(ToneMap, BadLightIsBlackAndInfiniteLightIsWhite)
{
  const float inf = std::numeric_limits<float>::infinity();
  const auto y = mapped({ 1, 10, 1 }, { NAN, -1, -inf, 0, 0, 0, inf, inf, inf });
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(y[i], 0.0f);
  }
  for (int i = 6; i < 9; ++i)
  {
    EXPECT_FLOAT_EQ(y[i], 1.0f);
  }
}
} // namespace
