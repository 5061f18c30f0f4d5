#ifndef galaxy_NumberTable_h
#define galaxy_NumberTable_h

#include "Readers/Formats/KeyTable.h"

#include <string>
#include <vector>

namespace galaxy
{
/// A text file of rows under one heading line that names the columns, separated by commas or else
/// by blanks. Lines of blanks, and what follows a #, are left out; capitals of names do not count.
class NumberTable
{
public:
  /// From text; `file` only names it in messages. Throws Error naming the line where a row has not
  /// the heading's number of columns, or where there is no row.
  NumberTable(const std::string& text, const std::string& file);

  std::size_t size() const { return this->rows.size(); }
  bool has(const std::string& column) const;
  /// A cell as a number of the range; throws Error naming line and column where it is none, or
  /// where there is no such column.
  double number(std::size_t row, const std::string& column, const Range& range) const;
  /// The same, `otherwise` where there is no such column.
  double number(
    std::size_t row, const std::string& column, const Range& range, double otherwise) const;

  /// Throws Error at a row's line.
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;

private:
  struct Row
  {
    int line;
    std::vector<std::string> cells;
  };

  std::string file;
  std::vector<std::string> names;
  std::vector<Row> rows;
};
} // namespace galaxy

#endif
