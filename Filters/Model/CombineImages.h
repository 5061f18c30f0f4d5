#ifndef galaxy_CombineImages_h
#define galaxy_CombineImages_h

#include "Filters/Model/SkyGrid.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/Image.h"

#include <limits>
#include <string>
#include <vector>

namespace galaxy
{
/// How sharp an image is and what its values are per.
struct Resolution
{
  double beam = 0;      ///< full width at half maximum, arcsec; of an ellipse the geometric mean
  bool perBeam = false; ///< values are per beam rather than per solid angle
};

/// From the description's `beam`, else the header's BMAJ and BMIN, else three of its pixels, which
/// is how interferometers' images are sampled. Values are per beam where BUNIT says so and the beam
/// is known.
Resolution resolutionOf(
  const Image& image, const ImageDescription& description, const SkyGrid& grid);

/// One of the images to combine.
struct CombineSource
{
  std::string name;
  CleanImage image;
  Resolution resolution;
};

/// One image of several of the same sky, sharpest first, in the unit of the first: the wider ones
/// hold the light that the sharper ones miss, the sharper ones the detail.
///
/// From the widest, W, to the sharpest, each image S in turn adds its detail,
///   W <- W + D - D * G,   D = w S,
/// with G the Gaussian that widens S's beam to W's. D - D * G has no net light: the total is that
/// of the widest image wherever it reaches. The weight w is 1 on signal and falls smoothly to 0:
/// over half to one and a half of `signalAbove` in S smoothed by its own beam, and toward the edges
/// of S over the width of G. Where W is blank, S's signal alone is taken.
///
/// `signalAbove` is in the first image's unit; NaN: three times each image's own noise, 1.4826
/// times the median depth of its negative values; everything counts where there are none.
///
/// The grid is the first image's, grown where another reaches farther. Values per beam are brought
/// to the first's beam. Throws Error(file, name) where an image is not wider than the one before,
/// only some are per beam, or the grid would be larger than 2^26 pixels.
CleanImage combineImages(const std::vector<CombineSource>& sources, double signalAbove,
  const std::string& file, const std::string& name);
} // namespace galaxy

#endif
