#include "Filters/Model/Spheroid.h"
#include "Filters/Model/SpheroidPlaces.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <numeric>

namespace galaxy
{
namespace
{
const TiltedDisk tiltedDisk(flatDisk(10, 50, 30), m83Distance);

Particles spheroid(
  const ComponentDescription& component, std::size_t count, const RandomKey& key = {})
{
  Particles particles = allocateParticles(count, true);
  placeSpheroid(tiltedDisk, component, key, count, 1, ParticleWriter(particles, 0, 0));
  return particles;
}

Vec3 at(const Buffer<float>& values, std::size_t i)
{
  return { values[3 * i], values[3 * i + 1], values[3 * i + 2] };
}

/// A bulge of three different axes in a disc tilted about both angles.
ComponentDescription bulge()
{
  ComponentDescription component;
  component.type = ComponentType::Spheroid;
  component.spheroid.sigma = { 0.5, 0.3, 0.2 };
  component.spheroid.centralBrightness = 3;
  component.color = { 0.4, 0.8, 0.2 };
  return component;
}

/// The mean products of coordinates along three axes.
std::array<std::array<double, 3>, 3> momentsAlong(const SemiAxes& axes, const Particles& particles)
{
  std::array<std::array<double, 3>, 3> moments{};
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Vec3 p = at(particles.position, i);
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        moments[j][k] += dot(p, axes[j]) * dot(p, axes[k]) / particles.size();
      }
    }
  }
  return moments;
}

double lightOf(const Particles& particles)
{
  return std::accumulate(particles.intensity.begin(), particles.intensity.end(), 0.0);
}

/// The light seen along n within a radius, per area.
double brightnessBetween(const Particles& particles, double inner, double outer)
{
  const RingFrame ring = tiltedDisk.frame(0);
  double light = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const Vec3 p = at(particles.position, i);
    const double r = std::hypot(dot(p, ring.a), dot(p, ring.b));
    light += r >= inner && r < outer ? particles.intensity[i] : 0;
  }
  return light / (pi * (outer * outer - inner * inner));
}
} // namespace

TEST(Spheroid, MomentsLieAlongTheAxes)
{
  const RingFrame ring = tiltedDisk.frame(0);
  ComponentDescription component = bulge();
  const auto expectMoments = [&](const SemiAxes& axes) {
    const auto moments = momentsAlong(axes, spheroid(component, 200000));
    for (int j = 0; j < 3; ++j)
    {
      EXPECT_NEAR(std::sqrt(moments[j][j]) / component.spheroid.sigma[j], 1, 0.01);
      EXPECT_NEAR(moments[j][(j + 1) % 3], 0, 0.001);
    }
  };
  expectMoments({ ring.a, ring.b, ring.n });
  component.spheroid.tilted = false;
  expectMoments({ Vec3{ 1, 0, 0 }, Vec3{ 0, 1, 0 }, Vec3{ 0, 0, 1 } });
  // The ring's own angles are the ring's axes; other angles are those of such a ring.
  component.spheroid.oriented = true;
  component.spheroid.positionAngle = 30;
  component.spheroid.inclination = 50;
  expectMoments({ ring.a, ring.b, ring.n });
  component.spheroid.positionAngle = 120;
  component.spheroid.inclination = 90;
  expectMoments({ Vec3{ -std::sin(120 * degree), std::cos(120 * degree), 0 }, Vec3{ 0, 0, 1 },
    Vec3{ -std::cos(120 * degree), -std::sin(120 * degree), 0 } });
}

