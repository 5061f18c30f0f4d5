#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Testing/Cxx/ThicknessFixtures.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
/// A rotation that rises with radius on a disc of one plane.
RingTable risingRotation()
{
  RingTable table;
  table.rings = { ring(0, 120, 10, 30, 0), ring(40 / m83Kpc, 250, 30, 30, 0) };
  return table;
}

/// The full width at half maximum of heights, from the half of them that lie nearest.
double widthOf(std::vector<double> heights, LayerLaw law)
{
  for (double& z : heights)
  {
    z = std::abs(z);
  }
  std::nth_element(heights.begin(), heights.begin() + heights.size() / 2, heights.end());
  Deviates half{};
  half[0] = 0.5;
  sharesToHeights(law, half);
  return heights[heights.size() / 2] / half[0] * fwhmHeight(law);
}

/// The full width at half maximum, kpc, that the models have by their formulas in risingRotation
/// with a scale length of 20 kpc, sigma = 0.3 kpc, a tapered thickness and otherwise defaults.
double modelWidth(ThicknessModel model, LayerLaw law, double r)
{
  const double v = 120 + 130 * r / 40;
  switch (model)
  {
    case ThicknessModel::Tapered:
      return 0.34 * std::exp(-r / 20) * fwhmHeight(law);
    case ThicknessModel::Flared:
      return 189.0 / 250 * (r <= 10 ? 0.3 + 0.05 * r : 0.8 * std::exp((r - 10) / 17.4));
    case ThicknessModel::Hydrostatic: {
      const double G = 4.30091e-6; // kpc (km/s)^2/Msun
      const double B = 4 * pi * G * 10e6 / std::sqrt(2 * pi);
      const double stars = 4 * pi * G * 500e6 * std::exp(-r / 20) / (2 * 0.34);
      const double halo = v * v / (r * r + 0.01);
      return 2.35482 * 2 * 64 / (B + std::sqrt(B * B + 4 * (halo + stars) * 64));
    }
    case ThicknessModel::Rings:
      return (10 + 20 * r / 40) * m83Kpc * fwhmHeight(law);
    default:
      return 0.3 * 2.35482;
  }
}

double normalShare(double z)
{
  return 0.5 * std::erfc(-z * std::sqrt(0.5));
}

/// The seeds from `first` up to `last`.
Seeds part(const Seeds& seeds, std::size_t first, std::size_t last)
{
  Seeds out = seedsAt(std::vector<double>(last - first));
  for (std::size_t i = first; i < last; ++i)
  {
    out.radius[i - first] = seeds.radius[i];
    out.azimuth[i - first] = seeds.azimuth[i];
    out.light[i - first] = seeds.light[i];
    out.index[i - first] = seeds.index[i];
    std::copy_n(&seeds.color[3 * i], 3, &out.color[3 * (i - first)]);
  }
  return out;
}

/// A component that uses every kind of random number.
ComponentDescription busyLayer()
{
  ComponentDescription component = verticalLayer(ThicknessModel::Tapered, 40);
  component.thickness.sigma = 0.1;
  component.thickness.scaleLength = 5;
  component.thickness.law = LayerLaw::Sech2;
  component.velocityDispersion = 9;
  return component;
}
} // namespace

TEST(Thickness, WidthsOfEveryModelAreRecoveredFromTheParticles)
{
  for (const ThicknessModel model : { ThicknessModel::Gaussian, ThicknessModel::Tapered,
         ThicknessModel::Flared, ThicknessModel::Hydrostatic, ThicknessModel::Rings })
  {
    for (const LayerLaw law : layerLaws)
    {
      RingTable rings = risingRotation();
      rings.layerLaw = law;
      ComponentDescription component = verticalLayer(model, 100);
      component.thickness.law = law;
      component.thickness.scaleLength = 20;
      component.thickness.taperThickness = true;
      component.thickness.sigma = model == ThicknessModel::Gaussian ? 0.3 : 0;
      const LayerLaw applied = model == ThicknessModel::Gaussian ? LayerLaw::Gaussian : law;
      for (const double r : { 2.0, 9.0, 15.0, 30.0 })
      {
        const ThickDisk thick(rings, component, seedsAt(std::vector<double>(100, r)));
        EXPECT_NEAR(widthOf(thick.heights(), applied) / modelWidth(model, law, r), 1, 0.02)
          << static_cast<int>(model) << ' ' << static_cast<int>(law) << ' ' << r;
      }
    }
  }
}

