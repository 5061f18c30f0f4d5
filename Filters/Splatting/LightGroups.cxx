#include "Filters/Splatting/LightGroups.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <omp.h>

namespace galaxy
{
namespace
{
constexpr std::size_t mostGroups = 16;
constexpr LightGain noLight{ 0, 0, 0 }, asDrawn{ 1, 1, 1 };

/// Multiplies a component's light with a gain that is the same for all channels.
void setGain(ComponentInfo& component, double gain)
{
  component.brightness = gain;
  component.light = 1;
  component.color = { 1, 1, 1 };
}

double mostOf(const LightGain& gain)
{
  return std::max({ gain[0], gain[1], gain[2] });
}

/// Finite and not negative: other light is drawn as invalid, and cannot be multiplied with.
bool isAmount(const LightGain& gain)
{
  return std::all_of(gain.begin(), gain.end(), [](double x) { return x >= 0 && x < 1e30; });
}

/// A picture, and what its light is multiplied with.
using ScaledImage = std::pair<const RenderedImage*, LightGain>;

/// What the parts did together; their seconds, which are of different times, left out.
RenderStatistics statisticsOf(const std::vector<ScaledImage>& parts)
{
  RenderStatistics sum = parts[0].first->statistics;
  sum.seconds.clear();
  sum.bound.light *= mostOf(parts[0].second);
  const std::size_t all = sum.drawn + sum.culled;
  for (std::size_t k = 1; k < parts.size(); ++k)
  {
    const RenderStatistics& part = parts[k].first->statistics;
    // What absorbs is in all of them.
    sum.drawn += part.drawn - part.absorbers;
    sum.emitters += part.emitters;
    sum.tiles = part.tiles.ordered > sum.tiles.ordered ? part.tiles : sum.tiles;
    sum.untouched += part.untouched;
    sum.faint += part.faint;
    sum.tooBright += part.tooBright;
    sum.bound.light += mostOf(parts[k].second) * part.bound.light;
    sum.bound.share = std::max(sum.bound.share, part.bound.share);
    sum.coarse = std::max(sum.coarse, part.coarse);
    sum.raySums += part.raySums;
  }
  sum.culled = all - sum.drawn;
  return sum;
}

std::shared_ptr<RenderedImage> sumOf(const std::vector<ScaledImage>& parts)
{
  auto sum = std::make_shared<RenderedImage>();
  const RenderedImage& first = *parts[0].first;
  sum->width = first.width;
  sum->height = first.height;
  sum->transmittance = first.transmittance;
  sum->radiance.resize(first.radiance.size());
  const std::ptrdiff_t pixels = static_cast<std::ptrdiff_t>(first.radiance.size() / 3);
#pragma omp parallel for
  for (std::ptrdiff_t pixel = 0; pixel < pixels; ++pixel)
  {
    for (int c = 0; c < 3; ++c)
    {
      double light = 0;
      for (const ScaledImage& part : parts)
      {
        light += part.second[c] * part.first->radiance[3 * pixel + c];
      }
      // As bright as single precision can have it, see toSingle().
      sum->radiance[3 * pixel + c] =
        static_cast<float>(std::min<double>(light, std::numeric_limits<float>::max()));
    }
  }
  sum->statistics = statisticsOf(parts);
  return sum;
}
} // namespace

void ComponentLights::add(const std::vector<ComponentInfo>& components,
  const std::vector<bool>& visible, bool keepsColors, bool hasAbsorption)
{
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    const ComponentInfo& info = components[k];
    const bool scalesColor = info.isRecolored && !keepsColors;
    LightGain gain;
    for (int c = 0; c < 3; ++c)
    {
      gain[c] = visible[k] ? info.brightness * info.light * (scalesColor ? info.color[c] : 1) : 0;
    }
    const bool isLight = !info.absorbs && !hasAbsorption && isAmount(gain);
    this->gains.push_back(isLight ? std::optional<LightGain>(gain) : std::nullopt);
    this->others.insert(
      this->others.end(), { double(isLight), info.size, double(info.isRecolored) });
    if (!scalesColor || !isLight)
    {
      this->others.insert(this->others.end(), info.color.begin(), info.color.end());
    }
    if (!isLight)
    {
      this->others.insert(this->others.end(),
        { double(info.absorbs), double(visible[k]), info.brightness, info.light });
      this->others.insert(this->others.end(), info.absorption.begin(), info.absorption.end());
    }
  }
}

std::shared_ptr<const RenderedImage> LightGroups::render(const ParticleView& particles,
  const LightGains& gains, const Camera& camera, const RenderOptions& options,
  const ErrorBound& needed)
try
{
  if (this->groups.empty() || !this->split(gains))
  {
    this->begin(gains);
  }
  this->shown = gains;
  const bool isBounded = options.accuracy == Accuracy::Bounded;
  std::vector<std::size_t> awaited;
  for (std::size_t k = 0; k < this->groups.size(); ++k)
  {
    Group& group = this->groups[k];
    if (group.image && isBounded && !this->serves(group, gains, needed))
    {
      group.image = nullptr;
    }
    if (!group.image && this->isWanted(k, gains))
    {
      awaited.push_back(k);
    }
  }
  RenderStatistics drawings;
  for (std::size_t n = 0; n < awaited.size(); ++n)
  {
    RenderOptions part = options;
    const double count = double(awaited.size());
    part.progress = partOf(options.progress, double(n) / count, double(n + 1) / count);
    auto image = this->draw(awaited[n], particles, gains, camera, part);
    if (image->aborted)
    {
      return image;
    }
    drawings.addSeconds(image->statistics);
  }
  return this->combine(gains, drawings);
}
catch (...)
{
  this->clear(); // groups may be half parted
  throw;
}

