#include "Readers/Formats/RegionList.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RegionNumbers.h"
#include "Readers/Formats/RegionOutline.h"
#include "Readers/Formats/RingText.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace galaxy
{
namespace
{
std::optional<RegionFrame> frameNamed(const std::string& name)
{
  static const std::map<std::string, RegionFrame> frames = {
    { "image", { false, {} } },
    { "physical", { true, {} } },
    { "icrs", { false, CelestialFrame::icrs() } },
    { "fk5", { false, CelestialFrame::icrs() } },
    { "j2000", { false, CelestialFrame::icrs() } },
    { "fk4", { false, CelestialFrame::fk4(1950) } },
    { "b1950", { false, CelestialFrame::fk4(1950) } },
    { "galactic", { false, CelestialFrame::galactic() } },
    { "ecliptic", { false, CelestialFrame::ecliptic(2000) } },
  };
  const auto found = frames.find(name);
  return found == frames.end() ? std::nullopt : std::optional<RegionFrame>(found->second);
}

/// Takes up the frame of CASA's property coord=NAME.
void readProperties(const std::string& properties, RegionFrame& frame)
{
  const std::string key = "coord=";
  const std::size_t start = properties.find(key);
  if (start == std::string::npos)
  {
    return;
  }
  const std::vector<std::string> cells = splitCells(properties.substr(start + key.size()));
  const std::optional<RegionFrame> named = frameNamed(cells.empty() ? "" : cells[0]);
  if (!named)
  {
    throw RegionFault("coord= must be J2000, B1950, ICRS, GALACTIC or ECLIPTIC" +
      (cells.empty() ? "" : ", not '" + cells[0] + "'"));
  }
  frame = *named;
}

/// The shape's name, and what stands in its brackets. CASA writes [ ] inside them, and after them
/// the properties.
RegionShape parseShape(const std::string& text, RegionFrame& frame)
{
  RegionShape shape;
  const std::size_t open = std::min(text.find_first_of("([ \t"), text.size());
  shape.name = text.substr(0, open);
  const std::string rest = trimmed(text.substr(open));
  shape.casa = !rest.empty() && rest[0] == '[';
  const std::size_t close = std::min(rest.find_last_of(")]"), rest.size());
  std::string inside = rest.substr(0, close);
  std::replace_if(
    inside.begin(), inside.end(), [](char c) { return std::strchr("()[]", c) != nullptr; }, ' ');
  shape.arguments = splitCells(inside);
  if (shape.casa)
  {
    readProperties(rest.substr(close), frame);
    if (!shape.arguments.empty() && shape.arguments[0].find("pix") != std::string::npos)
    {
      frame = { false, {} };
    }
  }
  return shape;
}

/// A file's regions, line by line.
class RegionParser
{
public:
  RegionParser(const RegionCanvas& canvas, bool casa)
    : canvas(canvas)
    , frame(*frameNamed(casa ? "j2000" : "physical"))
  {
  }

  void read(const std::string& statement)
  {
    if (const std::optional<RegionFrame> named = frameNamed(statement))
    {
      this->frame = *named;
    }
    else if (statement.compare(0, 6, "global") == 0)
    {
      readProperties(statement, this->frame);
    }
    else
    {
      const bool excluded = statement[0] == '-';
      const bool sign = excluded || statement[0] == '+';
      RegionFrame own = this->frame;
      const RegionShape shape = parseShape(trimmed(statement.substr(sign ? 1 : 0)), own);
      this->regions.push_back(outlineRegion(shape, own, this->canvas));
      this->regions.back().excluded = excluded;
    }
  }

  std::vector<PixelRegion> regions;

private:
  const RegionCanvas& canvas;
  RegionFrame frame;
};

/// A line without its comment, cut into statements at the semicolons.
std::vector<std::string> statementsOf(const std::string& line)
{
  std::string code = lowered(line.substr(0, line.find('#')));
  std::vector<std::string> statements;
  for (std::size_t from = 0; from <= code.size();)
  {
    const std::size_t to = std::min(code.find(';', from), code.size());
    const std::string statement = trimmed(code.substr(from, to - from));
    if (!statement.empty())
    {
      statements.push_back(statement);
    }
    from = to + 1;
  }
  return statements;
}
} // namespace

bool PixelRegion::contains(const PixelPosition& pixel) const
{
  bool inside = false;
  for (std::size_t i = 0, j = this->corners.size() - 1; i < this->corners.size(); j = i++)
  {
    const PixelPosition &p = this->corners[i], &q = this->corners[j];
    if ((p.y > pixel.y) != (q.y > pixel.y) &&
      pixel.x < p.x + (q.x - p.x) * (pixel.y - p.y) / (q.y - p.y))
    {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<PixelRegion> parseRegions(
  const std::string& text, const std::string& file, const RegionCanvas& canvas)
{
  RegionParser parser(canvas, text.compare(0, 5, "#CRTF") == 0);
  for (const TextLine& line : splitLines(text))
  {
    try
    {
      for (const std::string& statement : statementsOf(line.text))
      {
        parser.read(statement);
      }
    }
    catch (const RegionFault& fault)
    {
      throw Error(file, "line " + std::to_string(line.number), fault.what());
    }
  }
  return parser.regions;
}
} // namespace galaxy
