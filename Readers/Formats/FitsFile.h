#ifndef galaxy_FitsFile_h
#define galaxy_FitsFile_h

#include "Readers/Formats/Image.h"
#include "Readers/Formats/Progress.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace galaxy
{
/// What to read of a FITS file.
///
/// The image plane of a cube is spanned by its two celestial axes, wherever they stand, the
/// lower-numbered along x; by axes 1 and 2 where it has none. The other axes are its planes,
/// counted from 0 with the lowest-numbered axis fastest.
struct FitsSelection
{
  int hdu = -1;          ///< 0 is the primary HDU; -1 the first HDU that holds an image
  std::string extension; ///< EXTNAME, capitals aside; wins over `hdu` where not empty
  int plane = 0;         ///< the plane; with velocityRange, the place along the other axes
  std::optional<std::array<int, 2>> planes; ///< the mean of the planes first to last
  /// The integral over the channels whose centres lie between these velocities, km/s (moment 0):
  /// the sum of value times channel width; " km/s" is appended to the unit. The velocities are
  /// those of the header's own frame; see SpectralAxis for the axes it knows.
  std::optional<std::array<double, 2>> velocityRange;
  std::vector<double> maskValues; ///< values that stand for "blank", in the image's own precision
};

/// Reads one image: every BITPIX, BSCALE/BZERO applied, the asinh magnitudes of Pan-STARRS stacks
/// made linear (Image::note says so), compressed or not; NaN where it is BLANK,
/// infinite, or one of the mask values. In a mean and an integral, blank pixels are left out; where
/// all are blank the image is.
/// `progress` is told the part read; Aborted is thrown where it ends the reading.
/// The path is taken literally (no extended file name syntax).
/// Throws Error naming the file and the keyword or CFITSIO's own messages. Nothing is allocated for
/// a header that promises more than the file holds (see findFitsImage), or for an image that, with
/// what reading it takes, is more than availableMemory(); nor is more unpacked of a gzipped file.
Image readFitsImage(
  const std::string& file, const FitsSelection& selection = {}, const Progress& progress = {});
} // namespace galaxy

#endif
