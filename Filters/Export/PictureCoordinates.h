#ifndef galaxy_PictureCoordinates_h
#define galaxy_PictureCoordinates_h

#include "Filters/Export/LightPicture.h"

#include <optional>

namespace galaxy
{
/// Celestial coordinates of a picture by a gnomonic projection (FITS: TAN), ICRS.
struct PictureCoordinates
{
  SkyPosition reference; ///< CRVAL
  PixelPosition pixel;   ///< CRPIX
  double cd[2][2];       ///< degrees a pixel: CDi_j
};

/// Of a picture from Earth: in perspective with the eye where Earth is, whatever it looks at; in
/// parallel projection along the line of sight to the galaxy's centre, where what lies in the plane
/// of the sky through the centre is in its place. None of any other.
std::optional<PictureCoordinates> coordinatesOf(const LightPicture& picture);
} // namespace galaxy

#endif
