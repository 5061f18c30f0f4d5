#ifndef galaxy_RingHeading_h
#define galaxy_RingHeading_h

#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/RingUnits.h"

#include <map>
#include <string>
#include <vector>

namespace galaxy
{
/// One quantity of a ring and the headings it goes by, in small letters without dots.
struct Quantity
{
  const char* symbol;
  double Ring::*member;
  bool required;
  Dimension dimension;
  std::vector<std::string> names;
};

/// The quantities r, vrot, Z0, i, PA, SBR, vrad and vsys, in this order.
const std::vector<Quantity>& ringQuantities();

/// The heading of one column.
struct Heading
{
  std::string text; ///< as written
  std::string name; ///< without the unit
  std::string unit;
  const Quantity* quantity = nullptr; ///< null for a column of another kind
};

/// Reads "r[arcsec]", "Z0 (pc)", "r_kpc", "P.A.(deg)", "Rotation velocity".
Heading parseHeading(const std::string& cell);

/// The cells of a row: by commas where there are any, else by blanks; quotation marks stripped.
std::vector<std::string> splitRow(const std::string& text);
/// The same, a unit in brackets kept with the name before it.
std::vector<std::string> splitHeadings(const std::string& text);

/// Names and units of an ECSV header's lines `- {name: r, unit: arcsec, datatype: float64}`.
std::map<std::string, std::string> ecsvUnits(const std::vector<std::string>& comments);
} // namespace galaxy

#endif
