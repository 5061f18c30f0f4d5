#ifndef galaxy_TirificKeywords_h
#define galaxy_TirificKeywords_h

#include "Readers/Formats/RingText.h"

#include <map>
#include <string>
#include <vector>

namespace galaxy
{
/// The keywords of a TiRiFiC .def file, in capitals, and their values, as its simparse.c reads
/// them: a value is all up to the next KEYWORD=, also on further lines, behind a backslash or not;
/// from # to the next # or the line's end is a comment. Of a keyword that stands twice the last
/// counts.
class TirificKeywords
{
public:
  /// Throws Error naming the line that is neither KEYWORD= values, nor more values, nor a comment.
  TirificKeywords(const std::vector<TextLine>& lines, const std::string& file);

  /// All numbers of a keyword; empty where the keyword is absent or has no value.
  std::vector<double> numbers(const std::string& keyword) const;
  /// The same in degrees where they may be 06:07:12.0, which is hours of a right ascension.
  std::vector<double> angles(const std::string& keyword, bool colonsAreHours) const;
  /// The numbers that FAT leaves in a comment, `# VROT_ERR= 4.1 8.2`; empty where there are none.
  std::vector<double> commentedNumbers(const std::string& keyword) const;
  /// A number that must be whole and within [lowest, highest]; `absent` where there is none.
  int whole(const std::string& keyword, int lowest, int highest, int absent) const;

  /// "line 12: VROT", or the keyword alone where the file lacks it.
  std::string where(const std::string& keyword) const;

private:
  struct Cell
  {
    int line = 0;
    std::string text;
  };
  struct Values
  {
    int line = 0;
    std::vector<Cell> cells;
  };
  using Map = std::map<std::string, Values>;

  void add(const TextLine& line);
  void addValues(const TextLine& line);
  template <class Parse>
  std::vector<double> parsed(const std::string& keyword, const Parse& parse) const;

  std::string file;
  Map all;
  Map comments;
  Values* open = nullptr; ///< whose values a further line continues
};
} // namespace galaxy

#endif
