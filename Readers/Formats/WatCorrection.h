#ifndef galaxy_WatCorrection_h
#define galaxy_WatCorrection_h

#include "Readers/Formats/FitsHeader.h"

#include <map>
#include <string>

namespace galaxy
{
/// What IRAF's WATj_nnn cards say of an axis of a TNX or ZPX projection.
struct WatCorrection
{
  std::map<int, double> parameters; ///< of the projection: projp0, projp1 ... of ZPX
  /// The polynomial that corrects the axis, as WCSLIB reads it between the quotes: its type,
  /// orders, cross terms, domain and coefficients; empty where there is none.
  std::string polynomial;
};

/// Throws Error where the cards are not closed or the polynomial is not whole.
WatCorrection watCorrectionOf(const std::string& file, const FitsHeader& header, int axis);

/// A polynomial that corrects nothing.
std::string noCorrection();
} // namespace galaxy

#endif
