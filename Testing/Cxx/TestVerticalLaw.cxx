#include "Filters/Model/ChildLattice.h"
#include "Filters/Model/NormalQuantile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Testing/Cxx/ThicknessFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
const char* const lawNames[] = { "", "Gaussian", "Sech2", "Exponential", "Lorentzian", "Box" };

/// Heights of the law at `count` random shares.
std::vector<double> sample(LayerLaw law, std::size_t count)
{
  std::vector<double> heights;
  Random random({}, RandomStream::ChildPlace, 1);
  Deviates shares{};
  while (heights.size() < count)
  {
    for (double& share : shares)
    {
      share = 2 * random.uniform() - 1;
    }
    sharesToHeights(law, shares);
    heights.insert(heights.end(), shares.begin(), shares.end());
  }
  return heights;
}

/// The density that each law is defined by, up to its normalisation.
double density(LayerLaw law, double z)
{
  switch (law)
  {
    case LayerLaw::Gaussian:
      return std::exp(-z * z / 2);
    case LayerLaw::Sech2:
      return 1 / std::pow(std::cosh(z), 2);
    case LayerLaw::Exponential:
      return std::exp(-std::abs(z));
    case LayerLaw::Lorentzian:
      return std::abs(z) < 10 ? 1 / (1 + z * z) : 0;
    default:
      return std::abs(z) < 1 ? 1 : 0;
  }
}

/// The integral of the density times z^power from 0 to `end`, by the midpoint rule.
double moment(LayerLaw law, double end, int power)
{
  const int steps = 100000;
  double sum = 0;
  for (int k = 0; k < steps; ++k)
  {
    const double z = (k + 0.5) * end / steps;
    sum += density(law, z) * std::pow(z, power);
  }
  return sum * end / steps;
}
} // namespace

TEST(NormalQuantile, LogarithmIsTheLibrarys)
{
  for (int k = 1; k < 200000; ++k)
  {
    const double u = k / 100000.0; // through 1, where the logarithm changes its sign
    ASSERT_NEAR(logarithm(u), std::log(u), 1e-13 * std::abs(std::log(u))) << u;
  }
  for (double u = 1e-300; u < 1e300; u *= 1.7)
  {
    ASSERT_NEAR(logarithm(u) / std::log(u), 1, 1e-13) << u;
  }
}

TEST(NormalQuantile, UndoesTheErrorFunction)
{
  for (double z = 1e-6; z < 6.2; z *= 1.01)
  {
    // From the tail, whose share the library gives to full precision; 2^-53 of 1 is what x lacks.
    const double x = z < 1 ? std::erf(z * std::sqrt(0.5)) : 1 - std::erfc(z * std::sqrt(0.5));
    const double lost = 0x1p-53 * std::sqrt(pi / 2) * std::exp(z * z / 2);
    ASSERT_NEAR(normalQuantile(x), z, 2e-9 * z + lost) << z;
    ASSERT_EQ(normalQuantile(-x), -normalQuantile(x));
  }
  EXPECT_EQ(normalQuantile(0), 0);
  EXPECT_NEAR(normalQuantile(1 - 0x1p-32), 6.3379, 1e-4); // the longest tail of 32 bits
}

TEST(VerticalLaw, HeightsUndoTheShares)
{
  for (const LayerLaw law : layerLaws)
  {
    for (int block = 0; block < 100; ++block)
    {
      Deviates heights{};
      for (int k = 0; k < deviatesAtOnce; ++k)
      {
        heights[k] = (block * deviatesAtOnce + k + 0.5) / 6400 - 1;
      }
      const Deviates shares = heights;
      sharesToHeights(law, heights);
      for (int k = 0; k < deviatesAtOnce; ++k)
      {
        ASSERT_EQ(std::signbit(heights[k]), std::signbit(shares[k]));
        ASSERT_NEAR(shareWithin(law, std::abs(heights[k])), std::abs(shares[k]), 2e-9)
          << lawNames[static_cast<int>(law)];
      }
    }
  }
}