TEST(Thickness, HeightsStandOnTheWarpedPlane)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Tapered, 5);
  component.thickness.scaleLength = 1e9;
  component.thickness.law = LayerLaw::Exponential;
  component.thickness.scaleHeight = 0.5;
  const ThickDisk thick(m83Rings(), component, seedsWithin(50, 10000));
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    const Vec3 n = thick.disk.frame(thick.seeds.radius[i]).n;
    for (std::uint64_t k = thick.starts[i]; k < thick.starts[i + 1]; ++k)
    {
      ASSERT_LT(length(cross(thick.way(i, k), n)), 1e-5);
    }
  }
  const auto cdf = [](double z) { return z < 0 ? 0.5 * std::exp(z) : 1 - 0.5 * std::exp(-z); };
  EXPECT_LT(kolmogorov(thick.heights(0.5), cdf), 1.95);
}

TEST(Thickness, GaussianModelIsIsotropic)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Gaussian, 10);
  component.thickness.sigma = 0.4;
  component.thickness.law = LayerLaw::Box;
  const ThickDisk thick(flatDisk(10, 50, 20), component, seedsWithin(10, 20000));
  std::vector<double> axes[3];
  double xz = 0;
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    for (std::uint64_t k = thick.starts[i]; k < thick.starts[i + 1]; ++k)
    {
      const Vec3 d = (1 / 0.4) * thick.way(i, k);
      axes[0].push_back(d.x);
      axes[1].push_back(d.y);
      axes[2].push_back(d.z);
      xz += d.x * d.z;
    }
  }
  EXPECT_NEAR(xz / axes[0].size(), 0, 0.007);
  for (const std::vector<double>& axis : axes)
  {
    EXPECT_LT(kolmogorov(axis, normalShare), 1.95);
  }
}

TEST(Thickness, TaperedChildrenSpreadBySigmaInThePlaneAndByTheScaleHeightAcross)
{
  for (const TaperReading reading : { TaperReading::RadialScale, TaperReading::Literal })
  {
    ComponentDescription component = verticalLayer(ThicknessModel::Tapered, 10);
    component.thickness.sigma = 0.4;
    component.thickness.scaleHeight = 2;
    component.thickness.scaleLength = 2;
    component.thickness.reading = reading;
    const ThickDisk thick(flatDisk(10), component, seedsWithin(10, 20000));
    std::vector<double> inPlane;
    for (std::size_t i = 0; i < thick.seeds.size(); ++i)
    {
      for (std::uint64_t k = thick.starts[i]; k < thick.starts[i + 1]; ++k)
      {
        inPlane.push_back(thick.way(i, k).x / 0.4);
      }
    }
    EXPECT_LT(kolmogorov(inPlane, normalShare), 1.95);
    EXPECT_LT(kolmogorov(thick.heights(2), normalShare), 1.95);
  }
}

TEST(Thickness, ChildrenStayOnAWarpedDiscAndBesideTheirSeeds)
{
  // Without a height, children lie on their own rings' planes.
  RingTable steep;
  steep.rings = { ring(0, 100, 0, 10, 10), ring(100, 100, 0, 50, 130),
    ring(100.01, 100, 0, 80, 190), ring(200, 100, 0, 60, 200) };
  for (const RingTable& rings : { m83Rings(), steep })
  {
    ComponentDescription component = verticalLayer(ThicknessModel::Gaussian, 5);
    component.thickness.model = ThicknessModel::Tapered;
    component.thickness.scaleLength = 1e9;
    component.thickness.scaleHeight = 1e-9;
    component.thickness.sigma = 0.2;
    const ThickDisk thick(rings, component, seedsWithin(4.7, 4000));
    for (std::size_t i = 0; i < thick.seeds.size(); ++i)
    {
      const double r = thick.seeds.radius[i];
      const Vec3 n = thick.disk.frame(r).n;
      for (std::uint64_t k = thick.starts[i]; k < thick.starts[i + 1]; ++k)
      {
        const Vec3 p = thick.position(k);
        const Vec3 own = thick.disk.frame(length(p)).n;
        // As far as float knows the radius: where the disc is steepest that turns the plane.
        const Vec3 other = thick.disk.frame(length(p) * (1 + 1e-6)).n;
        ASSERT_LT(std::abs(dot(p, own)), 2e-6 + 2 * length(p) * length(other - own)) << r;
        // In the seed's plane at most 6.3 sigma away on either axis, and then turned.
        ASSERT_LT(length(thick.way(i, k)), 1.8 + length(p) * length(own - n)) << r;
      }
    }
  }
}

