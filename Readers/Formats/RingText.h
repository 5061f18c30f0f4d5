#ifndef galaxy_RingText_h
#define galaxy_RingText_h

#include "Readers/Formats/RingTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// One line of a text file, its number counted from 1.
struct TextLine
{
  int number = 0;
  std::string text;
};

/// The lines of a text, with Unix, DOS or old Macintosh line ends.
std::vector<TextLine> splitLines(const std::string& text);

/// The cells of a line, separated by blanks, tabs or commas.
std::vector<std::string> splitCells(const std::string& text);

/// The text without blanks at its ends, in small letters.
std::string trimmed(const std::string& text);
std::string lowered(std::string text);

/// The whole cell as a finite number (a Fortran D exponent is understood); false where it is none.
bool parseNumber(std::string cell, double& number);

// The formats: each with the test that recognises it.

/// Rings as one row of columns each: plain, GIPSY ROTCUR, or named by a heading.
RingTable parseRingColumns(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options);

/// True where the text has lines of the form KEYWORD= values.
bool isTirific(const std::vector<TextLine>& lines);
/// A TiRiFiC .def file.
RingTable parseTirific(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options);

/// True where the text is the output of a DiskFit minimisation.
bool isDiskFit(const std::vector<TextLine>& lines);
/// A DiskFit .out file of a velocity fit.
RingTable parseDiskFit(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options);

/// Throws Error naming `where` if a ring makes no sense by itself or after the one before it
/// (null for the first).
void checkRing(
  const Ring& ring, const Ring* before, const std::string& file, const std::string& where);

/// Appends a ring after checking it.
void addRing(RingTable& table, const Ring& ring, const std::string& where);
} // namespace galaxy

#endif