TEST(Spheroid, AxisRatiosFlattenEveryProfile)
{
  const RingFrame ring = tiltedDisk.frame(0);
  for (const SpheroidProfile kind :
    { SpheroidProfile::Sersic, SpheroidProfile::Hernquist, SpheroidProfile::Exponential,
      SpheroidProfile::Plummer, SpheroidProfile::NFW, SpheroidProfile::Cored })
  {
    ComponentDescription component = bulge();
    component.spheroid.profile = kind;
    component.spheroid.truncation = 3;
    component.spheroid.axisRatios = { 0.8, 0.4 };
    const auto moments = momentsAlong({ ring.a, ring.b, ring.n }, spheroid(component, 100000));
    EXPECT_NEAR(std::sqrt(moments[1][1] / moments[0][0]), 0.8, 0.01);
    EXPECT_NEAR(std::sqrt(moments[2][2] / moments[0][0]), 0.4, 0.005);
  }
}

TEST(Spheroid, LightGivesTheCentralBrightness)
{
  const Particles particles = spheroid(bulge(), 400000);
  EXPECT_NEAR(lightOf(particles), 0.8 * 3 * 2 * pi * 0.5 * 0.3, 1e-5);
  EXPECT_NEAR(brightnessBetween(particles, 0, 0.05), 0.8 * 3, 0.08);
  EXPECT_EQ(particles.color[0], 128);
  EXPECT_EQ(particles.color[1], 255);
  EXPECT_EQ(particles.color[2], 64);
  EXPECT_EQ(particles.velocity[5], 0);
}

TEST(Spheroid, OtherProfilesHaveTheirBrightnessToo)
{
  ComponentDescription component = bulge();
  component.spheroid.scaleRadius = 1;
  component.spheroid.axisRatios = { 1, 0.5 };
  const double shown = 0.8 * 3;
  component.spheroid.profile = SpheroidProfile::Plummer;
  EXPECT_NEAR(lightOf(spheroid(component, 1000)), shown * pi, 1e-4);
  EXPECT_NEAR(brightnessBetween(spheroid(component, 400000), 0, 0.1), shown, 0.1);
  component.spheroid.profile = SpheroidProfile::Sersic;
  component.spheroid.effectiveRadius = 0.6;
  EXPECT_NEAR(brightnessBetween(spheroid(component, 400000), 0.58, 0.62), shown, 0.05);
  component.spheroid.profile = SpheroidProfile::Hernquist;
  EXPECT_NEAR(brightnessBetween(spheroid(component, 400000), 2.34, 2.49), shown, 0.05);
}

TEST(Spheroid, LuminosityIsTheWholeLight)
{
  ComponentDescription component = bulge();
  component.spheroid.luminosity = 7;
  for (const SpheroidProfile kind : { SpheroidProfile::Gaussian, SpheroidProfile::NFW })
  {
    component.spheroid.profile = kind;
    EXPECT_NEAR(lightOf(spheroid(component, 1000)), 0.8 * 7, 1e-5);
  }
}

