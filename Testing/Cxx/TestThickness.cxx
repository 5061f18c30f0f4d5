#include "Filters/Model/SmoothingLength.h"
#include "Filters/Model/Thickness.h"
#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace galaxy
{
namespace
{
const LayerLaw laws[] = { LayerLaw::Gaussian, LayerLaw::Sech2, LayerLaw::Exponential,
  LayerLaw::Lorentzian, LayerLaw::Box };

/// Seeds of an exponential disc, and the particles that its thickness makes of them.
struct ThickDisk
{
  ThickDisk(const RingTable& rings, const ComponentDescription& component, std::size_t count)
    : disk(rings, m83Distance)
    , seeds(sampleSeeds(this->disk, component, {}, {}, count, ""))
    , starts(countChildren(this->seeds, this->disk, component, {}, ""))
    , particles(allocateParticles(this->starts[this->seeds.size()], true))
  {
    placeChildren(this->seeds, this->starts, this->disk, component, {}, 1,
      ParticleWriter(this->particles, 0, 0, 0.1));
  }

  Vec3 position(std::size_t i) const
  {
    const float* p = &this->particles.position[3 * i];
    return { p[0], p[1], p[2] };
  }

  TiltedDisk disk;
  Seeds seeds;
  ParticleStarts starts;
  Particles particles;
};

ComponentDescription exponentialDisk()
{
  ComponentDescription component;
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 3;
  component.thickness.sigma = 0;
  return component;
}

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}
} // namespace

TEST(VerticalLaw, HeightsHaveTheirClosedForms)
{
  for (const LayerLaw law : laws)
  {
    Random random({}, RandomStream::ChildPlace, static_cast<std::uint64_t>(law));
    const int n = 400000;
    double sum = 0, squares = 0;
    int belowHalf = 0;
    for (int k = 0; k < n; ++k)
    {
      const double z = sampleHeight(law, random);
      sum += z;
      squares += z * z;
      belowHalf += std::abs(z) < 0.5 * fwhmHeight(law) ? 1 : 0;
    }
    EXPECT_NEAR(std::sqrt(squares / n) / rmsHeight(law), 1, 0.01) << static_cast<int>(law);
    EXPECT_NEAR(sum / n / rmsHeight(law), 0, 0.008);
    // The share within the half width, by each law's own distribution function.
    const double inside[] = { std::erf(std::sqrt(std::log(2.0))), std::sqrt(0.5), 0.5,
      0.25 * pi / std::atan(10.0), 1 };
    EXPECT_NEAR(belowHalf / double(n), inside[static_cast<int>(law) - 1], 0.003);
  }
  EXPECT_NEAR(rmsHeight(LayerLaw::Sech2), 0.907, 0.001);
  EXPECT_NEAR(fwhmHeight(LayerLaw::Gaussian), 2.3548, 1e-4);
  EXPECT_NEAR(fwhmHeight(LayerLaw::Sech2), 1.7627, 1e-4);
}

TEST(Thickness, ChildrenShareTheirSeedsLight)
{
  for (const ThicknessModel model : { ThicknessModel::Gaussian, ThicknessModel::Tapered,
         ThicknessModel::Flared, ThicknessModel::Hydrostatic })
  {
    ComponentDescription component = exponentialDisk();
    component.thickness.model = model;
    component.thickness.children = 7.3;
    component.thickness.maximumChildren = 7;
    const ThickDisk thick(m83Rings(), component, 5000);
    for (std::size_t i = 0; i < thick.seeds.size(); ++i)
    {
      const std::uint64_t first = thick.starts[i], last = thick.starts[i + 1];
      ASSERT_GE(last, first + 1);
      ASSERT_LE(last, first + 7);
      const double light = std::accumulate(
        thick.particles.intensity.begin() + first, thick.particles.intensity.begin() + last, 0.0);
      ASSERT_NEAR(light / thick.seeds.light[i], 1, 1e-6);
      for (std::uint64_t k = first; k < last; ++k)
      {
        ASSERT_EQ(thick.particles.color[3 * k], thick.seeds.color[3 * i]);
      }
    }
  }
}

TEST(Thickness, ChildCountsKeepTheirMean)
{
  ComponentDescription component = exponentialDisk();
  component.outerRadius = 5;
  component.thickness.children = 12;
  component.thickness.compression = 0.4;
  const ThickDisk thick(flatDisk(20), component, 40000);
  double expected = 0;
  for (const float intensity : thick.seeds.intensity)
  {
    expected += 12 * std::pow(intensity, 0.6);
  }
  EXPECT_NEAR(thick.particles.size() / expected, 1, 0.001);
}

