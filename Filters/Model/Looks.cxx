#include "Filters/Model/Looks.h"

#include "Filters/Model/ComponentKind.h"

#include <algorithm>
#include <array>
#include <set>

namespace galaxy
{
namespace
{
using Color = std::array<double, 3>;
using Kind = ComponentKind;
constexpr Color hAlphaRed = { 1, 0.2, 0.25 }, hydrogenBlue = { 0.35, 0.55, 1 },
                ultraviolet = { 0.55, 0.65, 1 }, dustBrown = { 1, 0.62, 0.35 };
/// A(1500 A) / A(V) of the Milky Way's mean law, R_V = 3.1 (Cardelli, Clayton, Mathis 1989).
constexpr double ultravioletExtinction = 2.6;

Color falseColorOf(Kind kind)
{
  switch (kind)
  {
    case Kind::YoungStars:
      return { 0.6, 0.75, 1 };
    case Kind::Bulge:
      return { 1, 0.78, 0.45 };
    case Kind::Halo:
      return { 0.8, 0.7, 1 };
    case Kind::AtomicGas:
      return { 0.2, 0.4, 1 };
    case Kind::IonizedGas:
      return { 1, 0.3, 0.55 };
    case Kind::MolecularGas:
      return { 0.25, 1, 0.5 };
    default:
      return { 1, 0.9, 0.7 };
  }
}

void recolor(ComponentInfo& component, const Color& color)
{
  component.isRecolored = true;
  component.color = color;
}

/// All that a look shows.
std::set<Kind> kindsOf(Look look, bool hasIonizedGas)
{
  switch (look)
  {
    case Look::Optical:
      return { Kind::Stars, Kind::YoungStars, Kind::Bulge, Kind::Halo, Kind::IonizedGas,
        Kind::Dust };
    case Look::HAlpha:
      return { hasIonizedGas ? Kind::IonizedGas : Kind::YoungStars, Kind::Dust };
    case Look::AtomicGas:
      return { Kind::AtomicGas };
    case Look::Ultraviolet:
      return { Kind::YoungStars, Kind::Dust };
    default:
      return { Kind::Dust };
  }
}

void color(Look look, Kind kind, ComponentInfo& component)
{
  const bool isDust = kind == Kind::Dust;
  if (look == Look::DustOnly)
  {
    // Its cross-section is drawn as luminosity, its optical depth as radiance.
    component.absorbs = false;
    recolor(component, dustBrown);
  }
  else if (look == Look::Ultraviolet && isDust)
  {
    component.brightness *= ultravioletExtinction;
    recolor(component, { 1, 1, 1 });
  }
  else if (look == Look::FalseColor && !isDust)
  {
    recolor(component, falseColorOf(kind));
  }
  else if (look == Look::HAlpha && !isDust)
  {
    recolor(component, hAlphaRed);
  }
  else if (look == Look::AtomicGas)
  {
    recolor(component, hydrogenBlue);
  }
  else if (look == Look::Ultraviolet)
  {
    recolor(component, ultraviolet);
  }
}
} // namespace

void applyLook(Look look, std::vector<ComponentInfo>& components, std::vector<bool>& visible)
{
  const auto isIonized = [](const ComponentInfo& component) {
    return kindOf(component) == Kind::IonizedGas;
  };
  const std::set<Kind> shown =
    kindsOf(look, std::any_of(components.begin(), components.end(), isIonized));
  const bool showsAll = look == Look::AsDescribed || look == Look::FalseColor;
  visible.resize(components.size(), true);
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    const Kind kind = kindOf(components[k]);
    if (!showsAll && shown.count(kind) == 0)
    {
      visible[k] = false;
      continue;
    }
    color(look, kind, components[k]);
  }
}
} // namespace galaxy