TEST(Thickness, ChildrenShareTheirSeedsLight)
{
  for (const ThicknessModel model : { ThicknessModel::Gaussian, ThicknessModel::Tapered,
         ThicknessModel::Flared, ThicknessModel::Hydrostatic, ThicknessModel::Rings })
  {
    ComponentDescription component = verticalLayer(model, 7.3);
    component.thickness.maximumChildren = 7;
    const ThickDisk thick(m83Rings(), component, seedsWithin(50, 5000));
    for (std::size_t i = 0; i < thick.seeds.size(); ++i)
    {
      const std::uint64_t first = thick.starts[i], last = thick.starts[i + 1];
      ASSERT_GE(last, first + 1);
      ASSERT_LE(last, first + 7);
      const float* lights = thick.particles.intensity.data();
      ASSERT_NEAR(
        std::accumulate(lights + first, lights + last, 0.0) / thick.seeds.light[i], 1, 1e-6);
      for (std::uint64_t k = first; k < last; ++k)
      {
        ASSERT_EQ(std::memcmp(&thick.particles.color[3 * k], &thick.seeds.color[3 * i], 3), 0);
      }
    }
  }
}

TEST(Thickness, ChildrenThatInheritHaveAllTheSeedsLight)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Flared, 5);
  component.thickness.childLight = ChildLight::Inherit;
  const ThickDisk thick(flatDisk(10), component, seedsWithin(10, 100));
  for (std::size_t k = 0; k < thick.particles.size(); ++k)
  {
    ASSERT_EQ(thick.particles.intensity[k], thick.seeds.light[k / 5]);
  }
}

TEST(Thickness, AnyNumberOfChildrenKeepsTheLight)
{
  const double children[][2] = { { 0, 1 }, { 1e-30, 1 }, { 1e30, 50 } };
  for (const auto& [mean, made] : children)
  {
    ComponentDescription component = verticalLayer(ThicknessModel::Flared, mean);
    component.thickness.maximumChildren = 50;
    const ThickDisk thick(flatDisk(10), component, seedsWithin(10, 100));
    EXPECT_EQ(thick.particles.size(), 100 * made);
    const double light = std::accumulate(thick.seeds.light.begin(), thick.seeds.light.end(), 0.0);
    EXPECT_NEAR(
      std::accumulate(thick.particles.intensity.begin(), thick.particles.intensity.end(), 0.0) /
        light,
      1, 1e-6);
  }
}

TEST(Thickness, ChildCountsKeepTheirMean)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Gaussian, 12);
  component.thickness.compression = 0.4;
  Seeds seeds = seedsWithin(5, 40000);
  double expected = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    seeds.intensity[i] = std::exp(-seeds.radius[i] / 3);
    expected += 12 * std::pow(seeds.intensity[i], 0.6);
  }
  const ThickDisk thick(flatDisk(20), component, std::move(seeds));
  EXPECT_NEAR(thick.particles.size() / expected, 1, 0.001);
}

TEST(Thickness, LayersEndBelowTheFocusOfNormals)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 0, 0), ring(100, 100, 1, 80, 0) };
  for (const LayerLaw law : layerLaws)
  {
    ComponentDescription component = verticalLayer(ThicknessModel::Tapered, 20);
    component.thickness.law = law;
    component.thickness.scaleLength = 1e9;
    component.thickness.scaleHeight = 1.5;
    const ThickDisk thick(table, component, seedsAt(std::vector<double>(2000, 1)));
    const double highest = normalFocalHeight(thick.disk.frame(1)) / 1.5;
    const double below = shareWithin(law, highest);
    ASSERT_LT(below, 0.999);
    // What is left of the law is distributed as before: nothing piles up at the end.
    const auto cdf = [&](double z) {
      const double share = shareWithin(law, std::min(highest, std::abs(z))) / below;
      return 0.5 + std::copysign(0.5 * share, z);
    };
    const std::vector<double> heights = thick.heights(1.5);
    EXPECT_LT(kolmogorov(heights, cdf), 1.95) << static_cast<int>(law);
    EXPECT_LE(*std::max_element(heights.begin(), heights.end()), highest * (1 + 1e-6));
  }
}

