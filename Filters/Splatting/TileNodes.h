#ifndef galaxy_TileNodes_h
#define galaxy_TileNodes_h

#include "Filters/Splatting/Camera.h"
#include "Filters/Splatting/Knobs.h"

namespace galaxy
{
/// Chebyshev's nodes of a tile, from whose values a polynomial gives those of all pixels.
struct TileNodes
{
  static constexpr int side = 8;
  static constexpr int size = side * side;

  float place[side];                       ///< along an axis, pixels from the tile's corner
  alignas(64) float share[side][tileSide]; ///< of a node in the pixels of the axis

  TileNodes();

  /// Whether they tell what a NearParticle's pixels have to 1e-7 of its peak, the kernel's last
  /// e^-9 aside: its sigma is a sixth of its distance or more, and half a tile then no more than a
  /// third of sigma; or it is farther and at the side, where rays lie closer together.
  static bool suffice(const Camera& camera) { return camera.scale >= 9.0 * tileSide; }
};
extern const TileNodes tileNodes;
} // namespace galaxy

#endif
