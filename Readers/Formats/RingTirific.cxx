#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace galaxy
{
namespace
{
/// The cells behind a keyword's equals sign, and its line.
struct Values
{
  int line = 0;
  std::vector<std::string> cells;
};

/// True where the line reads KEYWORD= cells.
bool splitKeyword(const std::string& line, std::string& keyword, Values& values)
{
  const std::size_t equals = line.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  const std::vector<std::string> words = splitCells(line.substr(0, equals));
  if (words.size() != 1 || !std::all_of(words[0].begin(), words[0].end(), [](unsigned char c) {
        return std::isalnum(c) || c == '_';
      }))
  {
    return false;
  }
  keyword = words[0];
  std::transform(keyword.begin(), keyword.end(), keyword.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  values.cells = splitCells(line.substr(equals + 1));
  return true;
}

std::string beforeComment(const std::string& line)
{
  return line.substr(0, line.find('#'));
}

/// The keywords of a .def file and what they say about the first disk.
class Keywords
{
public:
  Keywords(const std::vector<TextLine>& lines, const std::string& file)
    : file(file)
  {
    for (const TextLine& line : lines)
    {
      const std::string text = beforeComment(line.text);
      std::string keyword;
      Values values{ line.number, {} };
      if (splitKeyword(text, keyword, values))
      {
        this->all[keyword] = values;
      }
      else if (!splitCells(text).empty())
      {
        throw Error(file, "line " + std::to_string(line.number),
          "neither KEYWORD= values nor a comment: '" + text.substr(0, 40) + "'");
      }
    }
  }

  /// All numbers of a keyword; empty where the keyword is absent or has no value.
  std::vector<double> numbers(const std::string& keyword) const
  {
    std::vector<double> numbers;
    const auto found = this->all.find(keyword);
    if (found == this->all.end())
    {
      return numbers;
    }
    for (const std::string& cell : found->second.cells)
    {
      double number;
      if (!parseNumber(cell, number))
      {
        throw Error(this->file, this->where(keyword),
          "value " + std::to_string(numbers.size() + 1) + " is not a finite number: '" + cell +
            "'");
      }
      numbers.push_back(number);
    }
    return numbers;
  }

  /// A number that must be whole and within [lowest, highest]; `absent` where there is none.
  int whole(const std::string& keyword, int lowest, int highest, int absent) const
  {
    const std::vector<double> values = this->numbers(keyword);
    if (values.empty())
    {
      return absent;
    }
    if (!(values[0] >= lowest && values[0] <= highest) || values[0] != static_cast<int>(values[0]))
    {
      throw Error(this->file, this->where(keyword),
        "must be a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    }
    return static_cast<int>(values[0]);
  }

  /// "line 12: VROT", or the keyword alone where the file lacks it.
  std::string where(const std::string& keyword) const
  {
    const auto found = this->all.find(keyword);
    return found == this->all.end() ? keyword
                                    : "line " + std::to_string(found->second.line) + ": " + keyword;
  }

private:
  std::string file;
  std::map<std::string, Values> all;
};

struct Parameter
{
  const char* keyword;
  double Ring::*member;
  bool required;
};

constexpr Parameter parameters[] = {
  { "VROT", &Ring::rotationVelocity, true },
  { "Z0", &Ring::scaleHeight, false },
  { "SBR", &Ring::surfaceBrightness, false },
  { "INCL", &Ring::inclination, true },
  { "PA", &Ring::positionAngle, true },
  { "VRAD", &Ring::expansionVelocity, false },
  { "VSYS", &Ring::systemicVelocity, false },
};

std::vector<Ring> ringsAtRadii(const Keywords& keywords, const std::string& file)
{
  const std::vector<double> radii = keywords.numbers("RADI");
  if (radii.empty())
  {
    throw Error(file, keywords.where("RADI"), "missing: no rings at all");
  }
  constexpr int mostRings = 1000000;
  const int count = keywords.whole("NUR", 1, mostRings, static_cast<int>(radii.size()));
  if (static_cast<int>(radii.size()) < count)
  {
    throw Error(file, keywords.where("RADI"),
      "has " + std::to_string(radii.size()) + " values, NUR asks for " + std::to_string(count));
  }
  std::vector<Ring> rings(count);
  for (int i = 0; i < count; ++i)
  {
    rings[i].radius = radii[i];
  }
  return rings;
}
} // namespace

bool isTirific(const std::vector<TextLine>& lines)
{
  std::string keyword;
  Values values;
  return std::any_of(lines.begin(), lines.end(), [&](const TextLine& line) {
    const std::string text = beforeComment(line.text);
    return text.find('!') == std::string::npos && splitKeyword(text, keyword, values);
  });
}

RingTable parseTirific(const std::vector<TextLine>& lines, const std::string& file)
{
  const Keywords keywords(lines, file);
  RingTable table;
  table.file = file;
  table.code = RingCode::Tirific;
  table.layerLaw =
    static_cast<LayerLaw>(keywords.whole("LTYPE", 1, 5, static_cast<int>(LayerLaw::Sech2)));
  table.rings = ringsAtRadii(keywords, file);
  for (const Parameter& parameter : parameters)
  {
    const std::vector<double> values = keywords.numbers(parameter.keyword);
    if (values.empty() && parameter.required)
    {
      throw Error(file, keywords.where(parameter.keyword), "missing, or without a value");
    }
    for (std::size_t i = 0; i < table.rings.size() && !values.empty(); ++i)
    {
      table.rings[i].*parameter.member = values[std::min(i, values.size() - 1)];
    }
  }
  const Ring* before = nullptr;
  for (const Ring& ring : table.rings)
  {
    checkRing(ring, before, file,
      keywords.where("RADI") + ", ring " + std::to_string(1 + (&ring - table.rings.data())));
    before = &ring;
  }
  return table;
}
} // namespace galaxy
