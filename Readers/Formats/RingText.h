#ifndef galaxy_RingText_h
#define galaxy_RingText_h

#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/TextFile.h"

#include <string>
#include <vector>

namespace galaxy
{
// The formats: each with the test that recognises it.

/// Rings as one row of columns each, plain or named by a heading.
RingTable parseRingColumns(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options);

/// True where the text is of GIPSY's or NEMO's ROTCUR.
bool isRotcur(const std::vector<TextLine>& lines);
/// What ROTCUR prints: rows whose columns its heading names in its own words.
RingTable parseRotcur(
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
