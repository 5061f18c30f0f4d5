#ifndef galaxy_TileComposite_h
#define galaxy_TileComposite_h

#include "Filters/Splatting/DepthOrder.h"
#include "Filters/Splatting/Projection.h"
#include "Filters/Splatting/Render.h"
#include "Filters/Splatting/Splat.h"
#include "Filters/Splatting/TileGrid.h"
#include "Filters/Splatting/TileSums.h"

#include <cstddef>

namespace galaxy
{
/// The splats of a tile and how to draw them.
struct TileTask
{
  const Splat* splats = nullptr;
  const std::uint32_t* particles = nullptr; ///< that they are
  const KeyedSlot* order = nullptr;         ///< from the nearest to the farthest; null: as they lie
  std::size_t count = 0;
  PixelBox pixels;          ///< of the tile that lie in the picture
  int left = 0, bottom = 0; ///< the tile's corner in the picture
  Kernel kernel = Kernel::Gaussian;
  TileAbsorption absorption = TileAbsorption::None;
  bool isOneSource = false; ///< then only optical depths are added up, as if they were light
  double source[3] = {};    ///< that all have: luminosity per kpc^2 where it is opaque
  bool hasOpaque = false;
  /// No splat's light over a pixel is more than this in any channel, luminosity per kpc^2.
  float brightest = 0;
  /// What is left is left away where it cannot add more, luminosity per kpc^2, and no more than
  /// such a transmittance is left.
  float negligible = 0;
  float opaque = 0;
  const Projection* projection = nullptr; ///< that knows the light of slabs
};

/// Adds the splats to the sums, which hold nothing before (clear()): light, kept, tau and through
/// are complete then. How many of them, from the nearest on, it took. Compiled for several
/// instruction sets, of which the best that the machine has is used; their pictures agree to 1e-6.
std::size_t compositeTile(const TileTask& task, TileSums& sums);
} // namespace galaxy

#endif
