#ifndef galaxy_HistoryBeam_h
#define galaxy_HistoryBeam_h

#include "Readers/Formats/Beam.h"

#include <optional>
#include <string>

namespace galaxy
{
/// The last beam in the HISTORY of a header (Image::cards): AIPS's "CLEAN BMAJ= BMIN= BPA=" in
/// degrees, else the same of another program, in arcsec where its line says so, or CASA's
/// "restoration: 10.8 by 7.2 (arcsec) at pa 1 (deg)".
std::optional<Beam> beamOfHistory(const std::string& cards);
} // namespace galaxy

#endif
