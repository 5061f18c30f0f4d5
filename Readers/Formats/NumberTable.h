#ifndef galaxy_NumberTable_h
#define galaxy_NumberTable_h

#include "Readers/Formats/KeyTable.h"
#include "Readers/Formats/TextTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// What a column counts in where its heading tells no unit.
enum class Measure
{
  Number, ///< no unit is looked at
  Kpc,
  Mpc,
  Degrees,
  RightAscension, ///< degrees; 13:29:52.7 is in hours
};

/// A column that a kind of table may have: its name, and what else it is called, the better first.
struct NumberColumn
{
  std::string name;
  Measure measure;
  std::vector<std::string> otherNames = {};
};

/// A table of numbers in columns of known names, as parseTextTable reads it; other columns are not
/// looked at.
class NumberTable
{
public:
  /// From text; `file` only names it in messages, `unnamed` are the columns of a table without a
  /// heading. Throws Error naming the line where a row has not the heading's number of columns, or
  /// where there is no row.
  NumberTable(const std::string& text, const std::string& file,
    const std::vector<NumberColumn>& columns, const std::vector<std::string>& unnamed = {});

  std::size_t size() const { return this->table.rows.size(); }
  bool has(const std::string& column) const { return this->indexOf(column) >= 0; }
  /// A cell in the column's measure, a number of the range; throws Error naming line and column
  /// where it is none, or where there is no such column.
  double number(std::size_t row, const std::string& column, const Range& range) const;
  /// The same, `otherwise` where there is no such column.
  double number(
    std::size_t row, const std::string& column, const Range& range, double otherwise) const;

  /// Throws Error at a row's line.
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;

private:
  struct Found
  {
    int index = -1;
    double factor = 1;
    bool hours = false; ///< its sexagesimal numbers are
  };

  const NumberColumn& column(const std::string& name) const;
  int indexOf(const std::string& name) const;
  Found find(const NumberColumn& column) const;
  [[noreturn]] void failAtMissing(const NumberColumn& column) const;

  std::vector<NumberColumn> columns;
  std::vector<Found> found;
  TextTable table;
};
} // namespace galaxy

#endif
