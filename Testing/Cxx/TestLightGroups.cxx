// Components' light changes without drawing, and the picture is what drawing would show.
#include "Filters/Splatting/LightGroups.h"
#include "RenderFixtures.h"

#include <gtest/gtest.h>

#include <random>

namespace
{
using namespace galaxy;

/// Three emitting components and dust, mixed, in Intensity and Color.
class Galaxy
{
public:
  enum Names
  {
    stars,
    gas,
    bulge,
    dust
  };
  std::vector<ComponentInfo> components{ 4 };
  std::vector<bool> visible = std::vector<bool>(4, true);
  Accuracy accuracy = Accuracy::Sorted;
  bool keepsColors = false;
  LightGroups groups;

  explicit Galaxy(bool hasDust = true)
  {
    this->components[dust].absorbs = true;
    this->components[dust].absorption = { 0.4, 0.7, 1 };
    this->components[stars].brightness = 2;
    this->visible[dust] = hasDust;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::size_t i = 0; i < 4000; ++i)
    {
      for (const float half : { 12.0F, 9.0F, 6.0F })
      {
        this->position.push_back(half * (2 * uniform(random) - 1));
      }
      this->h.push_back(0.05F * std::pow(30.0F, uniform(random)));
      this->component.push_back(static_cast<std::uint8_t>(i % 4));
      const float area = i % 4 == dust ? this->h.back() * this->h.back() : 1;
      this->intensity.push_back(area * uniform(random));
      for (int c = 0; c < 3; ++c)
      {
        this->color.push_back(static_cast<std::uint8_t>(55 + 200 * uniform(random)));
      }
    }
  }

  ParticleView view() const
  {
    ParticleView view;
    view.size = this->h.size();
    view.position = this->position.data();
    view.smoothingLength = this->h.data();
    view.intensity = this->intensity.data();
    view.color = this->color.data();
    view.component = this->component.data();
    view.components = &this->components;
    view.visible = &this->visible;
    return view;
  }
  RenderOptions options() const
  {
    RenderOptions options;
    options.accuracy = this->accuracy;
    options.allowed = { 1e-4, 1e-4 };
    return options;
  }
  ComponentLights lights() const
  {
    ComponentLights lights;
    lights.add(this->components, this->visible, this->keepsColors, false);
    return lights;
  }
  std::shared_ptr<const RenderedImage> show(const ErrorBound& needed = { 1.6e-3, 4e-4 })
  {
    return this->groups.render(
      this->view(), this->lights().gains, testCamera(false), this->options(), needed);
  }
  /// Shows the galaxy, which has to be what one draws of it; whether something was drawn for it.
  bool drawsFor(const std::string& what)
  {
    SCOPED_TRACE(what);
    const auto image = this->show();
    RenderOptions exactly = this->options();
    exactly.accuracy = Accuracy::Sorted;
    const RenderedImage exact = render(this->view(), testCamera(false), exactly);
    const double brightest = largest(exact.radiance);
    const double tolerance = this->accuracy == Accuracy::Bounded
      ? this->groups.bound().light + this->groups.bound().share * brightest
      : 2e-6 * brightest;
    EXPECT_LE(largestDifference(image->radiance, exact.radiance), tolerance);
    EXPECT_LE(largestDifference(image->transmittance, exact.transmittance), 4e-4);
    if (this->accuracy == Accuracy::Sorted)
    {
      const RenderStatistics &a = image->statistics, &b = exact.statistics;
      EXPECT_EQ(a.drawn, b.drawn);
      EXPECT_EQ(a.emitters, b.emitters);
      EXPECT_EQ(a.absorbers, b.absorbers);
      EXPECT_EQ(a.culled, b.culled);
      EXPECT_EQ(a.invalid, b.invalid);
      EXPECT_EQ(activeEffects(a), activeEffects(b));
    }
    const auto& seconds = image->statistics.seconds;
    return !(seconds.size() == 1 && seconds[0].first == "combine");
  }

private:
  std::vector<float> position, h, intensity;
  std::vector<std::uint8_t> color, component;
};

