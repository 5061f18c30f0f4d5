#ifndef galaxy_FitsFile_h
#define galaxy_FitsFile_h

#include "Readers/Formats/Image.h"

#include <string>

namespace galaxy
{
/// What to read of a FITS file.
struct FitsSelection
{
  int hdu = -1;          ///< 0 is the primary HDU; -1 the first HDU that holds an image
  std::string extension; ///< EXTNAME; wins over `hdu` where not empty
  int plane = 0;         ///< zero-based plane of a cube, counted over all axes beyond the second
};

/// Reads one image plane: every BITPIX, BSCALE/BZERO applied, BLANK to NaN, compressed or not.
/// The path is taken literally (no extended file name syntax).
/// Throws Error naming the file and the keyword or CFITSIO's own messages.
Image readFitsImage(const std::string& file, const FitsSelection& selection = {});
} // namespace galaxy

#endif
