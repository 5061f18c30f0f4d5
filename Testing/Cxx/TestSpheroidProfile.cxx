#include "Filters/Model/RadialProfile.h"
#include "Filters/Model/SpheroidPlaces.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <boost/math/special_functions/gamma.hpp>
#include <gtest/gtest.h>

#include <map>

namespace galaxy
{
namespace
{
const std::vector<SpheroidProfile> allProfiles = { SpheroidProfile::Gaussian,
  SpheroidProfile::Sersic, SpheroidProfile::Hernquist, SpheroidProfile::Exponential,
  SpheroidProfile::Plummer, SpheroidProfile::NFW, SpheroidProfile::Cored };

SpheroidDescription described(SpheroidProfile profile)
{
  SpheroidDescription spheroid;
  spheroid.profile = profile;
  spheroid.sigma = { 0.5, 0.5, 0.5 };
  spheroid.effectiveRadius = 0.8;
  spheroid.sersicIndex = 2.5;
  return spheroid;
}

SpheroidDescription sersic(double n)
{
  SpheroidDescription spheroid = described(SpheroidProfile::Sersic);
  spheroid.sersicIndex = n;
  return spheroid;
}

/// Every profile, and the ends of what its numbers may be.
std::vector<SpheroidDescription> manyProfiles()
{
  std::vector<SpheroidDescription> cases = { sersic(0.5), sersic(1), sersic(4), sersic(10) };
  for (const SpheroidProfile kind : allProfiles)
  {
    cases.push_back(described(kind));
  }
  for (const double slope : { 3.1, 20.0 })
  {
    cases.push_back(described(SpheroidProfile::Cored));
    cases.back().slope = slope;
  }
  return cases;
}

/// The integral of s^2 rho(s) from 0 to `end` by the trapezoidal rule in ln s.
double massOf(const std::function<double(double)>& density, double end)
{
  const int steps = 4000;
  const double first = std::log(1e-9), width = (std::log(end) - first) / steps;
  double sum = 0;
  for (int k = 0; k <= steps; ++k)
  {
    const double s = std::exp(first + k * width);
    sum += (k == 0 || k == steps ? 0.5 : 1) * s * s * s * density(s);
  }
  return sum * width;
}

/// Textbook densities, not normalised.
double textbookDensity(const SpheroidDescription& spheroid, double s)
{
  const double n = spheroid.sersicIndex;
  const double b = boost::math::gamma_p_inv(2 * n, 0.5);
  const double p = 1 - 0.6097 / n + 0.05463 / (n * n);
  switch (spheroid.profile)
  {
    case SpheroidProfile::Gaussian:
      return std::exp(-s * s / 2);
    case SpheroidProfile::Sersic:
      return std::pow(s, -p) * std::exp(-b * std::pow(s, 1 / n));
    case SpheroidProfile::Hernquist:
      return 1 / (s * std::pow(1 + s, 3));
    case SpheroidProfile::Exponential:
      return std::exp(-s);
    case SpheroidProfile::Plummer:
      return std::pow(1 + s * s, -2.5);
    case SpheroidProfile::NFW:
      return 1 / (s * std::pow(1 + s, 2));
    default:
      return std::pow(1 + s * s, -spheroid.slope / 2);
  }
}

double textbookMass(const SpheroidDescription& spheroid, double s, double end)
{
  const auto density = [&](double x) { return textbookDensity(spheroid, x); };
  return massOf(density, s) / massOf(density, end);
}

/// The fraction of a round spheroid that is seen within the projected radius R.
double projectedMass(const RadialProfile& profile, double R)
{
  const int shells = 20000;
  double sum = 0;
  for (int k = 0; k < shells; ++k)
  {
    const double s = profile.radius((k + 0.5) / shells);
    sum += s <= R ? 1 : 1 - std::sqrt(1 - R * R / (s * s));
  }
  return sum / shells;
}

double projectedHalfRadius(const RadialProfile& profile)
{
  double low = 1e-3, high = 1e2;
  for (int k = 0; k < 40; ++k)
  {
    const double middle = std::sqrt(low * high);
    (projectedMass(profile, middle) < 0.5 ? low : high) = middle;
  }
  return low;
}

std::vector<double> sampledRadii(const SpheroidDescription& spheroid, std::size_t count)
{
  const TiltedDisk disk(flatDisk(10), m83Distance);
  const SpheroidPlaces places(spheroid, disk, {}, RandomStream::SpheroidPlace);
  std::vector<double> radii;
  for (std::size_t i = 0; i < count; ++i)
  {
    radii.push_back(length(places(i)) / scaleOf(spheroid));
  }
  return radii;
}
} // namespace

TEST(SpheroidProfile, MassIsTheDensitysIntegral)
{
  for (const SpheroidDescription& spheroid : manyProfiles())
  {
    const RadialProfile profile(spheroid);
    const double end = std::min(profile.end(), 1e7);
    for (const double s : { 0.03, 0.3, 1.0, 3.0, 9.0 })
    {
      EXPECT_NEAR(profile.massWithin(s) / textbookMass(spheroid, s, end), 1, 2e-5)
        << "profile " << static_cast<int>(spheroid.profile) << " at " << s;
    }
  }
}

TEST(SpheroidProfile, RadiusIsTheInverseOfTheMass)
{
  for (const SpheroidProfile kind : allProfiles)
  {
    for (const double truncation : { 0.1, 3.0, 500.0, HUGE_VAL })
    {
      SpheroidDescription spheroid = described(kind);
      spheroid.truncation = truncation;
      const RadialProfile profile(spheroid);
      double before = 0;
      for (double logit = -36; logit < 25; logit += 0.0707)
      {
        const double u = 1 / (1 + std::exp(-logit));
        const double s = profile.radius(u);
        EXPECT_GT(s, before);
        before = s;
        EXPECT_NEAR(profile.massWithin(s), u, 5e-9 * u + 1e-14)
          << "profile " << static_cast<int>(kind) << ", truncated at " << truncation;
      }
      EXPECT_LE(profile.radius(1 - 0x1p-53), profile.end());
      EXPECT_LE(profile.radius(1), profile.end());
      EXPECT_GT(profile.radius(0x1p-60), 0);
    }
  }
}

TEST(SpheroidProfile, TableIsAsGoodAsItSays)
{
  for (const SpheroidDescription& spheroid : manyProfiles())
  {
    const RadialProfile profile(spheroid);
    const auto law = radialLaw(spheroid, profile.end());
    const MassSplit kept =
      std::isfinite(profile.end()) ? law->split(profile.end()) : MassSplit{ 1, 0 };
    for (double logit = -30; logit < 20; logit += 0.0313)
    {
      const double u = 1 / (1 + std::exp(-logit));
      const double v = 1 / (1 + std::exp(logit));
      const double exact = law->radius({ u * kept.inside, v + u * kept.outside });
      const double rounding = 10 * 0x1p-53 / v; // of u as the only argument
      EXPECT_NEAR(profile.radius(u) / exact, 1, 1e-8 + rounding)
        << static_cast<int>(spheroid.profile) << " at ln(u/(1-u)) = " << logit;
    }
  }
}

TEST(SpheroidProfile, SamplesFollowTheDensity)
{
  const std::size_t n = 20000;
  for (SpheroidDescription spheroid : manyProfiles())
  {
    for (const double truncation : { HUGE_VAL, 1.3 })
    {
      spheroid.truncation = truncation;
      const RadialProfile profile(spheroid);
      const double distance =
        kolmogorov(sampledRadii(spheroid, n), [&](double s) { return profile.massWithin(s); });
      EXPECT_LT(distance, 1.95) << static_cast<int>(spheroid.profile);
      // Far less than independent numbers give, whose distance is about 0.87.
      EXPECT_LT(distance * std::sqrt(n), 2 + std::log(n)) << static_cast<int>(spheroid.profile);
    }
  }
}

TEST(SpheroidProfile, KnownMasses)
{
  const RadialProfile hernquist(described(SpheroidProfile::Hernquist));
  EXPECT_NEAR(hernquist.radius(0.25), 1, 1e-8);
  EXPECT_NEAR(projectedHalfRadius(hernquist), 1.8153, 2e-4);
  const RadialProfile plummer(described(SpheroidProfile::Plummer));
  EXPECT_NEAR(plummer.massWithin(1), std::pow(2, -1.5), 1e-14);
  EXPECT_NEAR(projectedHalfRadius(plummer), 1, 1e-4);
  const RadialProfile exponential(described(SpheroidProfile::Exponential));
  EXPECT_NEAR(exponential.massWithin(2), 1 - 5 * std::exp(-2), 1e-14);
  const RadialProfile nfw(described(SpheroidProfile::NFW));
  const auto m = [](double s) { return std::log(1 + s) - s / (1 + s); };
  EXPECT_NEAR(nfw.massWithin(3), m(3) / m(10), 1e-14);
  EXPECT_EQ(nfw.massWithin(10), 1);
  // Within a small radius an NFW halo has m = s^2/2, to the last digits.
  EXPECT_NEAR(nfw.massWithin(1e-9) * m(10) / 0.5e-18, 1, 1e-8);
}

// Prugniel and Simien's density is not quite the deprojection: their half-light radii are R_e but
// for these factors, by direct integration of the density.
TEST(SpheroidProfile, SersicHasItsEffectiveRadius)
{
  const std::map<double, double> factors = { { 0.5, 1.0002 }, { 1, 1.0026 }, { 2, 1.0018 },
    { 4, 1.0004 }, { 8, 0.9994 } };
  for (const auto& [n, factor] : factors)
  {
    EXPECT_NEAR(projectedHalfRadius(RadialProfile(sersic(n))), factor, 3e-4) << n;
  }
}

TEST(SpheroidProfile, NothingLiesBeyondTheTruncation)
{
  for (const SpheroidProfile kind : allProfiles)
  {
    SpheroidDescription spheroid = described(kind);
    spheroid.truncation = 1.5 * scaleOf(spheroid);
    const RadialProfile whole(described(kind)), cut(spheroid);
    std::vector<double> radii = sampledRadii(spheroid, 2000);
    EXPECT_LT(*std::max_element(radii.begin(), radii.end()), 1.5 * (1 + 1e-12));
    // What is left keeps its shape.
    EXPECT_NEAR(
      cut.massWithin(0.5) / cut.massWithin(1), whole.massWithin(0.5) / whole.massWithin(1), 1e-12);
    EXPECT_EQ(cut.massWithin(1.5), 1);
  }
  SpheroidDescription halo = described(SpheroidProfile::NFW);
  halo.concentration = 4;
  EXPECT_EQ(RadialProfile(halo).end(), 4);
  halo.truncation = 3;
  EXPECT_EQ(RadialProfile(halo).end(), 3 / halo.scaleRadius) << "kpc, not scale radii";
}

TEST(SpheroidProfile, CentralSurfaceBrightness)
{
  EXPECT_NEAR(
    RadialProfile(described(SpheroidProfile::Gaussian)).surfaceBrightness(), 1 / (2 * pi), 1e-12);
  EXPECT_NEAR(
    RadialProfile(described(SpheroidProfile::Plummer)).surfaceBrightness(), 1 / pi, 1e-12);
  EXPECT_NEAR(RadialProfile(described(SpheroidProfile::Exponential)).surfaceBrightness(),
    1 / (4 * pi), 1e-12);
  // Where the centre has none, the derivative of the projected mass.
  for (const SpheroidProfile kind :
    { SpheroidProfile::Sersic, SpheroidProfile::Hernquist, SpheroidProfile::NFW })
  {
    const RadialProfile profile(described(kind));
    const double R = profile.brightnessRadius();
    const double width = 0.1 * R;
    const double area = pi * (std::pow(R + width, 2) - std::pow(R - width, 2));
    const double light = projectedMass(profile, R + width) - projectedMass(profile, R - width);
    EXPECT_NEAR(profile.surfaceBrightness() / (light / area), 1, 0.01);
  }
  EXPECT_EQ(RadialProfile(sersic(4)).brightnessRadius(), 1);
}
} // namespace galaxy