TEST(LightGroups, AComponentIsDrawnOnceHoweverOftenItsLightChanges)
{
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded })
  {
    for (const bool hasDust : { true, false })
    {
      Galaxy galaxy(hasDust);
      galaxy.accuracy = accuracy;
      EXPECT_TRUE(galaxy.drawsFor("all"));
      EXPECT_FALSE(galaxy.drawsFor("the same again"));
      galaxy.components[Galaxy::stars].brightness = 0.7;
      EXPECT_TRUE(galaxy.drawsFor("darker stars"));
      for (const double brightness : { 0.1, 0.0, 1.9, 2.0, 3.5 })
      {
        galaxy.components[Galaxy::stars].brightness = brightness;
        EXPECT_FALSE(galaxy.drawsFor("stars of " + std::to_string(brightness)));
      }
      galaxy.components[Galaxy::gas].light = 3;
      EXPECT_TRUE(galaxy.drawsFor("brighter gas"));
      galaxy.components[Galaxy::gas].light = 2.5;
      galaxy.components[Galaxy::stars].brightness = 1;
      EXPECT_FALSE(galaxy.drawsFor("stars and gas"));
      galaxy.components[Galaxy::bulge].brightness = 0.5;
      galaxy.drawsFor("a fainter bulge"); // with dust alone in the group that was its own
      galaxy.components[Galaxy::bulge].brightness = 0.25;
      EXPECT_FALSE(galaxy.drawsFor("a still fainter bulge"));
    }
  }
}

TEST(LightGroups, HidingAndShowingAreChangesOfLight)
{
  Galaxy galaxy;
  galaxy.drawsFor("all");
  galaxy.visible[Galaxy::gas] = false;
  EXPECT_TRUE(galaxy.drawsFor("without gas"));
  galaxy.visible[Galaxy::gas] = true;
  EXPECT_TRUE(galaxy.drawsFor("with gas again"));
  galaxy.visible[Galaxy::gas] = false;
  EXPECT_FALSE(galaxy.drawsFor("without it again"));
  galaxy.visible[Galaxy::stars] = galaxy.visible[Galaxy::bulge] = false;
  galaxy.drawsFor("dust alone");
  galaxy.visible[Galaxy::stars] = true;
  galaxy.drawsFor("stars behind dust");
}

TEST(LightGroups, AColorIsAChangeOfLightUnlessAnArrayKeepsIt)
{
  Galaxy galaxy;
  galaxy.drawsFor("all");
  galaxy.components[Galaxy::stars].isRecolored = true;
  galaxy.components[Galaxy::stars].color = { 1, 0, 0.2 };
  // In another scene, since its particles have colours of their own no more.
  galaxy.groups.clear();
  EXPECT_TRUE(galaxy.drawsFor("red stars"));
  galaxy.components[Galaxy::stars].color = { 0.2, 1, 0.1 };
  EXPECT_TRUE(galaxy.drawsFor("green stars"));
  for (const auto& color : { std::array<double, 3>{ 0, 0, 1 }, { 1, 1, 1 }, { 0, 0, 0 } })
  {
    galaxy.components[Galaxy::stars].color = color;
    EXPECT_FALSE(galaxy.drawsFor("stars of other colours"));
  }
  galaxy.keepsColors = true;
  const auto kept = galaxy.lights();
  galaxy.components[Galaxy::stars].color = { 0, 1, 0 };
  EXPECT_EQ(kept.gains, galaxy.lights().gains);
  EXPECT_NE(kept.others, galaxy.lights().others);
}

TEST(LightGroups, ComponentsThatChangeAlikeStayTogether)
{
  Galaxy galaxy;
  galaxy.drawsFor("all");
  galaxy.components[Galaxy::stars].light = galaxy.components[Galaxy::gas].light = 3;
  EXPECT_TRUE(galaxy.drawsFor("another galaxy's exposure"));
  galaxy.components[Galaxy::stars].light = galaxy.components[Galaxy::gas].light = 0.4;
  EXPECT_FALSE(galaxy.drawsFor("another one"));
  galaxy.components[Galaxy::gas].light = 0.2;
  EXPECT_TRUE(galaxy.drawsFor("one of its components"));
  galaxy.components[Galaxy::gas].light = 0.1;
  galaxy.components[Galaxy::stars].light = 0.2;
  EXPECT_FALSE(galaxy.drawsFor("both"));
  galaxy.groups.clear();
  galaxy.drawsFor("all again");
  galaxy.components[Galaxy::gas].light = 1;
  galaxy.components[Galaxy::stars].light = 3;
  EXPECT_TRUE(galaxy.drawsFor("all changed at once"));
}

