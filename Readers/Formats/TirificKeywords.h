#ifndef galaxy_TirificKeywords_h
#define galaxy_TirificKeywords_h

#include "Readers/Formats/RingText.h"

#include <map>
#include <string>
#include <vector>

namespace galaxy
{
/// The keywords of a TiRiFiC .def file, in capitals, and their values. Of a keyword that stands
/// twice the last counts; a backslash at a line's end continues it.
class TirificKeywords
{
public:
  /// Throws Error naming the line that is neither KEYWORD= values nor a comment.
  TirificKeywords(const std::vector<TextLine>& lines, const std::string& file);

  /// All numbers of a keyword; empty where the keyword is absent or has no value.
  std::vector<double> numbers(const std::string& keyword) const;
  /// The numbers that FAT leaves in a comment, `# VROT_ERR= 4.1 8.2`; empty where there are none.
  std::vector<double> commentedNumbers(const std::string& keyword) const;
  /// A number that must be whole and within [lowest, highest]; `absent` where there is none.
  int whole(const std::string& keyword, int lowest, int highest, int absent) const;

  /// "line 12: VROT", or the keyword alone where the file lacks it.
  std::string where(const std::string& keyword) const;

private:
  struct Values
  {
    int line = 0;
    std::vector<std::string> cells;
  };
  using Map = std::map<std::string, Values>;
  static bool split(const TextLine& line, Map& into);

  std::string file;
  Map all;
  Map comments;

  friend bool isTirific(const std::vector<TextLine>& lines);
};
} // namespace galaxy

#endif
