#include "Readers/Formats/Error.h"
#include "Testing/Cxx/DustFixtures.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <numeric>
#include <omp.h>

namespace galaxy
{
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
    const Filaments filaments(flatDisk(20), component, 40000);
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
      EXPECT_NEAR(std::sqrt(squares / n) / 0.08, 1, 0.01) << nuStep << ' ' << particle;
    }
  }
}

TEST(Dust, HeightsAreNormal)
{
  const auto normal = [](double z) { return 0.5 * std::erfc(-z / 0.08 / std::sqrt(2.0)); };
  for (const DustModel model : { DustModel::DiskRotation, DustModel::Fractal })
  {
    ComponentDescription component = dustDisk();
    component.outerRadius = 19; // a walk that ends early would leave no particle to look at
    component.dust.model = model;
    component.dust.steps = 12;
    component.dust.children = 12;
    component.dust.scaleHeight = 0.08;
    component.dust.velocityDispersion = 0;
    const Filaments filaments(flatDisk(20), component, 10000);
    for (const int particle : { 0, 4, 11 })
    {
      std::vector<double> heights;
      for (std::size_t i = 0; i < filaments.seeds.size(); ++i)
      {
        heights.push_back(filaments.position(filaments.starts[i] + particle).z);
      }
      EXPECT_LT(kolmogorov(heights, normal), 1.95) << int(model) << ' ' << particle;
    }
  }
}

TEST(Dust, UnstableStepsAreRefused)
{
  ComponentDescription component = dustDisk();
  component.dust.velocityDispersion = 0;
  component.dust.scaleHeight = 0.08;
  component.dust.verticalDispersion = 1.01 * 80 * 200 / 30;
  const std::string message =
    errorOf([&] { const Filaments filaments(flatDisk(20), component, 10); });
  EXPECT_EQ(message.rfind("m83.galaxy: dust: ", 0), 0u) << message;
  EXPECT_NE(message.find("step_length of at most 0.0297"), std::string::npos) << message;
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

TEST(Dust, VelocitiesAreTheDiscsAndThePeculiarOnes)
{
  for (const DustModel model : { DustModel::RingVelocity, DustModel::DiskRotation })
  {
    ComponentDescription component = dustDisk();
    component.dust.model = model;
    component.dust.steps = 20;
    const Filaments filaments(m83Rings(), component, 5000);
    double along[3] = { 0, 0, 0 };
    for (std::size_t k = 0; k < filaments.particles.size(); ++k)
    {
      // On the particle's own ring, to which its distance to the centre leads.
      const Vec3 p = filaments.position(k);
      double r = length(p);
      for (int repeat = 0; repeat < 3; ++repeat)
      {
        const double height = dot(p, filaments.disk.frame(r).n);
        r = std::sqrt(dot(p, p) - height * height);
      }
      const RingFrame ring = filaments.disk.frame(r);
      const double x = dot(p, ring.a) / r, y = dot(p, ring.b) / r;
      const Vec3 rest = filaments.velocity(k) - ringVelocity(ring, x, y);
      along[0] += std::pow(dot(rest, x * ring.a + y * ring.b), 2);
      along[1] += std::pow(dot(rest, x * ring.b - y * ring.a), 2);
      along[2] += std::pow(dot(rest, ring.n), 2);
    }
    const double n = static_cast<double>(filaments.particles.size());
    EXPECT_NEAR(std::sqrt(along[0] / n), component.dust.velocityDispersion, 0.15);
    EXPECT_NEAR(std::sqrt(along[1] / n), component.dust.velocityDispersion, 0.15);
    EXPECT_NEAR(std::sqrt(along[2] / n), component.dust.verticalDispersion, 0.1);
  }
}

TEST(Dust, FilamentsEndWhereTheWalkFirstLeaves)
{
  for (const DustModel model : { DustModel::RingVelocity, DustModel::DiskRotation })
  {
    ComponentDescription component = dustDisk();
    component.innerRadius = 4;
    component.outerRadius = 8;
    component.dust.model = model;
    component.dust.steps = 50;
    component.dust.stepLength = 0.1;
    Filaments filaments(flatDisk(20), component, 3000);
    // All the walks, to their last step, whatever the edges are.
    const std::size_t count = filaments.seeds.size();
    ParticleStarts whole(count + 1);
    for (std::size_t i = 0; i <= count; ++i)
    {
      whole[i] = 50 * i;
    }
    Particles all = allocateParticles(50 * count, false);
    placeFilaments(filaments.seeds, whole, filaments.disk, component, {}, 1, { all, 0, 0 });
    std::size_t cut = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::size_t inside = 0;
      for (; inside < 50; ++inside)
      {
        const Vec3 p = Filaments::vector(all.position, 50 * i + inside);
        const double r = std::hypot(p.x, p.y);
        if (inside > 0 && (r < 4 || r > 8))
        {
          break;
        }
      }
      ASSERT_EQ(filaments.starts[i + 1] - filaments.starts[i], inside) << i;
      cut += inside < 50 ? 1 : 0;
    }
    EXPECT_GT(cut, 50u);
    EXPECT_LT(cut, count);
  }
}

