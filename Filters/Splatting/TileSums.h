#ifndef galaxy_TileSums_h
#define galaxy_TileSums_h

#include <cstddef>

namespace galaxy
{
/// Pixels of a tile along each side: its float sums then stay in the first cache of a core.
constexpr int tileSide = 32;
/// A row of sums, and what a vector that begins in it may touch beyond.
constexpr int tileStride = tileSide + 8;

/// A number for every pixel and channel of a tile.
template <typename Real>
struct TilePlanes
{
  alignas(64) Real values[3][tileSide][tileStride];
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

/// The light of a tile, from the nearest particle to the farthest. With T the transmittance of
/// what is nearer and C the light of all particles so far, undimmed, the picture's light is
///   I = sum T_k (C_k - C_k-1) = T_n C_n + sum C_k (T_k - T_k+1):
/// an emitter only adds to C, and an absorber, often of few pixels, keeps what of C it would hide.
/// Nothing is subtracted but T from T.
///
/// Contributions are added up in float over a few hundred splats at most and then moved to double,
/// where millions of small ones neither drift nor vanish (in float they do: 7 % after 3e7). The
/// transmittance is carried along in float and is made anew from the optical depth at every move.
struct TileSums
{
  TilePlanes<float> recentLight; ///< of C, luminosity per kpc^2, since the last move
  TilePlanes<float> movedLight;  ///< of C before, rounded
  TilePlanes<float> through;     ///< T
  TilePlanes<float> recentKept;  ///< of the sum over absorbers, since the last move
  TilePlanes<float> recentTau;   ///< optical depth since the last move
  TilePlanes<double> light;      ///< C at the last move
  TilePlanes<double> kept;
  TilePlanes<double> tau;
  void clear(TileAbsorption absorption)
  {
    this->recentLight.fill(0);
    this->light.fill(0);
    if (absorption != TileAbsorption::None)
    {
      this->movedLight.fill(0);
      this->through.fill(1);
      this->recentKept.fill(0);
      this->recentTau.fill(0);
      this->kept.fill(0);
      this->tau.fill(0);
    }
  }

  alignas(64) float opaque[tileSide][tileStride]; ///< depth of opaque geometry, as Splat::depth
};
} // namespace galaxy

#endif
