#ifndef galaxy_NearestNeighbours_h
#define galaxy_NearestNeighbours_h

#include "Readers/Formats/Progress.h"

#include <cstddef>

namespace galaxy
{
/// The mean distance d = (V/N)^(1/3) around each of `count` particles of 3 numbers each, in their
/// unit, from the ball that reaches to the k-th nearest other particle: d = r_k (4 pi/3 / k)^(1/3).
/// Where there are fewer than k others it reaches to the farthest; d is 0 for a lone particle and
/// for one without a finite position. A k-d tree (nanoflann) holds the particles meanwhile.
/// Throws Aborted where `progress` ends it.
void neighbourDistances(
  const float* position, std::size_t count, int k, float* d, const Progress& progress = {});
} // namespace galaxy

#endif
