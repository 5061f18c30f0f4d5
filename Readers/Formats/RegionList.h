#ifndef galaxy_RegionList_h
#define galaxy_RegionList_h

#include "Readers/Formats/WorldCoordinates.h"

#include <string>
#include <vector>

namespace galaxy
{
/// A closed outline in the pixel coordinates of an image.
struct PixelRegion
{
  std::vector<PixelPosition> corners;
  bool excluded = false; ///< a region with `-`: what it covers is kept
  PixelPosition middle;

  bool contains(const PixelPosition& pixel) const; ///< by the even-odd rule
};

/// The image that regions are drawn on.
struct RegionCanvas
{
  const WorldCoordinates* coordinates = nullptr; ///< null: image coordinates only
  PixelPosition shift;                           ///< LTV1, LTV2: image = scale physical + shift
  PixelPosition scale = { 1, 1 };                ///< LTM1_1, LTM2_2
};

/// The regions of a DS9 or CASA region file, as outlines on an image: circle, ellipse, box (CASA's
/// too: centerbox, rotbox and box of two corners) and polygon; round ones have 96 corners, on a
/// circle of the same area.
///
/// Frames: image and physical pixels, fk5 and icrs (one for us), fk4, galactic, ecliptic; DS9's
/// line `global` may name one. Angles are decimal degrees, or sexagesimal with colons (hours of a
/// right ascension, degrees of any other longitude), h m s, d m s or CASA's dots; lengths have the
/// units " ' d r p i (DS9) or arcsec arcmin deg rad pix (CASA). Comments are passed over; a file
/// that never names its frame is in physical pixels (DS9) or J2000 (CASA). Any other shape, frame
/// or malformed number throws Error with the line.
std::vector<PixelRegion> parseRegions(
  const std::string& text, const std::string& file, const RegionCanvas& canvas);
} // namespace galaxy

#endif
