#include "Filters/Model/FractalNoise.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace galaxy
{
namespace
{
struct Moments
{
  double mean = 0;
  double variance = 0;
};

template <class Sample>
Moments momentsOf(int n, const Sample& sample)
{
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i)
  {
    const double x = sample(i);
    sum += x;
    squares += x * x;
  }
  return { sum / n, squares / n - sum / n * sum / n };
}

/// A place far from any other of the sequence.
Vec3 somewhere(int i)
{
  Random random({ 99, 0 }, RandomStream::SeedPlace, i);
  return { 1e4 * random.uniform() - 5e3, 1e4 * random.uniform(), 1e4 * random.uniform() };
}

DustDescription clouds(FractalKind kind)
{
  DustDescription dust;
  dust.model = DustModel::Fractal;
  dust.noise = kind;
  return dust;
}

double weightAt(const FractalClouds& clouds, const Vec3& p)
{
  const double r = std::hypot(p.x, p.y);
  return clouds.weight(r, p.x / r, p.y / r, p.z);
}
} // namespace

TEST(FractalNoise, HasUnitVarianceOverSpace)
{
  for (const FractalKind kind : { FractalKind::FBm, FractalKind::Ridged })
  {
    const FractalNoise noise(clouds(kind), {});
    const Moments over = momentsOf(100000, [&](int i) { return noise(somewhere(i)); });
    EXPECT_NEAR(over.mean, 0, 0.012) << int(kind);
    EXPECT_NEAR(over.variance, 1, 0.02) << int(kind);
  }
}

TEST(FractalNoise, IsNormalAtEveryPlace)
{
  // Also where a lattice has its points and where it has the middles of its cells.
  for (const Vec3& p : { Vec3{ 0, 0, 0 }, Vec3{ 0.25, -0.1, 3 }, Vec3{ -7.5, 2.125, 0.01 } })
  {
    for (const int octaves : { 1, 5 })
    {
      DustDescription dust = clouds(FractalKind::FBm);
      dust.octaves = octaves;
      std::vector<double> values;
      for (std::uint64_t seed = 0; seed < 4000; ++seed)
      {
        values.push_back(FractalNoise(dust, { seed, 0 })(p));
      }
      const auto normal = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
      EXPECT_LT(kolmogorov(values, normal), 1.95);
    }
  }
}

TEST(FractalNoise, IsAContinuousFunctionOfKeyAndPlace)
{
  const DustDescription dust = clouds(FractalKind::FBm);
  const FractalNoise noise(dust, { 7, 2 });
  const FractalNoise same(dust, { 7, 2 });
  const FractalNoise other(dust, { 8, 2 }), component(dust, { 7, 3 });
  double product = 0;
  for (int i = 0; i < 5000; ++i)
  {
    const Vec3 p = somewhere(i);
    EXPECT_EQ(noise(p), same(p));
    product += noise(p) * other(p) + noise(p) * component(p);
    EXPECT_NEAR(noise(p + Vec3{ 1e-7, -1e-7, 1e-7 }), noise(p), 1e-4);
  }
  EXPECT_NEAR(product / 10000, 0, 0.05) << "keys are independent";
}

TEST(FractalNoise, MoreOctavesLeaveTheShapeOfTheOthers)
{
  // With H = 0 an octave's amplitude is 1 over the root of their number.
  DustDescription dust = clouds(FractalKind::FBm);
  dust.hurst = 0;
  std::vector<FractalNoise> sums;
  for (int octaves = 1; octaves <= 3; ++octaves)
  {
    dust.octaves = octaves;
    sums.emplace_back(dust, RandomKey{ 7, 2 });
  }
  // sqrt(n) times each is a sum of n octaves: what is added must be as good as independent.
  double first = 0, second = 0;
  const int n = 5000;
  for (int i = 0; i < n; ++i)
  {
    const Vec3 p = somewhere(i);
    const double one = sums[0](p), two = std::sqrt(2) * sums[1](p) - one;
    first += one * two / n;
    second += two * (std::sqrt(3) * sums[2](p) - std::sqrt(2) * sums[1](p)) / n;
  }
  EXPECT_NEAR(first, 0, 0.06);
  EXPECT_NEAR(second, 0, 0.06);
}

