#ifndef galaxy_FitsHdu_h
#define galaxy_FitsHdu_h

#include "Readers/Formats/FitsBytes.h"
#include "Readers/Formats/FitsHeader.h"

#include <vector>

namespace galaxy
{
struct FitsSelection;

/// One header and data unit, read from the blocks themselves: it tells what a file promises before
/// CFITSIO, which trusts headers, acts on it.
struct FitsHdu
{
  int number = 0; ///< 0 is the primary
  FitsHeader header;
  std::uint64_t dataStart = 0; ///< bytes from the file's start
  std::uint64_t dataBytes = 0; ///< without the filling of the last block
  bool compressed = false;     ///< tile-compressed: a table to FITS, an image to its reader
  int bitpix = 0;              ///< of the image, also where compressed
  std::vector<long long> axes; ///< of the image; empty where this is none

  /// Whether this holds an image of two axes or more, none of them empty.
  bool isImage() const;
  long long pixels() const;
};

/// Finds the selected HDU. Throws Error where there is none, it holds no image, or its header
/// promises more than the file holds:
/// * data (NAXISn, PCOUNT, GCOUNT) beyond the file's end, or sizes that overflow 63 bits;
/// * a tile-compressed image of more than 16384 pixels for each byte of its file;
/// * tiles that its table has no rows for, or parameters of a compression (ZTILEn, ZVALn, ZDITHER0)
///   that no encoder writes.
FitsHdu findFitsImage(FitsBytes& bytes, const FitsSelection& selection);
} // namespace galaxy

#endif
