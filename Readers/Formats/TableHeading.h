#ifndef galaxy_TableHeading_h
#define galaxy_TableHeading_h

#include "Readers/Formats/TextTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// A line in front of a table's rows, without its mark where it is a comment.
struct HeadLine
{
  int number = 0;
  bool commented = false;
  std::string text;
};

/// What the lines in front of the rows say about the columns, for rows of `count` cells between
/// `separator`s: the heading and its units go into `table`. Throws Error naming a line that must be
/// a heading or units and cannot.
void readHeading(const std::vector<HeadLine>& head, std::size_t count, char separator,
  const TableWords& words, TextTable& table);

/// Gives the columns the units that an ECSV header's YAML has for their names.
void readEcsvUnits(const std::vector<HeadLine>& head, TextTable& table);

/// Reads a table with the byte-by-byte description of CDS or AAS above it; false where there is
/// none.
bool readDescribedBytes(const std::vector<TextLine>& lines, TextTable& table);
} // namespace galaxy

#endif