TEST(LightGroups, WhatAbsorbsBelongsToTheScene)
{
  Galaxy galaxy;
  const auto before = galaxy.lights();
  EXPECT_FALSE(before.gains[Galaxy::dust].has_value());
  const auto change = [&](auto&& how) {
    Galaxy other;
    how(other);
    EXPECT_EQ(other.lights().gains, before.gains);
    EXPECT_NE(other.lights().others, before.others);
  };
  change([](Galaxy& other) { other.components[Galaxy::dust].brightness = 2; });
  change([](Galaxy& other) { other.components[Galaxy::dust].absorption[1] = 0.1; });
  change([](Galaxy& other) { other.visible[Galaxy::dust] = false; });
  change([](Galaxy& other) { other.components[Galaxy::stars].size = 2; });
}

/// What a picture may be off by grows with the light: a component that is to be much brighter is
/// drawn anew, and the picture as exact as asked for.
TEST(LightGroups, TheErrorStaysWithinWhatIsNeeded)
{
  Galaxy galaxy;
  galaxy.accuracy = Accuracy::Bounded;
  galaxy.drawsFor("all");
  galaxy.components[Galaxy::stars].brightness = 1;
  galaxy.drawsFor("darker stars");
  bool isDrawn = false;
  for (double brightness = 2; brightness < 1e4; brightness *= 2)
  {
    galaxy.components[Galaxy::stars].brightness = brightness;
    isDrawn |= galaxy.drawsFor("stars of " + std::to_string(brightness));
    EXPECT_LE(galaxy.groups.bound().light, 1.6e-3);
  }
  EXPECT_TRUE(isDrawn);
  const auto image = galaxy.show({ 1e-5, 1e-6 });
  EXPECT_GT(image->statistics.seconds.size(), 1U);
}

/// Whatever a user does, one thing after another or several at once.
TEST(LightGroups, RandomChangesShowWhatDrawingShows)
{
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded })
  {
    Galaxy galaxy;
    galaxy.accuracy = accuracy;
    std::mt19937 random(3);
    const auto below = [&random](int end) { return static_cast<int>(random() % unsigned(end)); };
    const double factors[] = { 0, 1e-6, 0.3, 1, 1, 7, 1e4, -1, NAN };
    const auto factor = [&] { return factors[below(below(8) == 0 ? 9 : 7)]; };
    std::vector<double> scene = galaxy.lights().others;
    int drawings = 0;
    for (int step = 0; step < 150; ++step)
    {
      for (int changes = 1 + (below(4) == 0) * below(4); changes > 0; --changes)
      {
        const int k = below(below(10) == 0 ? 4 : 3); // dust more rarely
        ComponentInfo& component = galaxy.components[k];
        switch (below(4))
        {
          case 0:
            component.brightness = factor();
            break;
          case 1:
            component.light = factor();
            break;
          case 2:
            component.isRecolored |= below(5) == 0;
            component.color = { 0.5 * below(3), 0.5 * below(3), 0.5 * below(3) };
            break;
          default:
            galaxy.visible[k] = below(2) == 0;
        }
      }
      const std::vector<double> others = galaxy.lights().others;
      if (others != scene)
      {
        galaxy.groups.clear();
        scene = others;
      }
      if (below(10) == 0)
      {
        RenderOptions options = galaxy.options();
        options.progress = [&](double) { return below(4) != 0; };
        galaxy.groups.render(
          galaxy.view(), galaxy.lights().gains, testCamera(false), options, { 1.6e-3, 4e-4 });
      }
      drawings += galaxy.drawsFor("step " + std::to_string(step));
      if (HasFailure())
      {
        return;
      }
    }
    EXPECT_LT(drawings, 100);
    EXPECT_GT(drawings, 20);
  }
}

TEST(LightGroups, AnAbortedDrawingIsMadeUpFor)
{
  Galaxy galaxy;
  galaxy.drawsFor("all");
  galaxy.components[Galaxy::stars].brightness = 1;
  RenderOptions options = galaxy.options();
  double last = 0;
  options.progress = [&last](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.6;
  };
  const auto image = galaxy.groups.render(
    galaxy.view(), galaxy.lights().gains, testCamera(false), options, { 1.6e-3, 4e-4 });
  EXPECT_TRUE(image->aborted);
  EXPECT_TRUE(galaxy.drawsFor("the same"));
  EXPECT_FALSE(galaxy.drawsFor("the same again"));
}
} // namespace
