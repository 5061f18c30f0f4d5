#include "Testing/Cxx/DustFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
TEST(FractalDust, CloudsLieOnTheWarpedDiscAndKeepTheCrossSection)
{
  ComponentDescription component = dustDisk();
  component.outerRadius = 20;
  component.dust.model = DustModel::Fractal;
  component.dust.children = 10;
  component.dust.scaleHeight = 0.1;
  const Filaments clouds(m83Rings(), component, 20000);
  ASSERT_EQ(clouds.particles.size(), 10 * clouds.seeds.size());
  double squares = 0, light = 0, seeds = 0, apart = 0;
  for (std::size_t i = 0; i < clouds.seeds.size(); ++i)
  {
    seeds += 2.5 * clouds.seeds.light[i];
    for (std::uint64_t k = clouds.starts[i]; k < clouds.starts[i + 1]; ++k)
    {
      const Vec3 p = clouds.position(k);
      light += clouds.particles.intensity[k];
      EXPECT_LT(length(p), 20.01);
      double r = length(p);
      for (int repeat = 0; repeat < 3; ++repeat)
      {
        const double height = dot(p, clouds.disk.frame(r).n);
        r = std::sqrt(dot(p, p) - height * height);
      }
      squares += std::pow(dot(p, clouds.disk.frame(r).n), 2);
      const Vec3 seed = clouds.disk.position(clouds.seeds.radius[i], clouds.seeds.azimuth[i]);
      apart = std::max(apart, length(p - seed));
    }
  }
  EXPECT_NEAR(std::sqrt(squares / clouds.particles.size()) / 0.1, 1, 0.01);
  EXPECT_NEAR(light / seeds, 1, 1e-5) << "all of it";
  EXPECT_LT(apart, 1);
  // The share of a particle within its seed's light is the cloud's density there.
  double mean = 0, variance = 0;
  for (std::size_t i = 0; i < clouds.seeds.size(); ++i)
  {
    const double w = clouds.particles.intensity[clouds.starts[i]] / (0.25 * clouds.seeds.light[i]);
    mean += w / clouds.seeds.size();
    variance += w * w / clouds.seeds.size();
  }
  EXPECT_NEAR((variance - mean * mean) / std::expm1(1.0), 1, 0.3);
}
} // namespace galaxy
