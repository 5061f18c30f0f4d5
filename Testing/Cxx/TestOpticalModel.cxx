#include "Filters/Splatting/Footprint.h"
#include "Filters/Splatting/OpticalModel.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

long double exactEscape(long double t)
{
  return t == 0 ? 1 : -std::expm1(-t) / t;
}

/// 0, then 1e-38 to 1e3 in steps fine enough to find a threshold.
template <typename Check>
void forOpticalDepths(Check check)
{
  check(0.0f);
  for (double t = 1e-38; t < 1e3; t *= t < 1e-3 || t > 4 ? 1.31 : 1.0007)
  {
    check(static_cast<float>(t));
  }
  check(1e3f);
  check(std::nextafter(0.5f, 0.0f));
  check(0.5f);
}

TEST(OpticalModel, EscapeFractionIsAccurateEverywhere)
{
  forOpticalDepths([](float t) {
    const long double exact = exactEscape(t);
    EXPECT_NEAR(escapeFraction(t) / exact, 1, 2e-7) << t;
    EXPECT_NEAR(escapeFraction(double(t)) / exact, 1, 4e-16) << t;
  });
}

TEST(OpticalModel, SlabTendsToItsSourceFunction)
{
  EXPECT_FLOAT_EQ(throughSlab(1e6f, 50 * 3.0f, 50.0f), 3.0f);
  EXPECT_EQ(throughSlab(1.0f, 0.0f, 1e3f), 0.0f);
  EXPECT_EQ(throughSlab(7.0f, 2.0f, 0.0f), 9.0f);
}

TEST(OpticalModel, TwoHalvesMakeOneSlab)
{
  for (const double t : { 1e-9, 1e-3, 0.7, 5.0 })
  {
    const double twice = throughSlab(throughSlab(2.0, 0.5, t / 2), 0.5, t / 2);
    EXPECT_NEAR(twice, throughSlab(2.0, 1.0, t), 1e-15 * 4);
  }
}

GALAXY_CLONES void slabLanesOf(const float* t, float* escape, float* base, float* change)
{
  const SlabLanes slab = slabLanes(loadLanes(t));
  storeLanes(escape, slab.escape);
  storeLanes(base, slab.base);
  storeLanes(change, slab.change);
}

TEST(OpticalModel, VectorSlabIsAccurateEverywhere)
{
  forOpticalDepths([](float t) {
    float ts[laneCount], escape[laneCount], base[laneCount], change[laneCount];
    std::fill_n(ts, laneCount, t);
    slabLanesOf(ts, escape, base, change);
    EXPECT_NEAR(escape[3] / exactEscape(t), 1, 2e-7) << t;
    // What is taken away is as accurate as what is kept: 1e7 slabs of 1e-8 add up.
    const double kept = double(base[3]) + change[3];
    if (t < 80)
    {
      EXPECT_NEAR(kept / std::exp(-double(t)), 1, 3e-7) << t;
    }
    if (t > 0 && t < 0.4)
    {
      EXPECT_NEAR(-double(change[3]) / -std::expm1(-double(t)), 1, 3e-7) << t;
    }
  });
}

GALAXY_CLONES void erfOf(const float* u, float* result)
{
  storeLanes(result, erfPolynomial(loadLanes(u)));
}

TEST(OpticalModel, VectorErfIsAccurateAndOdd)
{
  for (float u = 0; u < 6; u += 0.003f)
  {
    float us[laneCount] = { u, -u };
    float result[laneCount];
    erfOf(us, result);
    EXPECT_NEAR(result[0], std::erf(u), 2e-7) << u;
    EXPECT_EQ(result[0], -result[1]);
  }
}

TEST(OpticalModel, ProjectedSplineIsTheIntegralOfTheSpline)
{
  const auto spline = [](double q) {
    return 8 / M_PI * (q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * std::pow(2 - q, 3));
  };
  for (const double b : { 0.0, 0.1, 0.37, 0.5, 0.77, 0.99 })
  {
    const double half = std::sqrt(1 - b * b);
    const int n = 20000;
    double sum = 0;
    for (int k = 0; k < n; ++k)
    {
      const double z = half * (k + 0.5) / n;
      sum += spline(2 * std::sqrt(b * b + z * z));
    }
    EXPECT_NEAR(projectedCubicSpline(b), 2 * sum * half / n, 1e-7);
  }
}

TEST(OpticalModel, SplineTableIsNeverNegativeAndEndsAtTheSupport)
{
  const CubicSplineTable table;
  const double center = projectedCubicSpline(0);
  for (double b = 0; b < 1.01; b += 1e-4)
  {
    const float value = table(static_cast<float>(b * b));
    EXPECT_GE(value, 0);
    EXPECT_NEAR(value, projectedCubicSpline(b), 1e-5 * center) << b;
  }
  EXPECT_EQ(table(1.0f), 0);
  EXPECT_EQ(table(NAN), 0);
}
} // namespace
