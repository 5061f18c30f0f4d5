#ifndef galaxy_TextTable_h
#define galaxy_TextTable_h

#include "Readers/Formats/TextFile.h"

#include <functional>
#include <string>
#include <vector>

namespace galaxy
{
/// A column as the file names it.
struct TableColumn
{
  std::string text; ///< name and unit as written together
  std::string name; ///< without the unit
  std::string unit; ///< empty where the file tells none
};

struct TableRow
{
  int line = 0;
  std::vector<std::string> cells;
};

/// The names that a kind of table has for its columns.
struct TableWords
{
  /// What a name, as plainName makes it, stands for; names of the same say the same. Empty where it
  /// is none of them.
  std::function<std::string(const std::string& name)> meaning;
  /// What the columns are where no heading names them and there are as many.
  std::vector<std::string> unnamed;
  /// The meanings that are lengths: "all lengths in kpc" is said of them.
  std::vector<std::string> lengths;

  bool isName(const std::string& name) const { return !this->meaning(name).empty(); }
};

/// A table in a text file, whoever wrote it.
struct TextTable
{
  std::string file;
  int headingLine = 0; ///< 0: nothing names the columns, and these are TableWords::unnamed or none
  int unitLine = 0;    ///< of units; 0: they stand beside the names, if anywhere
  std::vector<TableColumn> columns;
  std::vector<TableRow> rows; ///< each with as many cells as there are columns, if there are any
  std::vector<TextLine> head; ///< what stands before the rows, without the marks of comments
};

/// Reads rows of numbers, cut by commas, semicolons, tabs, |, & or blanks, with decimal points or
/// commas, under a heading that may stand in a comment (# ! % // \), with its units beside the
/// names, r[arcsec], z0 (pc), r_kpc, r/kpc, or in a line of their own; rules, titles, lines of
/// types and of column numbers are passed over. Known are also: comments that list the columns one
/// a line, ECSV, IPAC and LaTeX tables, VizieR's, and the byte-by-byte description of CDS and AAS.
/// Throws Error naming the line that is none of these, or that has not as many cells.
TextTable parseTextTable(
  const std::vector<TextLine>& lines, const std::string& file, const TableWords& words);

/// A name as TableWords has it: small letters without dots and the marks of LaTeX, blanks and
/// hyphens as underscores.
std::string plainName(const std::string& name);

/// Name and unit of a heading's cell.
TableColumn columnOf(const std::string& cell, const TableWords& words);
} // namespace galaxy

#endif
