#ifndef galaxy_SheetsInPixel_h
#define galaxy_SheetsInPixel_h

#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/LightMap.h"

#include <cstdint>

namespace galaxy
{
/// A point of the sky and the sheets of the disc that are seen there.
struct SeenSheets
{
  PixelPosition at; ///< kpc to the West and North
  DiskInverse::Sheets sheets;
  int count = 0;

  /// One of them, each with the probability of its share; `chosen` is uniform in [0, 1).
  const DiskSheet& byShare(double chosen) const
  {
    int k = 0;
    for (; k + 1 < this->count && chosen >= this->sheets[k].share; ++k)
    {
      chosen -= this->sheets[k].share;
    }
    return this->sheets[k];
  }
};

/// Looks at the fractions (u, v) of a pixel whose middle shows the disc. Where the disc ends before
/// that point, at a point half as far from the middle, and so on, so that no two of them coincide.
/// `near`: see DiskInverse::find.
inline void findInPixel(const LightMap& map, const DiskInverse& inverse, std::uint32_t pixel,
  double u, double v, std::size_t& near, SeenSheets& seen)
{
  constexpr int halvings = 8;
  double part = 1;
  for (int tries = 0; tries <= halvings; ++tries, part = tries < halvings ? 0.5 * part : 0)
  {
    seen.at = map.pointIn(pixel, 0.5 + part * (u - 0.5), 0.5 + part * (v - 0.5));
    seen.count = inverse.find(seen.at.x, seen.at.y, seen.sheets, near);
    if (seen.count > 0)
    {
      return;
    }
  }
}
} // namespace galaxy

#endif
