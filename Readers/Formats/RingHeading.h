#ifndef galaxy_RingHeading_h
#define galaxy_RingHeading_h

#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/RingUnits.h"
#include "Readers/Formats/TextTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// One quantity of a ring and the names it goes by, as plainName makes them.
struct Quantity
{
  const char* symbol;
  double Ring::*member;
  bool required;
  Dimension dimension;
  std::vector<std::string> names;
  /// Names that stand for it only where none of the others does: a circular velocity is not quite
  /// that of the rotation, and I may be an intensity.
  std::vector<std::string> lesserNames;
};

/// The quantities r, vrot, Z0, i, PA, SBR, vrad and vsys, in this order.
const std::vector<Quantity>& ringQuantities();

/// The quantity of a name; null where it is of none.
const Quantity* quantityOf(const std::string& name);

/// What columns of ring tables are called: the quantities' symbols, "name" for that of the galaxy,
/// and what the options call a column.
TableWords ringWords(const RingOptions& options);

/// The column that holds a quantity: the one that the options name; else of several an angular
/// length rather than one that was derived from it by the program's own distance, and the better
/// name. -1 where there is none. Throws Error where two are equally good, or the options' is not
/// there.
int columnOf(const Quantity& quantity, const TextTable& table, const RingOptions& options);

/// Leaves the rows of the galaxy that the options name. Throws Error, listing the names, where
/// there are several and none is chosen, or where the chosen one is not there.
void chooseGalaxy(TextTable& table, const RingOptions& options);
} // namespace galaxy

#endif
