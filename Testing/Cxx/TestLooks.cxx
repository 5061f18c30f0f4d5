#include "Filters/Model/ComponentKind.h"
#include "Filters/Model/Looks.h"

#include <gtest/gtest.h>

namespace
{
using namespace galaxy;

/// One component of each kind, in the order of ComponentKind.
std::vector<ComponentInfo> oneOfEach()
{
  std::vector<ComponentInfo> components;
  for (const char* name : { "stars", "Young stars", "bulge", "stellar halo", "M83/gas",
         "H-alpha/HII", "molecular gas", "dust" })
  {
    ComponentInfo component;
    component.name = name;
    component.absorbs = component.name == "dust";
    components.push_back(component);
  }
  return components;
}

TEST(Looks, NamesTellTheKind)
{
  const auto components = oneOfEach();
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    EXPECT_EQ(static_cast<std::size_t>(kindOf(components[k])), k) << components[k].name;
  }
}

std::string shownBy(Look look, std::vector<ComponentInfo> components = oneOfEach())
{
  std::vector<bool> visible;
  applyLook(look, components, visible);
  std::string text;
  for (const bool is : visible)
  {
    text += is ? '1' : '0';
  }
  return text;
}

TEST(Looks, ShowWhatTheyAreNamedFor)
{
  EXPECT_EQ(shownBy(Look::AsDescribed), "11111111");
  EXPECT_EQ(shownBy(Look::Optical), "11110101");
  EXPECT_EQ(shownBy(Look::HAlpha), "00000101");
  EXPECT_EQ(shownBy(Look::AtomicGas), "00001000");
  EXPECT_EQ(shownBy(Look::Ultraviolet), "01000001");
  EXPECT_EQ(shownBy(Look::DustOnly), "00000001");
  EXPECT_EQ(shownBy(Look::FalseColor), "11111111");
}

TEST(Looks, YoungStarsStandForIonizedGasThatThereIsNot)
{
  auto components = oneOfEach();
  components.erase(components.begin() + 5);
  EXPECT_EQ(shownBy(Look::HAlpha, components), "0100001");
}

TEST(Looks, AsDescribedChangesNothing)
{
  auto components = oneOfEach();
  std::vector<bool> visible;
  applyLook(Look::AsDescribed, components, visible);
  for (const ComponentInfo& component : components)
  {
    EXPECT_FALSE(component.isRecolored);
    EXPECT_EQ(component.brightness, 1);
  }
}

TEST(Looks, DustAloneShines)
{
  auto components = oneOfEach();
  std::vector<bool> visible;
  applyLook(Look::DustOnly, components, visible);
  EXPECT_FALSE(components.back().absorbs);
  EXPECT_TRUE(components.back().isRecolored);
}
} // namespace
