// Several sets of particles drawn as one.
#include "Filters/Splatting/JointParticles.h"
#include "Filters/Splatting/Render.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

/// Particles of one scene in two, and with Intensity and Color where they only emit.
TEST(JointParticles, TwoHalvesDrawnTogetherAreTheWhole)
{
  const Scene whole = randomScene(2000, true);
  std::vector<int> even, odd;
  for (int i = 0; i < 2000; ++i)
  {
    (i % 2 ? odd : even).push_back(i);
  }
  const Scene halves[] = { whole.inOrder(even), whole.inOrder(odd) };
  const std::vector<ParticleView> parts = { halves[0].view(), halves[1].view() };
  JointParticles joint(parts);
  const auto together = renderSorted(joint.view(parts), testCamera(false), {});
  const auto expected = renderSorted(whole.view(), testCamera(false), {});
  EXPECT_LE(
    largestDifference(together.radiance, expected.radiance), 1e-6 * largest(expected.radiance));
  EXPECT_LE(largestDifference(together.transmittance, expected.transmittance), 1e-6);
}

/// Stars given by Intensity and Color, and a wall by its Absorption.
struct StarsAndWall
{
  const float star[6] = { 0, 0, 1, 0.5F, 0, -1 };
  const float starRadius[2] = { 0.3F, 0.3F };
  const float intensity[2] = { 1, 2 };
  const std::uint8_t color[6] = { 255, 0, 0, 0, 0, 255 };
  const std::uint8_t component[2] = { 0, 1 };
  std::vector<ComponentInfo> components{ 2 };
  const float wall[3] = { 0, 0, 0 };
  const float wallRadius[1] = { 30 };
  const float absorption[1] = { 1e5F };
  std::vector<ParticleView> parts{ 2 };

  StarsAndWall()
  {
    this->parts[0].size = 2;
    this->parts[0].position = this->star;
    this->parts[0].smoothingLength = this->starRadius;
    this->parts[0].intensity = this->intensity;
    this->parts[0].color = this->color;
    this->parts[0].component = this->component;
    this->parts[0].components = &this->components;
    this->parts[1].size = 1;
    this->parts[1].position = this->wall;
    this->parts[1].smoothingLength = this->wallRadius;
    this->parts[1].absorption = this->absorption;
    this->parts[1].absorptionChannels = 1;
  }
  /// The light of each channel on all pixels of 0.1 kpc.
  std::array<double, 3> light(JointParticles& joint)
  {
    const auto image = renderSorted(joint.view(this->parts), testCamera(true), {});
    std::array<double, 3> sum{};
    for (std::size_t k = 0; k < image.radiance.size(); ++k)
    {
      sum[k % 3] += 0.01 * image.radiance[k];
    }
    return sum;
  }
};

TEST(JointParticles, AWallHidesOnlyTheStarsBehindIt)
{
  StarsAndWall scene;
  EXPECT_TRUE(JointParticles::keepsColors(scene.parts));
  JointParticles joint(scene.parts);
  const auto light = scene.light(joint);
  EXPECT_NEAR(light[0], 1, 1e-4);
  EXPECT_NEAR(light[1], 0, 1e-12);
  EXPECT_LT(light[2], 1e-3); // e^-tau, tau above 30
}

TEST(JointParticles, ComponentsMayChangeAfterwards)
{
  StarsAndWall scene;
  JointParticles joint(scene.parts);
  scene.components[0].brightness = 3;
  EXPECT_NEAR(scene.light(joint)[0], 3, 3e-4);
  scene.components[0].light = 2;
  EXPECT_NEAR(scene.light(joint)[0], 6, 6e-4);
  const std::vector<bool> shown{ false, true };
  scene.parts[0].visible = &shown;
  EXPECT_EQ(scene.light(joint)[0], 0);
}

TEST(JointParticles, WithIntensityAndColorTheyKeepThem)
{
  StarsAndWall scene;
  scene.parts[1] = scene.parts[0];
  EXPECT_FALSE(JointParticles::keepsColors(scene.parts));
  JointParticles joint(scene.parts);
  const ParticleView view = joint.view(scene.parts);
  ASSERT_EQ(view.size, 4U);
  EXPECT_EQ(view.component[3], 3);
  EXPECT_EQ(view.emission, nullptr);
  auto light = scene.light(joint);
  EXPECT_NEAR(light[0], 2, 2e-4);
  EXPECT_NEAR(light[2], 4, 4e-4);
  scene.components[1].isRecolored = true;
  scene.components[1].color = { 0, 1, 0.25 };
  light = scene.light(joint);
  EXPECT_NEAR(light[1], 4, 4e-4);
  EXPECT_NEAR(light[2], 1, 1e-4);
}

TEST(JointParticles, MoreThan256ComponentsAreRefused)
{
  StarsAndWall scene;
  scene.components.resize(200);
  scene.parts[1] = scene.parts[0];
  EXPECT_ANY_THROW(JointParticles{ scene.parts });
}
} // namespace
