#ifndef galaxy_RenderStatistics_h
#define galaxy_RenderStatistics_h

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace galaxy
{
/// What happened to how many particles.
struct ParticleCounts
{
  std::size_t drawn = 0;   ///< particles that touch the image
  std::size_t culled = 0;  ///< off the image, behind the camera, hidden or without effect
  std::size_t invalid = 0; ///< NaN, infinite or negative where that has no meaning
  std::size_t emitters = 0;
  std::size_t absorbers = 0;
  std::size_t colored = 0; ///< absorbers whose channels differ

  ParticleCounts& operator+=(const ParticleCounts& other)
  {
    this->drawn += other.drawn;
    this->culled += other.culled;
    this->invalid += other.invalid;
    this->emitters += other.emitters;
    this->absorbers += other.absorbers;
    this->colored += other.colored;
    return *this;
  }
};

/// Tiles with absorbers, by what their order needs.
struct OrderNeeds
{
  std::size_t ordered = 0;
  std::size_t oneSource = 0; ///< all splats emit in proportion to what they absorb: no order
  std::size_t thin = 0;      ///< too thin for their order to matter, within what is allowed

  std::size_t unordered() const { return this->oneSource + this->thin; }

  OrderNeeds& operator+=(const OrderNeeds& other)
  {
    this->ordered += other.ordered;
    this->oneSource += other.oneSource;
    this->thin += other.thin;
    return *this;
  }
};

/// How far a picture may be from another, in every pixel and channel: its light by no more than
/// `light` and the share `share` of the light there together, its transmittance by no more than
/// `share`.
struct ErrorBound
{
  double light = 0; ///< luminosity per kpc^2
  double share = 0; ///< a small number
};

/// What a rendering did and what it cost.
struct RenderStatistics : ParticleCounts
{
  OrderNeeds tiles;
  bool bySlices = false;     ///< Overlapping
  std::size_t sampled = 0;   ///< particles that were to stand for all (Preview)
  std::size_t untouched = 0; ///< splats in tiles behind what lets no light through
  std::size_t faint = 0;     ///< splats left out as too faint to matter (Bounded)
  ErrorBound bound;          ///< on the error of what was left out (Bounded)
  std::size_t tooBright = 0; ///< values of radiance beyond single precision, given as its largest
  double thickest = 0;       ///< the largest optical depth of one particle
  double raySums = 0;        ///< sums over particles, pixels and slices (Overlapping): its work
  std::size_t coarse = 0;    ///< tiles with fewer slices than asked for (Overlapping)
  std::vector<std::pair<std::string, double>> seconds; ///< by stage

  /// Adds the seconds of another rendering to those of the same stages.
  void addSeconds(const RenderStatistics& other);
};

/// What a scene called for, in words: "emission; grey absorption; depth order among ...".
std::string activeEffects(const RenderStatistics& statistics);

/// 950, 12 k, 1.2 M.
std::string shortCount(std::size_t count);
} // namespace galaxy

#endif
