#ifndef galaxy_FitsRice_h
#define galaxy_FitsRice_h

#include <string>

namespace galaxy
{
/// Whether a RICE stream has all its pixels: CFITSIO looks for the next set bit beyond the stream's
/// end. `pixelBytes` and `blockSize` are the compression's BYTEPIX and BLOCKSIZE. The code is that
/// of the FITS standard 4.0, section 10.4.1.
bool riceStreamHolds(
  const std::string& stream, long long pixels, long long pixelBytes, long long blockSize);
} // namespace galaxy

#endif