TEST(Thickness, GaussianModelIsIsotropic)
{
  ComponentDescription component = exponentialDisk();
  component.thickness.sigma = 0.4;
  component.thickness.children = 10;
  const ThickDisk thick(flatDisk(10, 50, 20), component, 20000);
  double xx = 0, yy = 0, zz = 0, xz = 0;
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    const Vec3 seed = thick.disk.position(thick.seeds.radius[i], thick.seeds.azimuth[i]);
    for (std::uint64_t k = thick.starts[i]; k < thick.starts[i + 1]; ++k)
    {
      const Vec3 d = thick.position(k) - seed;
      xx += d.x * d.x;
      yy += d.y * d.y;
      zz += d.z * d.z;
      xz += d.x * d.z;
    }
  }
  const double n = static_cast<double>(thick.particles.size());
  for (const double square : { xx, yy, zz })
  {
    EXPECT_NEAR(std::sqrt(square / n), 0.4, 0.005);
  }
  EXPECT_NEAR(xz / n, 0, 0.002);
}

TEST(Thickness, HeightsStandOnTheWarpedPlane)
{
  ComponentDescription component = exponentialDisk();
  component.scaleLength = 30;
  component.thickness.model = ThicknessModel::Tapered;
  component.thickness.law = LayerLaw::Exponential;
  component.thickness.scaleHeight = 0.5;
  const ThickDisk thick(m83Rings(), component, 50000);
  double squares = 0;
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    const double r = thick.seeds.radius[i];
    const Vec3 d = thick.position(i) - thick.disk.position(r, thick.seeds.azimuth[i]);
    const Vec3 n = thick.disk.frame(r).n;
    ASSERT_LT(length(cross(d, n)), 1e-5);
    squares += dot(d, n) * dot(d, n);
  }
  EXPECT_NEAR(std::sqrt(squares / thick.seeds.size()), 0.5 * std::sqrt(2.0), 0.01);
}

TEST(Thickness, HeightsStayBelowTheFocusOfNormals)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 0, 0), ring(100, 100, 1, 80, 0) };
  ComponentDescription component = exponentialDisk();
  component.thickness.model = ThicknessModel::Tapered;
  component.thickness.scaleHeight = 3;
  const ThickDisk thick(table, component, 2000);
  const double highest = normalFocalHeight(thick.disk.frame(1));
  double largest = 0;
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    const Vec3 seed = thick.disk.position(thick.seeds.radius[i], thick.seeds.azimuth[i]);
    largest = std::max(largest, length(thick.position(i) - seed));
  }
  EXPECT_NEAR(largest, highest, 1e-5);
}

TEST(Thickness, ZeroThicknessIsExactlyPlanar)
{
  ComponentDescription component = exponentialDisk();
  const ThickDisk thick(flatDisk(10), component, 1000);
  for (std::size_t i = 0; i < thick.particles.size(); ++i)
  {
    ASSERT_EQ(thick.position(i).z, 0);
  }
}

TEST(Thickness, TaperedDiscTapers)
{
  const TiltedDisk disk(flatDisk(20), m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Tapered;
  thickness.children = 20;
  thickness.scaleLength = 4;
  thickness.scaleHeight = 0.3;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).meanChildren(8, 0.1), 20 * std::exp(-2), 1e-12);
  EXPECT_EQ(ThicknessProfile(thickness, disk).scaleHeight(8), 0.3);
  thickness.taperThickness = true;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(8), 0.3 * std::exp(-2), 1e-12);
}

TEST(Thickness, FlaredWidthIsRecoveredFromTheParticles)
{
  RingTable table;
  table.rings = { ring(0, 120, 1, 30, 0), ring(40 / m83Kpc, 250, 1, 30, 0) };
  for (const LayerLaw law : { LayerLaw::Gaussian, LayerLaw::Sech2, LayerLaw::Exponential })
  {
    ComponentDescription component = exponentialDisk();
    component.scaleLength = 1000;
    component.thickness.model = ThicknessModel::Flared;
    component.thickness.law = law;
    const ThickDisk thick(table, component, 400000);
    for (const double r : { 5.0, 15.0, 30.0 })
    {
      std::vector<double> heights;
      for (std::size_t i = 0; i < thick.seeds.size(); ++i)
      {
        if (std::abs(thick.seeds.radius[i] - r) < 0.5)
        {
          heights.push_back(std::abs(dot(thick.position(i), thick.disk.frame(r).n)));
        }
      }
      // Half the heights lie below the median: 0.6745, atanh(1/2), ln 2 scale heights.
      const double unit = law == LayerLaw::Gaussian ? 0.674490
        : law == LayerLaw::Sech2                    ? std::atanh(0.5)
                                                    : std::log(2.0);
      const double width = median(heights) / unit * fwhmHeight(law);
      const double base = r <= 10 ? 0.3 + 0.5 * r / 10 : 0.8 * std::exp((r - 10) / 17.4);
      const double expected = base * 189 / (120 + 130 * r / 40);
      EXPECT_NEAR(width / expected, 1, heights.size() > 8000 ? 0.02 : 0.03)
        << r << " of " << heights.size();
    }
  }
}

