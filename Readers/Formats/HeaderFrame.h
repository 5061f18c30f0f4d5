#ifndef galaxy_HeaderFrame_h
#define galaxy_HeaderFrame_h

#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/FitsHeader.h"

#include <string>

namespace galaxy
{
/// The frame of the celestial axes of a header, by their longitude's type ("RA", "GLON", "ELON"),
/// RADESYS (or RADECSYS) and EQUINOX. `version` is the letter of an alternate description, or
/// empty.
///
/// An equinox without RADESYS is FK4 before 1984, else FK5, as the FITS standard has it; one
/// written as text, 'B1950' or 'J2000.0', says by its letter which. The retired EPOCH was used both
/// for the equinox and for the date of the exposure: alone it is an equinox where it has such a
/// letter or is one of those that coordinates were published for, a multiple of 25 years (1900,
/// 1950, 1975, 2000), and otherwise a date, on a plate whose coordinates are then ICRS.
/// Throws Error where the frame is none known here.
CelestialFrame frameOfHeader(const std::string& file, const FitsHeader& header,
  const std::string& version, const std::string& longitude);
} // namespace galaxy

#endif