TEST(Dust, AreTheSameForAnyNumberOfThreads)
{
  for (const DustModel model :
    { DustModel::RingVelocity, DustModel::DiskRotation, DustModel::Fractal })
  {
    ComponentDescription component = dustDisk();
    component.dust.model = model;
    component.dust.steps = 10;
    const int threads = omp_get_max_threads();
    omp_set_num_threads(1);
    const Filaments one(m83Rings(), component, 1000);
    omp_set_num_threads(7);
    const Filaments seven(m83Rings(), component, 1000);
    omp_set_num_threads(threads);
    EXPECT_TRUE(equalBits(one.starts, seven.starts));
    EXPECT_TRUE(equalBits(one.particles.position, seven.particles.position));
    EXPECT_TRUE(equalBits(one.particles.intensity, seven.particles.intensity));
    EXPECT_TRUE(equalBits(one.particles.velocity, seven.particles.velocity));
  }
}

TEST(Dust, ValuesOutOfRangeAreRefusedByName)
{
  const auto expectRefused = [](const char* name, const auto& change) {
    ComponentDescription component = dustDisk();
    change(component.dust);
    const std::string message =
      errorOf([&] { const Filaments filaments(flatDisk(20), component, 10); });
    EXPECT_NE(message.find(std::string("dust: ") + name + " must be"), std::string::npos)
      << name << ": " << message;
  };
  expectRefused("step_length", [](DustDescription& d) { d.stepLength = 0; });
  expectRefused("velocity_dispersion", [](DustDescription& d) { d.velocityDispersion = -1; });
  expectRefused("vertical_dispersion", [](DustDescription& d) { d.verticalDispersion = -1; });
  expectRefused("scale_height", [](DustDescription& d) { d.scaleHeight = -0.1; });
  expectRefused("damping_time", [](DustDescription& d) { d.dampingTime = 0; });
  expectRefused("steps", [](DustDescription& d) { d.steps = 0; });
  expectRefused("lacunarity", [](DustDescription& d) { d.lacunarity = 0.9; });
  expectRefused("hurst", [](DustDescription& d) { d.hurst = -0.1; });
  expectRefused("contrast", [](DustDescription& d) { d.contrast = std::nan(""); });
  expectRefused("noise_scale", [](DustDescription& d) { d.noiseScale = 0; });
  expectRefused("winding", [](DustDescription& d) { d.winding = 1e9; });
  expectRefused("octaves", [](DustDescription& d) { d.octaves = 17; });
  expectRefused("children", [](DustDescription& d) { d.children = 0; });
  expectRefused("spread", [](DustDescription& d) { d.spread = -1; });
}
} // namespace galaxy
