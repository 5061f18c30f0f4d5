#ifndef galaxy_FitsTiles_h
#define galaxy_FitsTiles_h

#include <string>

namespace galaxy
{
class FitsHandle;
struct FitsHdu;

/// Throws Error where the header of a tile-compressed image has parameters that no encoder writes;
/// CFITSIO would divide by them, index with them, or read rows that its table does not have.
void checkTileParameters(const std::string& file, const FitsHdu& hdu);

/// Throws Error where a tile's bytes lie outside the table's heap, or where it does not hold
/// its pixels: by its own count (HCOMPRESS, PLIO), or because it ends early or unpacks to other
/// sizes (RICE, GZIP). CFITSIO would read on, or write beyond its buffers.
/// `fits` stands at `hdu`.
void checkTiles(const FitsHandle& fits, const FitsHdu& hdu);
} // namespace galaxy

#endif
