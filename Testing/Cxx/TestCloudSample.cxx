#include "Filters/Model/CloudSample.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace galaxy
{
namespace
{
std::vector<float> helix(std::size_t count)
{
  std::vector<float> position;
  for (std::size_t i = 0; i < count; ++i)
  {
    const float t = static_cast<float>(i);
    position.insert(position.end(), { std::cos(t), std::sin(t), 1e-3F * t });
  }
  return position;
}

std::vector<float> sorted(const CloudSample& sample)
{
  std::vector<float> all;
  for (const std::vector<float>& piece : sample.pieces())
  {
    all.insert(all.end(), piece.begin(), piece.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}
} // namespace

// A thread's room follows from the team that works, not from the largest that could.
TEST(CloudSample, IsTheSameForAnyTeam)
{
  const std::vector<float> position = helix(200000);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const CloudSample alone(position.data(), 200000, 60000);
  EXPECT_EQ(alone.share(), 0.25);
  EXPECT_NEAR(alone.size() / 50000.0, 1, 0.03);
  omp_set_num_threads(4);
  std::vector<float> within;
  // In here a team of one: levels of teams within teams are off.
  omp_set_max_active_levels(1);
#pragma omp parallel num_threads(2)
#pragma omp single
  within = sorted(CloudSample(position.data(), 200000, 60000));
  EXPECT_EQ(within, sorted(alone));
  EXPECT_EQ(sorted(CloudSample(position.data(), 200000, 60000)), sorted(alone));
  omp_set_num_threads(threads);
}

TEST(CloudSample, CountlessParticlesInOnePlaceAreBoundedAlikeForAnyThreads)
{
  // The hash of the origin has no bit set: it is chosen every time.
  const std::size_t count = 400000;
  std::vector<float> position = helix(count);
  std::fill(position.begin(), position.begin() + 3 * count / 2, 0.0F);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const CloudSample alone(position.data(), count, 60000);
  EXPECT_EQ(alone.share(), 0.125);
  EXPECT_LT(alone.size(), 100000u);
  EXPECT_GT(alone.size(), 40000u);
  for (const int n : { 2, 3, 16 })
  {
    omp_set_num_threads(n);
    EXPECT_EQ(sorted(CloudSample(position.data(), count, 60000)), sorted(alone)) << n;
  }
  omp_set_num_threads(threads);
}
} // namespace galaxy
