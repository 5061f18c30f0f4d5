#ifndef galaxy_Error_h
#define galaxy_Error_h

#include "Readers/Formats/Printable.h"

#include <stdexcept>
#include <string>

namespace galaxy
{
/// The one exception of the VTK-free code: what is wrong, and where in which file.
class Error : public std::runtime_error
{
public:
  /// `file` is the path as the user gave it; `where` a keyword, a table column or "line 12" (may be
  /// empty); `what` the cause and, where one is known, the cure. Bytes of the file that either
  /// quotes are made printable, and cut in the middle where they are very many.
  Error(const std::string& file, const std::string& where, const std::string& what)
    : std::runtime_error(printable(file) + ": " +
        (where.empty() ? "" : printable(shortened(where, mostWhere)) + ": ") +
        printable(shortened(what, mostWhat)))
  {
  }

private:
  static constexpr std::size_t mostWhere = 200, mostWhat = 1000;
};

/// A file that no setting makes readable.
class DamagedFile : public Error
{
public:
  DamagedFile(const std::string& file, const std::string& where, const std::string& what)
    : Error(file, where, what + "; repair the file or get another copy")
  {
  }
};
} // namespace galaxy

#endif
