#ifndef galaxy_SkyToDisk_h
#define galaxy_SkyToDisk_h

#include "Filters/Model/RingGeometry.h"

#include <vector>

namespace galaxy
{
/// A place on a disc's surface.
struct DiskPoint
{
  double r = 0;     ///< kpc
  double theta = 0; ///< radians, as TiltedDisk has it
};

/// All places of the disc that are seen at (x, y), kpc to the West and North of its centre, by
/// increasing radius; a warp may show several. With u along a ring's receding axis and w at 90
/// degrees from it on the sky they are the roots of
///   f(r) = (r^2 - u^2) cos^2 i - w^2,
/// where the normal's angles turn with r. Rings seen edge-on cover no area and are passed over.
std::vector<DiskPoint> skyToDisk(const TiltedDisk& disk, double x, double y);
} // namespace galaxy

#endif
