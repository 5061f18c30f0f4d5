#ifndef galaxy_DensityGrid_h
#define galaxy_DensityGrid_h

#include "Readers/Formats/Progress.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace galaxy
{
class CloudSample;
struct CellPlaces;

/// The mean distance between particles everywhere in a cloud, from counts in cells that follow its
/// density: a cube of cells, of which each that holds many particles is a cube of smaller cells,
/// and so on. Up to 2^21 particles are counted, of larger clouds a half, quarter, ... that chance
/// takes by their numbers. The result does not depend on the number of threads, nor, where all are
/// counted, on the order of the particles.
class DensityGrid
{
public:
  /// `position` has 3 numbers a particle, any number of which may not be finite. `neighbours` is
  /// how many counted particles a density is taken over.
  DensityGrid(const float* position, std::size_t count, int neighbours);

  /// d = (V/N)^(1/3) around each of `count` places, in their unit; 0 where no two particles of the
  /// cloud are apart. A place takes the value of a point of the cube as large as its cell, centred
  /// on it, that chance chooses for all places of an eighth of the cell's side: on average the
  /// values change as under linear interpolation, and cells leave no edges.
  /// Throws Aborted where `progress` ends it.
  void meanDistances(
    const float* position, std::size_t count, float* d, const Progress& progress = {}) const;

  /// Cells in use, of 4 bytes each.
  std::size_t size() const { return this->cells.size(); }

private:
  struct Cube
  {
    std::size_t first;
    int bits;  ///< 2^bits cells a side
    int shift; ///< a cell's side is 2^shift units of place
  };

  void countFresh(const CloudSample& sample);
  void measureFresh(double share, bool mayRefine);
  void refine();
  void blockDistances(const float* position, std::size_t n, float* d) const;
  void locate(const float* position, std::size_t n, CellPlaces& places) const;

  int neighbours;
  int rootBits = 0;
  std::array<double, 3> corner{};
  double scale = 0; ///< units of place a kpc; 0 where the cloud has no extent
  /// Particles, later d as the bits of a float; with the highest bit set the cube that refines it.
  std::vector<std::uint32_t> cells;
  std::vector<Cube> fresh; ///< made by the last refinement, not counted yet
};
} // namespace galaxy

#endif
