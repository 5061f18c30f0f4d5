#include "Filters/Model/DustFilaments.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <numeric>

namespace galaxy
{
namespace
{
ComponentDescription dustDisk()
{
  ComponentDescription component;
  component.name = "dust";
  component.profile = DiskProfile::Exponential;
  component.scaleLength = 5;
  component.role = ComponentRole::Absorbs;
  component.hasDust = true;
  return component;
}

struct Filaments
{
  Filaments(const RingTable& rings, const ComponentDescription& component, std::size_t count)
    : disk(rings, m83Distance)
    , seeds(sampleSeeds(this->disk, component, {}, {}, count, "m83.galaxy"))
  {
    requireStableFilaments(this->seeds, this->disk, component, "m83.galaxy");
    this->starts = countFilaments(this->seeds, this->disk, component, {});
    this->particles = allocateParticles(this->starts[this->seeds.size()], true);
    placeFilaments(this->seeds, this->starts, this->disk, component, {}, 2.5,
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
} // namespace

TEST(Dust, HeightsAreStationary)
{
  // From steps much shorter than the oscillation to nu dt = 1, rms z = h_d from the first particle
  // to the last.
  for (const double nuStep : { 0.05, 0.5, 0.99 })
  {
    ComponentDescription component = dustDisk();
    component.dust.steps = 40;
    component.dust.scaleHeight = 0.08;
    component.dust.velocityDispersion = 0;
    component.dust.verticalDispersion = nuStep * 80 * 200 / 30;
    const Filaments filaments(flatDisk(20), component, 20000);
    for (const int particle : { 0, 1, 10, 39 })
    {
      double squares = 0;
      int n = 0;
      for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
      {
        const std::uint64_t k = filaments.starts[i] + particle;
        if (k < filaments.starts[i + 1])
        {
          squares += filaments.position(k).z * filaments.position(k).z;
          ++n;
        }
      }
      EXPECT_NEAR(std::sqrt(squares / n) / 0.08, 1, 0.015) << nuStep << ' ' << particle;
    }
  }
}

TEST(Dust, UnstableStepsAreRefused)
{
  ComponentDescription component = dustDisk();
  component.dust.velocityDispersion = 0;
  component.dust.scaleHeight = 0.08;
  component.dust.verticalDispersion = 1.01 * 80 * 200 / 30;
  try
  {
    const Filaments filaments(flatDisk(20), component, 10);
    FAIL() << "accepted nu dt = 1.01";
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(message.rfind("m83.galaxy: dust: ", 0), 0u) << message;
    EXPECT_NE(message.find("step_length"), std::string::npos);
    EXPECT_NE(message.find("1.01"), std::string::npos);
  }
  // Where nothing moves, a step has no duration.
  RingTable still;
  still.rings = { ring(100, 0, 1, 0, 0) };
  component = dustDisk();
  component.dust.velocityDispersion = 0;
  EXPECT_THROW(Filaments(still, component, 10), Error);
}

TEST(Dust, FilamentsOfRotationKeepTheirRadius)
{
  ComponentDescription component = dustDisk();
  component.dust.velocityDispersion = 0;
  component.dust.steps = 50;
  component.dust.stepLength = 0.05;
  const Filaments filaments(m83Rings(), component, 200);
  EXPECT_EQ(filaments.particles.size(), 50 * filaments.seeds.size());
  for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
  {
    const double r = filaments.seeds.radius[i];
    for (std::uint64_t k = filaments.starts[i]; k < filaments.starts[i + 1]; ++k)
    {
      const Vec3 p = filaments.position(k);
      const Vec3 n = filaments.disk.frame(r).n;
      const double height = dot(p, n);
      EXPECT_NEAR(length(p - height * n), r, 1e-5 * r);
      // One step along the ring per particle, in the sense of rotation.
      const double theta = filaments.seeds.azimuth[i] + (k - filaments.starts[i]) * 0.05 / r;
      EXPECT_NEAR(length(p - filaments.disk.position(r, theta, height)), 0, 1e-4);
    }
  }
}

TEST(Dust, FilamentsOfRingVelocityAreStraight)
{
  ComponentDescription component = dustDisk();
  component.dust.model = DustModel::RingVelocity;
  component.dust.velocityDispersion = 0;
  component.dust.steps = 50;
  component.dust.stepLength = 0.05;
  component.outerRadius = 15;
  const Filaments filaments(flatDisk(40), component, 200);
  for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
  {
    const double r = filaments.seeds.radius[i];
    const double theta = filaments.seeds.azimuth[i];
    const Vec3 start = filaments.disk.position(r, theta);
    const Vec3 along = normalized(filaments.disk.velocity(r, theta));
    for (std::uint64_t k = filaments.starts[i]; k < filaments.starts[i + 1]; ++k)
    {
      Vec3 p = filaments.position(k);
      p.z = 0;
      const Vec3 expected = start + (k - filaments.starts[i]) * 0.05 * along;
      EXPECT_NEAR(length(p - expected), 0, 1e-5);
    }
  }
}

TEST(Dust, FilamentsStopAtTheEdgeAndKeepTheirCrossSection)
{
  ComponentDescription component = dustDisk();
  component.innerRadius = 4;
  component.outerRadius = 6;
  component.dust.model = DustModel::RingVelocity;
  component.dust.steps = 100;
  const Filaments filaments(flatDisk(20), component, 2000);
  std::size_t cut = 0;
  for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
  {
    const std::uint64_t first = filaments.starts[i], last = filaments.starts[i + 1];
    ASSERT_GT(last, first);
    ASSERT_LE(last, first + 100);
    cut += last < first + 100 ? 1 : 0;
    const double light = std::accumulate(filaments.particles.intensity.begin() + first,
      filaments.particles.intensity.begin() + last, 0.0);
    EXPECT_NEAR(light / (2.5 * filaments.seeds.light[i]), 1, 1e-5);
  }
  EXPECT_GT(cut, 500u);
  EXPECT_LT(cut, 2000u);
  for (std::size_t k = 0; k < filaments.particles.size(); ++k)
  {
    const Vec3 p = filaments.position(k);
    EXPECT_GT(std::hypot(p.x, p.y), 4 - 1e-5);
    EXPECT_LT(std::hypot(p.x, p.y), 6 + 1e-5);
  }
}

TEST(Dust, PeculiarVelocitiesSpreadAsAnOrnsteinUhlenbeckWalk)
{
  ComponentDescription component = dustDisk();
  component.innerRadius = 9;
  component.outerRadius = 11;
  component.dust.steps = 30;
  component.dust.stepLength = 0.03;
  component.dust.velocityDispersion = 10;
  component.dust.dampingTime = 1;
  Filaments filaments(flatDisk(40), component, 20000);
  // In units of pc/(km/s): var(dR) after n steps = sigma^2 dt^2 sum_jk c^|j-k|.
  const double dt = 30 / std::sqrt(200.0 * 200 + 200), c = std::exp(-dt * 0.977792);
  double expected = 0;
  for (int j = 0; j < 20; ++j)
  {
    for (int k = 0; k < 20; ++k)
    {
      expected += 100 * dt * dt * std::pow(c, std::abs(j - k)) * 1e-6;
    }
  }
  double squares = 0;
  int n = 0;
  for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
  {
    if (std::abs(filaments.seeds.radius[i] - 10) < 0.5)
    {
      ASSERT_EQ(filaments.starts[i + 1] - filaments.starts[i], 30u);
      const Vec3 p = filaments.position(filaments.starts[i] + 20);
      const double d = std::hypot(p.x, p.y) - filaments.seeds.radius[i];
      squares += d * d;
      ++n;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / n / expected), 1, 0.03);
}
} // namespace galaxy
