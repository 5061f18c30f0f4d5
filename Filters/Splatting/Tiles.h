#ifndef galaxy_Tiles_h
#define galaxy_Tiles_h

#include "Filters/Model/WorkProgress.h"
#include "Filters/Splatting/Projection.h"
#include "Filters/Splatting/Splat.h"
#include "Filters/Splatting/SplatMemory.h"
#include "Filters/Splatting/TileGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace galaxy
{
/// The splats of consecutive tiles.
struct TileBand
{
  int firstTile = 0;
  int lastTile = 0;               ///< one beyond
  std::vector<std::size_t> first; ///< of each tile's splats, and of those after the last
  SplatMemory splats;             ///< tile after tile, in a tile by the particles' index
  ParticleCounts counts;          ///< of the particles that have a splat here
  float brightest = 0;            ///< the largest luminosity of a splat over a pixel's area
};

/// What a picture is made in: 16 bytes a particle, or 64 MB.
struct RenderMemory
{
  Buffer<std::uint32_t> home; ///< a TileHome of every particle
  TileBand band;
};

/// Deals the particles of a picture to its tiles, as many tiles at a time as fit into memory.
class TileDealer
{
public:
  /// Projects every particle and counts the splats of every tile. Throws Error if there are more
  /// particles than 32 bits can number. Where the picture is aborted there are no bands.
  TileDealer(Projection& projection, RenderMemory& memory, WorkProgress& progress);

  /// How many bands the tiles make, so many that the splats of each fit into memory: with the home
  /// of every particle 16 bytes for each of them, and no less than 64 MB.
  int bands() const { return static_cast<int>(this->starts.size()) - 1; }

  /// The splats of band k; the same for any number of threads. They are written over those of the
  /// band before. Not to be used where the picture was aborted meanwhile.
  const TileBand& deal(int k) const;
  /// What the splats' luminosities over a pixel's area are counted in, until the next band is
  /// dealt.
  double splatUnit() const { return this->projection.splatUnit(); }

  const TileGrid& grid() const { return this->tiles; }
  const TileDepths& depthsOf(int tile) const { return this->depths[tile]; }
  std::size_t splatsOf(int tile) const { return this->totals[tile]; }
  /// Particles that are nowhere: off the image, behind the eye or hidden, and invalid ones.
  const ParticleCounts& missing() const { return this->absent; }

private:
  class Share;

  void cutIntoBands();
  void fill(TileBand& band, const std::vector<std::vector<std::size_t>>& places) const;

  Projection& projection;
  TileGrid tiles;
  RenderMemory& memory;
  WorkProgress& progress;
  std::vector<std::vector<std::uint32_t>> counts; ///< by share and tile
  std::vector<std::size_t> totals;                ///< by tile
  std::size_t sum = 0;                            ///< of them
  std::vector<TileDepths> depths;                 ///< by tile
  ParticleCounts absent;
  std::vector<int> starts;     ///< the first tile of each band, and the number of tiles
  std::size_t largestBand = 0; ///< splats
};
} // namespace galaxy

#endif
