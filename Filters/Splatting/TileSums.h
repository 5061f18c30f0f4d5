#ifndef galaxy_TileSums_h
#define galaxy_TileSums_h

#include "Filters/Splatting/Knobs.h"

#include <cmath>
#include <cstddef>

namespace galaxy
{
/// A row of sums, and what a vector that begins in it may touch beyond.
constexpr int tileStride = tileSide + 8;

/// A number for every pixel and channel of a tile.
template <typename Real>
struct TilePlanes
{
  alignas(64) Real values[3][tileSide][tileStride];
  /// `place` is a row times the stride plus a column.
  Real* at(int channel, int place) { return &this->values[channel][0][0] + place; }
  const Real* at(int channel, int place) const { return &this->values[channel][0][0] + place; }
  void fill(Real value)
  {
    for (auto& plane : this->values)
    {
      for (auto& row : plane)
      {
        for (Real& v : row)
        {
          v = value;
        }
      }
    }
  }
};

/// Which absorption a tile needs: as many planes of transmittance are kept.
enum class TileAbsorption
{
  None,
  Grey, ///< the first channel stands for all
  Color,
};

/// What comes from the splats of a tile, and how much they dim what is behind them.
struct TileLight
{
  TilePlanes<SpanSum> light; ///< luminosity per kpc^2
  TilePlanes<SpanSum> tau;   ///< optical depth

  void clear() { this->light.fill(0), this->tau.fill(0); }
  /// Adds what lies behind.
  void add(const TileLight& behind, TileAbsorption absorption)
  {
    for (int c = 0; c < 3; ++c)
    {
      const int plane = absorption == TileAbsorption::Color ? c : 0;
      for (int y = 0; y < tileSide; ++y)
      {
        for (int x = 0; x < tileSide; ++x)
        {
          const double T =
            absorption == TileAbsorption::None ? 1 : std::exp(-this->tau.values[plane][y][x]);
          this->light.values[c][y][x] += T * behind.light.values[c][y][x];
        }
      }
    }
    for (int plane = 0; plane < 3 && absorption != TileAbsorption::None; ++plane)
    {
      for (int y = 0; y < tileSide; ++y)
      {
        for (int x = 0; x < tileSide; ++x)
        {
          this->tau.values[plane][y][x] += behind.tau.values[plane][y][x];
        }
      }
    }
  }
};

/// The light of a tile, from the nearest particle to the farthest, in spans of some hundred splats.
/// With e_k the light of a span's splats in their order, t_k their optical depths and T the
/// transmittance of all spans before, a pixel gains
///   T sum e_k exp(-(t_1 + ... + t_k)) = T exp(-tau) (E + X),
///   E = sum e_k,  X = sum e_k (exp(t_k+1 + t_k+2 + ...) - 1),  tau = sum t_k.
/// An emitter only adds to E; an absorber adds t to tau and (E + X)(exp(t) - 1) to X. No term is
/// negative, and an absorber is not lost beside 1, however thin.
///
/// A span is added up in float and then moved to double, where millions of small contributions
/// neither drift nor vanish (in float they do: 7 % after 3e7).
struct TileSums
{
  TilePlanes<float> emitted; ///< E, luminosity per kpc^2
  TilePlanes<float> surplus; ///< X
  TilePlanes<float> depth;   ///< tau
  TilePlanes<float> before;  ///< E and what is still to be added to it, where that is asked for
  TilePlanes<float> through; ///< T
  TileLight all;             ///< spans before
  void clear(TileAbsorption absorption)
  {
    this->emitted.fill(0);
    this->all.light.fill(0);
    if (absorption != TileAbsorption::None)
    {
      this->surplus.fill(0);
      this->depth.fill(0);
      this->through.fill(1);
      this->all.tau.fill(0);
    }
  }

  alignas(64) float opaque[tileSide][tileStride]; ///< of opaque geometry, kpc
};
} // namespace galaxy

#endif
