#ifndef galaxy_TileImage_h
#define galaxy_TileImage_h

#include "Filters/Splatting/Footprint.h"

#include <cstring>

namespace galaxy
{
/// The light and optical depth gathered so far in the pixels of one tile, channels side by side.
/// Emission is added up in float over a few hundred splats at most and then moved to double, where
/// millions of small contributions neither drift nor vanish (in float they do: 7 % after 3e7).
class TileImage
{
public:
  void clear() { std::memset(this, 0, sizeof(*this)); }

  /// Adds an emitter without absorption: I <- I + e.
  template <bool hasOpaque, class Footprint>
  GALAXY_INLINE void emit(const Splat& splat, const Footprint& footprint)
  {
    const TileBox box = footprint.box;
    const Lanes e = { splat.e[0], splat.e[1], splat.e[2] };
    const int steps = box.steps();
    for (int s = 0; s < steps; ++s)
    {
      const auto weights = footprint.step(s);
      const Lanes color = channelPattern(e, s % 3);
      const int offset = box.y0 * tileStride + 3 * box.x0 + laneCount * s;
      float* recent = this->recent[0] + offset;
      const float* opaque = this->opaque[0] + offset;
      for (int y = 0; y < box.rows; ++y)
      {
        Lanes w = weights(y);
        if (hasOpaque)
        {
          w = loadLanes(opaque + tileStride * y) < splat.depth ? Lanes{} : w;
        }
        storeLanes(recent + tileStride * y, loadLanes(recent + tileStride * y) + color * w);
      }
    }
    if (++this->pending == flushInterval)
    {
      this->flush();
    }
  }

  /// Passes the light gathered so far through a particle: I <- I e^-t + e phi(t).
  template <bool hasOpaque, class Footprint>
  GALAXY_INLINE void absorb(const Splat& splat, const Footprint& footprint)
  {
    const TileBox box = footprint.box;
    const Lanes e = { splat.e[0], splat.e[1], splat.e[2] };
    const Lanes t = { splat.t[0], splat.t[1], splat.t[2] };
    const int steps = box.steps();
    for (int s = 0; s < steps; ++s)
    {
      const auto weights = footprint.step(s);
      const Lanes emission = channelPattern(e, s % 3);
      const Lanes absorption = channelPattern(t, s % 3);
      for (int y = 0; y < box.rows; ++y)
      {
        const int offset = (box.y0 + y) * tileStride + 3 * box.x0 + laneCount * s;
        Lanes w = weights(y);
        if (hasOpaque)
        {
          w = loadLanes(this->opaque[0] + offset) < splat.depth ? Lanes{} : w;
        }
        this->throughSlab(offset, emission * w, absorption * w);
      }
    }
  }

  /// Moves what float holds to double.
  GALAXY_INLINE void flush()
  {
    for (int y = 0; y < tileHeight; ++y)
    {
#pragma omp simd
      for (int i = 0; i < tileStride; ++i)
      {
        this->light[y][i] += this->recent[y][i];
        this->recent[y][i] = 0;
      }
    }
    this->pending = 0;
  }

  static constexpr int flushInterval = 512;

  alignas(64) float recent[tileHeight][tileStride];
  alignas(64) double light[tileHeight][tileStride]; ///< luminosity per kpc^2
  alignas(64) double tau[tileHeight][tileStride];   ///< optical depth
  alignas(64) float opaque[tileHeight][tileStride]; ///< depth of opaque geometry, kpc
  int pending;

private:
  GALAXY_INLINE void throughSlab(int offset, Lanes e, Lanes t)
  {
    const SlabLanes slab = slabLanes(t);
    alignas(64) float depth[laneCount];
    alignas(64) float emitted[laneCount];
    alignas(64) float base[laneCount];
    alignas(64) float change[laneCount];
    storeLanes(depth, t);
    storeLanes(emitted, e * slab.escape);
    storeLanes(base, slab.base);
    storeLanes(change, slab.change);
    float* recent = this->recent[0] + offset;
    double* light = this->light[0] + offset;
    double* tau = this->tau[0] + offset;
#pragma omp simd
    for (int i = 0; i < laneCount; ++i)
    {
      const double before = light[i] + recent[i];
      light[i] = before * base[i] + before * change[i] + emitted[i];
      recent[i] = 0;
      tau[i] += depth[i];
    }
  }
};
} // namespace galaxy

#endif
