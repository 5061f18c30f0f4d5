#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/GaussianKernel.h"
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

TEST(OpticalModel, GaussianSharesAreTheIntegralOfTheKernel)
{
  // exp(-s^2) - exp(-9) from -3 to 3, by Simpson's rule.
  const auto integral = [](double from, double to) {
    constexpr int n = 200;
    const double step = (to - from) / n;
    double sum = 0;
    for (int k = 0; k <= n; ++k)
    {
      const double s = from + k * step;
      sum += (k % n == 0 ? 1 : k % 2 ? 4 : 2) * (std::exp(-s * s) - std::exp(-9.0));
    }
    return sum * step / 3;
  };
  const double all = integral(-3, 3);
  for (double s = -3; s <= 3; s += 0.1)
  {
    EXPECT_NEAR(gaussianCumulative(s), integral(0, s) / all, 1e-8) << s;
  }
  EXPECT_EQ(gaussianCumulative(3), 0.5);
  EXPECT_EQ(gaussianCumulative(1e30), 0.5);
  EXPECT_EQ(gaussianCumulative(-1e30), -0.5);
}

TEST(OpticalModel, GaussianPolynomialIsAccurate)
{
  const double end = GaussianPolynomial::end;
  for (double u = 0; u <= end; u += 0.003)
  {
    double sum = 0;
    for (int k = GaussianPolynomial::degree; k >= 0; --k)
    {
      sum = sum * (2 * u * u / (end * end) - 1) + gaussianPolynomial.coefficients[k];
    }
    EXPECT_NEAR(u * sum, gaussianCumulative(u), 2e-7) << u;
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