TEST(Thickness, FlaredWidthIsCappedWhereNothingRotates)
{
  RingTable table;
  table.rings = { ring(100, 0, 1, 30, 0) };
  const TiltedDisk disk(table, m83Distance);
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Flared;
  thickness.fwhmCentre = 0;
  for (const double r : { 0.0, 3.0, 500.0 })
  {
    EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(r) * 2.3548, 4, 1e-4);
  }
}

TEST(Thickness, HydrostaticLimits)
{
  const TiltedDisk disk(flatDisk(60), m83Distance); // 200 km/s
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Hydrostatic;
  thickness.gasDispersion = 10;
  thickness.stellarSurfaceDensity = 0;
  thickness.gasSurfaceDensity = 0;
  // Halo alone: sigma_z = sigma_g R / v.
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(20), 1.0, 1e-4);
  // Own gravity alone: sigma_z = sigma_g^2 sqrt(2 pi)/(4 pi G Sigma).
  thickness.gasSurfaceDensity = 1e4;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(50) * 1000,
    100 * std::sqrt(2 * pi) / (4 * pi * 4.30091e-3 * 1e4), 1e-3);
  // Stars alone: FWHM = 1.665 sigma_g sqrt(z0 / (pi G Sigma)).
  thickness.gasSurfaceDensity = 0;
  thickness.stellarSurfaceDensity = 1e6;
  thickness.scaleLength = 1e9;
  EXPECT_NEAR(ThicknessProfile(thickness, disk).scaleHeight(50) * 2.3548,
    1.665 * 10 * std::sqrt(0.34 / 1000 / (pi * 4.30091e-3 * 1e6)), 1e-5);
  // The values of 10 km/s in a halo of 189 km/s at 5, 10, 20, 50 kpc: 0.62, 1.25, 2.49, 6.2 kpc.
  RingTable table;
  table.rings = { ring(0, 189, 1, 0, 0), ring(3000, 189, 1, 0, 0) };
  const TiltedDisk flat(table, m83Distance);
  thickness.stellarSurfaceDensity = 0;
  const ThicknessProfile halo(thickness, flat);
  EXPECT_NEAR(halo.scaleHeight(5) * 2.3548, 0.62, 0.006);
  EXPECT_NEAR(halo.scaleHeight(50) * 2.3548, 6.23, 0.01);
}

TEST(Thickness, RingsBringTheirOwnHeightAndLaw)
{
  RingTable table = flatDisk(10);
  table.rings = { ring(0, 200, 10, 0, 0), ring(600, 200, 30, 0, 0) };
  table.layerLaw = LayerLaw::Exponential;
  ThicknessDescription thickness;
  thickness.model = ThicknessModel::Rings;
  const TiltedDisk disk(table, m83Distance);
  const ThicknessProfile profile(thickness, disk);
  EXPECT_EQ(profile.law(), LayerLaw::Exponential);
  EXPECT_NEAR(profile.scaleHeight(300 * m83Kpc), 20 * m83Kpc, 1e-12);
}

TEST(Thickness, ParticlesMoveWithTheirRing)
{
  const ThickDisk thick(m83Rings(), exponentialDisk(), 100);
  for (std::size_t i = 0; i < thick.seeds.size(); ++i)
  {
    const Vec3 v = thick.disk.velocity(thick.seeds.radius[i], thick.seeds.azimuth[i]);
    EXPECT_NEAR(thick.particles.velocity[3 * i], v.x, 1e-4);
    EXPECT_NEAR(thick.particles.velocity[3 * i + 2], v.z, 1e-4);
  }
}

TEST(Thickness, NegativeChildrenAreRefused)
{
  ComponentDescription component = exponentialDisk();
  component.thickness.children = -1;
  EXPECT_THROW(ThickDisk(flatDisk(10), component, 10), Error);
}

TEST(SmoothingLength, FollowsTheParticlesDistance)
{
  ComponentDescription component = exponentialDisk();
  component.thickness.sigma = 0.2;
  component.thickness.children = 4;
  component.thickness.compression = 1;
  const ThickDisk thick(flatDisk(10), component, 3000);
  const double h = diskSmoothingLength(thick.seeds, thick.starts, thick.disk, component);
  const double perParticle = pi * 100 / 12000;
  EXPECT_NEAR(h, 1.5 * std::cbrt(perParticle * 2 * std::sqrt(pi) * 0.2), 1e-6);
  component.thickness.sigma = 0;
  EXPECT_NEAR(diskSmoothingLength(thick.seeds, thick.starts, thick.disk, component),
    1.5 * std::sqrt(perParticle), 1e-6);
  component.smoothingLength = 0.123;
  EXPECT_EQ(diskSmoothingLength(thick.seeds, thick.starts, thick.disk, component), 0.123);
}
} // namespace galaxy