TEST(Thickness, ZeroThicknessIsExactlyPlanar)
{
  RingTable table = flatDisk(10);
  table.rings[0].scaleHeight = 0;
  for (const LayerLaw law : layerLaws)
  {
    table.layerLaw = law;
    ComponentDescription component = verticalLayer(ThicknessModel::Rings, 3);
    component.thickness.sigma = 0.1;
    const ThickDisk thick(table, component, seedsWithin(10, 500));
    for (std::size_t k = 0; k < thick.particles.size(); ++k)
    {
      ASSERT_EQ(thick.position(k).z, 0);
    }
  }
}

TEST(Thickness, ParticlesAreTheSameForAnyNumberOfThreads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const ThickDisk one(m83Rings(), busyLayer(), seedsWithin(20, 5000));
  for (const int threads : { 2, 16 })
  {
    omp_set_num_threads(threads);
    const ThickDisk many(m83Rings(), busyLayer(), seedsWithin(20, 5000));
    EXPECT_TRUE(equalBits(one.particles.position, many.particles.position));
    EXPECT_TRUE(equalBits(one.particles.velocity, many.particles.velocity));
    EXPECT_TRUE(equalBits(one.particles.intensity, many.particles.intensity));
  }
  omp_set_num_threads(before);
}

TEST(Thickness, ParticlesAreTheSameForAnySplitOfTheSeeds)
{
  const ThickDisk whole(m83Rings(), busyLayer(), seedsWithin(20, 3000));
  for (const std::size_t cut : { 1, 777, 2999 })
  {
    const ThickDisk parts[] = { { m83Rings(), busyLayer(), part(whole.seeds, 0, cut) },
      { m83Rings(), busyLayer(), part(whole.seeds, cut, 3000) } };
    std::size_t offset = 0;
    for (const ThickDisk& piece : parts)
    {
      EXPECT_TRUE(std::equal(piece.particles.position.begin(), piece.particles.position.end(),
        whole.particles.position.begin() + offset));
      EXPECT_TRUE(std::equal(piece.particles.velocity.begin(), piece.particles.velocity.end(),
        whole.particles.velocity.begin() + offset));
      offset += piece.particles.position.size();
    }
    EXPECT_EQ(offset, whole.particles.position.size());
  }
}

TEST(Thickness, ParticlesMoveWithTheirRing)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Flared, 2);
  const ThickDisk thick(m83Rings(), component, seedsWithin(50, 100));
  for (std::size_t k = 0; k < thick.particles.size(); ++k)
  {
    const Vec3 v = thick.disk.velocity(thick.seeds.radius[k / 2], thick.seeds.azimuth[k / 2]);
    EXPECT_NEAR(thick.particles.velocity[3 * k], v.x, 1e-4);
    EXPECT_NEAR(thick.particles.velocity[3 * k + 1], v.y, 1e-4);
    EXPECT_NEAR(thick.particles.velocity[3 * k + 2], v.z, 1e-4);
  }
}

TEST(Thickness, RandomMotionIsNormalAndLeavesThePlacesAlone)
{
  ComponentDescription component = verticalLayer(ThicknessModel::Flared, 10);
  component.velocityDispersion = 12;
  const ThickDisk moving(m83Rings(), component, seedsWithin(50, 2000));
  const ThickDisk still(m83Rings(), component, seedsWithin(50, 2000), false);
  EXPECT_TRUE(equalBits(moving.particles.position, still.particles.position));
  EXPECT_TRUE(still.particles.velocity.empty());
  std::vector<double> axes[3];
  for (std::size_t k = 0; k < moving.particles.size(); ++k)
  {
    const Vec3 v = moving.disk.velocity(moving.seeds.radius[k / 10], moving.seeds.azimuth[k / 10]);
    const float* particle = &moving.particles.velocity[3 * k];
    axes[0].push_back((particle[0] - v.x) / 12);
    axes[1].push_back((particle[1] - v.y) / 12);
    axes[2].push_back((particle[2] - v.z) / 12);
  }
  for (const std::vector<double>& axis : axes)
  {
    EXPECT_LT(kolmogorov(axis, normalShare), 1.95);
  }
}
} // namespace galaxy