bool LightGroups::has(const LightGains& gains, const ErrorBound& needed) const
{
  for (std::size_t k = 0; k < this->groups.size(); ++k)
  {
    const Group& group = this->groups[k];
    const bool serves =
      group.image && this->ratio(group.members, gains) && this->serves(group, gains, needed);
    if (!serves && this->isWanted(k, gains))
    {
      return false;
    }
  }
  return !this->groups.empty();
}

/// With one group of all components, to be drawn.
void LightGroups::begin(const LightGains& gains)
{
  this->groups.assign(1, Group());
  this->groups[0].members.resize(gains.size());
  std::iota(this->groups[0].members.begin(), this->groups[0].members.end(), 0);
  this->drawn.assign(gains.size(), noLight);
}

/// Parts groups of which some members changed by the same factor and the others not at all. False
/// where more has changed than that.
bool LightGroups::split(const LightGains& gains)
{
  const std::size_t before = this->groups.size();
  for (std::size_t k = 0; k < before; ++k)
  {
    const Group group = this->groups[k];
    if (!group.image || this->ratio(group.members, gains))
    {
      continue;
    }
    this->groups[k].image = nullptr;
    Group changed;
    std::vector<std::size_t> rest;
    for (const std::size_t member : group.members)
    {
      const bool isSame = gains[member] == this->shown[member];
      (isSame ? rest : changed.members).push_back(member);
    }
    if (rest.empty())
    {
      if (group.members.size() > 1)
      {
        return false;
      }
      continue;
    }
    if (changed.members.size() > 1 && !this->ratio(changed.members, gains))
    {
      return false;
    }
    this->groups[k].members = rest;
    this->groups.push_back(changed);
  }
  return this->groups.size() <= mostGroups;
}

/// How much brighter all of these components are than drawn; none where they do not agree.
std::optional<LightGain> LightGroups::ratio(
  const std::vector<std::size_t>& members, const LightGains& gains) const
{
  std::array<std::optional<double>, 3> ratios;
  for (const std::size_t member : members)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double was = gains[member] ? this->drawn[member][c] : 1;
      const double is = gains[member] ? (*gains[member])[c] : 1;
      if (was == 0 && is == 0)
      {
        continue;
      }
      const double ratio = is / was;
      if (was == 0 || (ratios[c] && std::abs(ratio - *ratios[c]) > 1e-12 * *ratios[c]))
      {
        return std::nullopt;
      }
      ratios[c] = ratio;
    }
  }
  // What has no light may be multiplied with anything.
  return LightGain{ ratios[0].value_or(1), ratios[1].value_or(1), ratios[2].value_or(1) };
}

/// The first one is, for what it dims the light behind all by.
bool LightGroups::isWanted(std::size_t group, const LightGains& gains) const
{
  const std::vector<std::size_t>& members = this->groups[group].members;
  return group == 0 || std::any_of(members.begin(), members.end(), [&](std::size_t member) {
    return gains[member] != noLight;
  });
}

/// Whether a group's picture is as exact as it has to be.
bool LightGroups::serves(
  const Group& group, const LightGains& gains, const ErrorBound& needed) const
{
  return mostOf(*this->ratio(group.members, gains)) * group.allowed.light <=
    needed.light / double(this->groups.size()) &&
    group.allowed.share <= needed.share;
}

std::shared_ptr<const RenderedImage> LightGroups::draw(std::size_t group_,
  const ParticleView& particles, const LightGains& gains, const Camera& camera,
  const RenderOptions& options_)
{
  Group& group = this->groups[group_];
  RenderOptions options = options_;
  options.allowed.light /= double(this->groups.size());
  std::vector<ComponentInfo> components = *particles.components;
  std::vector<bool> visible = *particles.visible;
  const auto has = [&group](std::size_t k) {
    return std::find(group.members.begin(), group.members.end(), k) != group.members.end();
  };
  for (std::size_t k = 0; k < components.size(); ++k)
  {
    visible[k] = visible[k] && (!gains[k] || has(k));
    components[k].light *= has(k);
    this->drawn[k] = has(k) ? gains[k].value_or(asDrawn) : this->drawn[k];
  }
  // One that is alone, white: of any colour by its gain.
  if (const std::size_t alone = group.members[0]; group.members.size() == 1 && gains[alone])
  {
    const double most = mostOf(*gains[alone]);
    setGain(components[alone], most);
    this->drawn[alone] = { most, most, most };
  }
  ParticleView view = particles;
  view.components = &components;
  view.visible = &visible;
  auto image = std::make_shared<RenderedImage>(galaxy::render(view, camera, options));
  group.image = image->aborted ? nullptr : image;
  group.allowed = options.allowed;
  return image;
}

/// The sum of the groups' pictures, each as bright as its light now is, of which these were drawn
/// for it.
std::shared_ptr<const RenderedImage> LightGroups::combine(
  const LightGains& gains, const RenderStatistics& drawings)
{
  const double start = omp_get_wtime();
  std::vector<ScaledImage> parts;
  this->sum = {};
  for (std::size_t k = 0; k < this->groups.size(); ++k)
  {
    const Group& group = this->groups[k];
    if (this->isWanted(k, gains))
    {
      parts.emplace_back(group.image.get(), *this->ratio(group.members, gains));
      this->sum.light += mostOf(parts.back().second) * group.allowed.light;
      this->sum.share = std::max(this->sum.share, group.allowed.share);
    }
  }
  if (parts.size() == 1 && parts[0].second == asDrawn && !drawings.seconds.empty())
  {
    return this->groups[0].image;
  }
  auto image = sumOf(parts);
  image->statistics.seconds = drawings.seconds;
  image->statistics.seconds.emplace_back("combine", omp_get_wtime() - start);
  return image;
}
} // namespace galaxy
