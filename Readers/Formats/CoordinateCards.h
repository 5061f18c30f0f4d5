#ifndef galaxy_CoordinateCards_h
#define galaxy_CoordinateCards_h

#include <string>

// The cards of a FITS header that world coordinates are made of: what programs write, and what
// WCSLIB reads.

namespace galaxy
{
/// The same header as WCSLIB insists on it: CTYPE and RADESYS in capitals; the distortion that
/// early SCAMP wrote on TAN axes named TPV, and taken out where SIP describes it as well (as
/// astropy does); the terms of TPV that count as 1 where they are absent.
std::string repairedCoordinateCards(const std::string& cards);

/// The retired EPOCH keyword was used both for the equinox and for the date of the exposure. Beside
/// EQUINOX or RADESYS it decides nothing; alone it is an equinox where it is one of those that
/// coordinates were published for, a multiple of 25 years (1900, 1950, 1975, 2000), and otherwise a
/// date, on a plate whose coordinates are then J2000.
bool epochIsPlateDate(const std::string& cards);

/// Whether the header has the plate solution of the Digitized Sky Survey beside axes of its own.
bool hasPlateSolutionBesideAxes(const std::string& cards);

/// The header without that plate solution.
std::string withoutPlateSolution(const std::string& cards);
} // namespace galaxy

#endif