TEST(FractalNoise, HasTheTailsOfNormalDeviates)
{
  DustDescription dust = clouds(FractalKind::FBm);
  dust.octaves = 1;
  const FractalNoise noise(dust, {});
  // Beyond 4 sigma, where exp(s g) of a large contrast has its mean: 127 of 2e6, 4 sigma of that.
  const int n = 2000000;
  int beyond = 0;
  for (int i = 0; i < n; ++i)
  {
    beyond += std::abs(noise(somewhere(i))) > 4 ? 1 : 0;
  }
  const double expected = n * std::erfc(4 / std::sqrt(2.0));
  EXPECT_NEAR(beyond, expected, 4 * std::sqrt(expected));
}

TEST(FractalNoise, HasNoPeriod)
{
  DustDescription dust = clouds(FractalKind::FBm);
  dust.octaves = 1;
  dust.noiseScale = 1;
  const FractalNoise noise(dust, {});
  for (const double period : { 16.0, 256.0, 4096.0, 65536.0 })
  {
    double product = 0;
    for (int i = 0; i < 5000; ++i)
    {
      const Vec3 p = somewhere(i);
      product += noise(p) * noise(p + Vec3{ period, 0, 0 });
    }
    EXPECT_NEAR(product / 5000, 0, 0.06) << period;
  }
}

TEST(FractalNoise, StructureGrowsWithDistanceUpToTheLargestScale)
{
  DustDescription dust = clouds(FractalKind::FBm);
  dust.octaves = 8;
  const FractalNoise noise(dust, {});
  const auto difference = [&](double d) {
    const double step = d * dust.noiseScale;
    return momentsOf(20000, [&](int i) {
      return noise(somewhere(i) + Vec3{ step, 0, 0 }) - noise(somewhere(i));
    }).variance;
  };
  // Independent from a few scales on; below, the variance of a difference goes as d^(2H).
  EXPECT_NEAR(difference(5), 2, 0.1);
  const double slope = std::log(difference(0.25) / difference(0.03125)) / std::log(8);
  EXPECT_NEAR(slope, 2 * dust.hurst, 0.15);
}

TEST(FractalClouds, HaveTheMeanAndVarianceOfALognormal)
{
  for (const double s : { 0.0, 0.5, 1.0 })
  {
    DustDescription dust = clouds(FractalKind::FBm);
    dust.contrast = s;
    const FractalClouds density(dust, {});
    const Moments over = momentsOf(200000, [&](int i) { return weightAt(density, somewhere(i)); });
    EXPECT_NEAR(over.mean, 1, 0.015 * s + 1e-12) << s;
    EXPECT_NEAR(over.variance, std::expm1(s * s), 0.07 * s * std::expm1(s * s) + 1e-12) << s;
  }
}

TEST(FractalClouds, RidgesHaveMeanOneToo)
{
  for (const double s : { 0.5, 1.0, 2.0 })
  {
    DustDescription dust = clouds(FractalKind::Ridged);
    dust.contrast = s;
    const FractalClouds density(dust, {});
    const Moments over = momentsOf(100000, [&](int i) { return weightAt(density, somewhere(i)); });
    EXPECT_NEAR(over.mean, 1, 0.02) << s;
    EXPECT_GT(over.variance, 0.1 * s * s);
  }
}

TEST(FractalClouds, ClumpingLetsLightThrough)
{
  const FractalClouds density(clouds(FractalKind::FBm), {});
  const auto effective = [&](double tau) {
    return -std::log(momentsOf(200000, [&](int i) {
      return std::exp(-tau * weightAt(density, somewhere(i)));
    }).mean);
  };
  EXPECT_NEAR(effective(1), 0.67, 0.01);
  EXPECT_NEAR(effective(3), 1.44, 0.02);
}

TEST(FractalClouds, WindingTrailsTheRotation)
{
  DustDescription dust = clouds(FractalKind::FBm);
  dust.winding = 3;
  dust.noiseScale = 0.5;
  dust.octaves = 1;
  const FractalClouds density(dust, {});
  // Squared differences over a step outward that winds by `turn` radians per e-fold of radius.
  const auto along = [&](double turn) {
    return momentsOf(20000, [&](int i) {
      const Vec3 p = somewhere(i);
      const double r = 50 + std::abs(p.x) / 100, theta = p.y, step = 0.05;
      const double after = theta + turn * std::log1p(step / r);
      return std::log(density.weight(r + step, std::cos(after), std::sin(after), p.z) /
        density.weight(r, std::cos(theta), std::sin(theta), p.z));
    }).variance;
  };
  // Rotation is toward larger azimuth: what trails lags outward.
  EXPECT_LT(along(-3), 0.2 * along(0));
  EXPECT_GT(along(3), 2 * along(0));
}
} // namespace galaxy
