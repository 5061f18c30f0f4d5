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

/// The lines in front of a table's rows, and how these are cut.
struct TableHead
{
  const std::vector<HeadLine>& lines;
  std::size_t count; ///< of cells in a row
  char separator;
  const TableWords& words;
};

/// Finds the names of the columns, and the units that stand beside them. Throws Error naming a line
/// that must be a heading and cannot.
void findNames(const TableHead& head, TextTable& table);

/// Finds the units that have lines of their own. Throws Error naming a line that must be units and
/// cannot.
void findUnits(const TableHead& head, TextTable& table);

/// Whether most words of a line are units, one a column.
bool areUnits(const TableHead& head, const HeadLine& line);

/// Gives the columns the units that an ECSV header's YAML has for their names.
void readEcsvUnits(const std::vector<HeadLine>& head, TextTable& table);

/// Reads a table with the byte-by-byte description of CDS or AAS above it; false where there is
/// none.
bool readDescribedBytes(const std::vector<TextLine>& lines, TextTable& table);

/// A line "r: radius in kpc" or "Z0 = height [pc]" as a column with its unit; false where it is
/// none.
bool takeNamedColumn(const std::string& line, const TableWords& words, TableColumn& column);

/// The text behind a label such as "Columns:", or all of it.
std::string behindLabel(
  const std::string& text, const std::vector<std::string>& labels, bool* found = nullptr);
} // namespace galaxy

#endif