TEST(Spheroid, ShellsTurnAndFlattenWithRadius)
{
  ComponentDescription component = bulge();
  SpheroidDescription& s = component.spheroid;
  s.profile = SpheroidProfile::Hernquist;
  s.scaleRadius = 1;
  s.ellipsoids = { { 1, { 1, 1 }, 20, 0 }, { 3, { 0.6, 0.4 }, -40, 30 } };
  const SpheroidShape shape(s, tiltedDisk);
  const auto expectAxes = [&](double radius, double b, double c, double angle, double tilt) {
    const SemiAxes axes = shape.semiAxes(radius);
    EXPECT_NEAR(length(axes[0]), radius, 1e-12);
    EXPECT_NEAR(length(axes[1]), b * radius, 1e-12);
    EXPECT_NEAR(length(axes[2]), c * radius, 1e-12);
    EXPECT_NEAR(axes[0].x, -radius * std::sin(angle * degree), 1e-12);
    EXPECT_NEAR(axes[0].y, radius * std::cos(angle * degree), 1e-12);
    EXPECT_NEAR(axes[2].z / length(axes[2]), std::cos(tilt * degree), 1e-12);
    EXPECT_NEAR(dot(axes[0], axes[1]) + dot(axes[1], axes[2]) + dot(axes[2], axes[0]), 0, 1e-12);
  };
  expectAxes(0.2, 1, 1, 20, 0);
  expectAxes(2, 0.8, 0.7, -10, 15);
  expectAxes(9, 0.6, 0.4, -40, 30);
  // Each particle is on the ellipsoid that its share of the mass asks for.
  const SpheroidPlaces places(s, tiltedDisk, {}, RandomStream::SpheroidPlace);
  const EvenFractions fraction({}, RandomStream::SpheroidPlace);
  const RadialProfile profile(s);
  for (std::uint64_t i = 0; i < 500; ++i)
  {
    const double radius = profile.radius(fraction(i));
    const SemiAxes axes = shape.semiAxes(radius);
    double sum = 0;
    for (const Vec3& axis : axes)
    {
      sum += std::pow(dot(places(i), axis) / dot(axis, axis), 2);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(Spheroid, VelocitiesAreNormal)
{
  ComponentDescription component = bulge();
  component.velocityDispersion = 120;
  const std::size_t n = 20000;
  const Particles particles = spheroid(component, n);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> sample;
    double withPlace = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      sample.push_back(particles.velocity[3 * i + axis]);
      withPlace += sample.back() * particles.position[3 * i + axis] / (120 * 0.4) / n;
    }
    EXPECT_LT(
      kolmogorov(sample, [](double v) { return 0.5 * std::erfc(-v / 120 / std::sqrt(2)); }), 1.95);
    EXPECT_NEAR(withPlace, 0, 0.03);
  }
  // Velocities are on a stream of their own: the places do not depend on them.
  EXPECT_TRUE(equalBits(particles.position, spheroid(bulge(), n).position));
}

TEST(Spheroid, TheSameForAnyNumberOfThreads)
{
  ComponentDescription component = bulge();
  component.velocityDispersion = 50;
  const int threads = omp_get_max_threads();
  for (const long long clusters : { 0, 7 })
  {
    component.spheroid.clusters = clusters;
    omp_set_num_threads(1);
    const Particles one = spheroid(component, 10007);
    omp_set_num_threads(5);
    const Particles five = spheroid(component, 10007);
    EXPECT_TRUE(equalBits(one.position, five.position));
    EXPECT_TRUE(equalBits(one.velocity, five.velocity));
  }
  omp_set_num_threads(threads);
}

TEST(Spheroid, FewerParticlesAreTheFirstOfMany)
{
  const Particles few = spheroid(bulge(), 1000);
  const Particles many = spheroid(bulge(), 5000);
  EXPECT_TRUE(std::equal(few.position.begin(), few.position.end(), many.position.begin()));
  EXPECT_FALSE(equalBits(few.position, spheroid(bulge(), 1000, { 2, 0 }).position)) << "by seed";
  EXPECT_FALSE(equalBits(few.position, spheroid(bulge(), 1000, { 1, 3 }).position))
    << "by component";
}

// Even in radius must not mean in step with direction.
TEST(Spheroid, RadiusTellsNothingOfDirection)
{
  ComponentDescription component = bulge();
  component.spheroid.sigma = { 1, 1, 1 };
  const std::size_t n = 20000;
  const Particles particles = spheroid(component, n);
  for (const double inner : { 0.0, 0.8, 1.5, 2.5 })
  {
    std::vector<double> cosines, angles;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vec3 p = at(particles.position, i);
      if (length(p) > inner && length(p) < inner + 0.5)
      {
        cosines.push_back(p.z / length(p));
        angles.push_back(std::atan2(p.y, p.x));
      }
    }
    ASSERT_GT(cosines.size(), 200u);
    EXPECT_LT(kolmogorov(cosines, [](double c) { return (1 + c) / 2; }), 1.95);
    EXPECT_LT(kolmogorov(angles, [](double a) { return 0.5 + a / (2 * pi); }), 1.95);
  }
}
} // namespace galaxy
