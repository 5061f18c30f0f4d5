#ifndef galaxy_LightGroups_h
#define galaxy_LightGroups_h

#include "Filters/Splatting/Render.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace galaxy
{
/// What a component's light is multiplied with, by channel: visibility, brightness and colour.
using LightGain = std::array<double, 3>;

/// By component; none for what also absorbs.
using LightGains = std::vector<std::optional<LightGain>>;

/// A component table as a picture depends on it: on what emits alone by a factor, whatever lies
/// before it.
struct ComponentLights
{
  LightGains gains;
  std::vector<double> others; ///< all that is not among the gains

  /// `keepsColors` and `hasAbsorption` say whether the particles' light has the colours of an array
  /// of emission, and whether they have one of absorption.
  void add(const std::vector<ComponentInfo>& components, const std::vector<bool>& visible,
    bool keepsColors, bool hasAbsorption);
};

/// A picture in parts, one for the light of each group of components whose gains were always
/// changed together, dimmed by all that absorbs: the sum of the parts, each times what its gain has
/// changed by, is the picture. A component's first change draws it and its group anew, later ones
/// nothing.
class LightGroups
{
public:
  /// As galaxy::render(), of particles with a component table and visibilities, of which only
  /// `gains` may have changed since the last picture, or clear(). With accuracy level `Bounded`
  /// within `needed`; what is drawn is drawn within `options.allowed`, which should be less.
  std::shared_ptr<const RenderedImage> render(const ParticleView& particles,
    const LightGains& gains, const Camera& camera, const RenderOptions& options,
    const ErrorBound& needed);

  void clear() { this->groups.clear(); }

  /// Whether render() would draw nothing.
  bool has(const LightGains& gains, const ErrorBound& needed) const;

  /// What the last picture may be off by at accuracy level `Bounded`.
  const ErrorBound& bound() const { return this->sum; }

private:
  struct Group
  {
    std::vector<std::size_t> members;           ///< components
    std::shared_ptr<const RenderedImage> image; ///< null: to be drawn where its light is wanted
    ErrorBound allowed;
  };

  void begin(const LightGains& gains);
  bool split(const LightGains& gains);
  std::optional<LightGain> ratio(
    const std::vector<std::size_t>& members, const LightGains& gains) const;
  bool isWanted(std::size_t group, const LightGains& gains) const;
  bool serves(const Group& group, const LightGains& gains, const ErrorBound& needed) const;
  std::shared_ptr<const RenderedImage> draw(std::size_t group, const ParticleView& particles,
    const LightGains& gains, const Camera& camera, const RenderOptions& options);
  std::shared_ptr<const RenderedImage> combine(
    const LightGains& gains, const RenderStatistics& drawings);

  std::vector<Group> groups;    ///< what also absorbs is in the first one
  std::vector<LightGain> drawn; ///< the gains that the groups' pictures have, by component
  LightGains shown;             ///< those of the last picture
  ErrorBound sum;
};
} // namespace galaxy

#endif
