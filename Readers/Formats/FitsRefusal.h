#ifndef galaxy_FitsRefusal_h
#define galaxy_FitsRefusal_h

#include "Readers/Formats/FitsHdu.h"

#include <string>

namespace galaxy
{
/// What a file is whose first bytes these are, where they are not those of FITS, and what to do:
/// compressed files, pictures, HDF5, web pages and other things that are called .fits.
std::string notFits(const std::string& start);

/// What an HDU is that holds no image, "a HEALPix map (NSIDE = 64)"; empty where it holds nothing.
std::string otherContent(const FitsHdu& hdu);

/// What to do with a file that has such content alone.
std::string cureOf(const FitsHdu& hdu);
} // namespace galaxy

#endif