TEST(VerticalLaw, SharesAreTheIntegralOfTheDensity)
{
  for (const LayerLaw law : layerLaws)
  {
    const double whole = moment(law, law == LayerLaw::Box ? 1 : 40, 0);
    for (const double z : { 0.1, 0.7, 0.99, 2.5, 9.9 })
    {
      EXPECT_NEAR(shareWithin(law, z), moment(law, z, 0) / whole, 2e-4)
        << lawNames[static_cast<int>(law)] << z;
    }
    EXPECT_EQ(shareWithin(law, 0), 0);
    EXPECT_EQ(shareWithin(law, std::numeric_limits<double>::infinity()), 1);
    EXPECT_NEAR(rmsHeight(law), std::sqrt(moment(law, 40, 2) / moment(law, 40, 0)), 2e-3);
    // At half the full width the density has fallen to its half, the box to nothing.
    const double half = 0.5 * fwhmHeight(law);
    EXPECT_NEAR(density(law, law == LayerLaw::Box ? 1.001 * half : half),
      law == LayerLaw::Box ? 0 : 0.5, 1e-12);
  }
}

TEST(VerticalLaw, SamplesHaveTheirDistribution)
{
  for (const LayerLaw law : layerLaws)
  {
    const std::vector<double> heights = sample(law, 100000);
    const auto cdf = [law](double z) {
      return 0.5 + std::copysign(0.5 * shareWithin(law, std::abs(z)), z);
    };
    EXPECT_LT(kolmogorov(heights, cdf), 1.95) << lawNames[static_cast<int>(law)];
    double squares = 0, highest = 0;
    for (const double z : heights)
    {
      squares += z * z;
      highest = std::max(highest, std::abs(z));
    }
    EXPECT_NEAR(std::sqrt(squares / heights.size()) / rmsHeight(law), 1, 0.02);
    EXPECT_TRUE(law != LayerLaw::Lorentzian || highest <= 10 * (1 + 1e-12)) << highest;
  }
}

TEST(VerticalLaw, WidthsConvert)
{
  EXPECT_NEAR(fwhmHeight(LayerLaw::Gaussian), 2.3548, 1e-4);
  EXPECT_NEAR(fwhmHeight(LayerLaw::Sech2), 1.7627, 1e-4);
  EXPECT_NEAR(fwhmHeight(LayerLaw::Exponential), 1.3863, 1e-4);
  EXPECT_NEAR(rmsHeight(LayerLaw::Sech2), 0.9069, 1e-4);
  EXPECT_NEAR(rmsHeight(LayerLaw::Exponential), 1.4142, 1e-4);
  EXPECT_NEAR(rmsHeight(LayerLaw::Box), 0.57735, 1e-5);
}

TEST(ChildLattice, EachChildByItselfIsUniform)
{
  std::vector<double> places[3][40];
  for (std::uint32_t seed = 0; seed < 5000; ++seed)
  {
    ChildLattice lattice({}, RandomStream::ChildPlace, seed);
    for (int child = 0; child < 40; ++child)
    {
      const std::array<double, 3> point = lattice.next();
      for (int axis = 0; axis < 3; ++axis)
      {
        places[axis][child].push_back(point[axis]);
      }
    }
  }
  for (const auto& axis : places)
  {
    for (const int child : { 0, 1, 15, 16, 39 })
    {
      EXPECT_LT(kolmogorov(axis[child], [](double x) { return 0.5 + 0.5 * x; }), 1.95) << child;
    }
  }
}

TEST(ChildLattice, ChildrenOfASeedAreLessNoisyThanIndependentOnes)
{
  // The number of a seed's children in a slice of the layer: binomial if they were independent.
  const double low = 0.1, high = 0.4; // 0.15 of the whole layer
  const int seeds = 4000;
  for (const int children : { 12, 100 })
  {
    double squares = 0;
    for (int seed = 0; seed < seeds; ++seed)
    {
      ChildLattice lattice({}, RandomStream::ChildPlace, seed);
      int inside = 0;
      for (int child = 0; child < children; ++child)
      {
        const double z = lattice.next()[2];
        inside += z > low && z < high ? 1 : 0;
      }
      squares += std::pow(inside - 0.15 * children, 2);
    }
    EXPECT_LT(squares / seeds, 0.5 * children * 0.15 * 0.85) << children;
  }
}
} // namespace galaxy
