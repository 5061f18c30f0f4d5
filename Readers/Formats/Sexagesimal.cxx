#include "Readers/Formats/Sexagesimal.h"

#include "Readers/Formats/TextFile.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace galaxy
{
namespace
{
constexpr const char* marks = ":hdms'\"";

bool isPlain(const std::string& field)
{
  return !field.empty() && std::all_of(field.begin(), field.end(), [](unsigned char c) {
    return std::isdigit(c) || c == '.';
  });
}

/// The fields between the marks.
std::vector<std::string> fieldsOf(const std::string& text)
{
  std::string fields = text;
  const bool dotted = std::count(text.begin(), text.end(), '.') >= 2;
  int dots = 0;
  for (char& c : fields)
  {
    const bool separates = dotted && c == '.' && ++dots <= 2;
    c = separates || std::string(marks).find(c) != std::string::npos ? ' ' : c;
  }
  return splitCells(fields);
}
} // namespace

std::optional<double> sexagesimalAngle(const std::string& text, bool colonsAreHours)
{
  std::string small = lowered(trimmed(text));
  for (std::size_t at; (at = small.find("\xc2\xb0")) != std::string::npos;)
  {
    small.replace(at, 2, "d");
  }
  const bool negative = !small.empty() && small[0] == '-';
  small.erase(0, !small.empty() && (small[0] == '-' || small[0] == '+') ? 1 : 0);
  const std::vector<std::string> fields = fieldsOf(small);
  if (fields.size() < 2 || fields.size() > 3)
  {
    return std::nullopt;
  }
  double angle = 0, unit = 1;
  for (const std::string& field : fields)
  {
    constexpr double base = 60;
    double number;
    if (!isPlain(field) || !parseNumber(field, number) || (unit < 1 && number >= base))
    {
      return std::nullopt;
    }
    angle += number * unit;
    unit /= base;
  }
  const bool hours = small.find('h') != std::string::npos ||
    (colonsAreHours && small.find(':') != std::string::npos);
  return (negative ? -angle : angle) * (hours ? 15 : 1);
}

std::optional<double> angleOf(const std::string& text, bool colonsAreHours)
{
  double number;
  return parseNumber(text, number) ? std::optional<double>(number)
                                   : sexagesimalAngle(text, colonsAreHours);
}
} // namespace galaxy
