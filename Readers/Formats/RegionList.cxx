#include "Readers/Formats/RegionList.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RegionNumbers.h"
#include "Readers/Formats/RegionOutline.h"
#include "Readers/Formats/TextFile.h"

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
    { "image", { false, {}, false } },
    { "physical", { true, {}, false } },
    { "icrs", { false, CelestialFrame::icrs(), true } },
    { "fk5", { false, CelestialFrame::icrs(), true } },
    { "j2000", { false, CelestialFrame::icrs(), true } },
    { "fk4", { false, CelestialFrame::fk4(1950), true } },
    { "b1950", { false, CelestialFrame::fk4(1950), true } },
    { "galactic", { false, CelestialFrame::galactic(), false } },
    { "ecliptic", { false, CelestialFrame::ecliptic(2000), false } },
  };
  const auto found = frames.find(name);
  return found == frames.end() ? std::nullopt : std::optional<RegionFrame>(found->second);
}

/// DS9 has frames that name no place on the sky or in this image; one is none of ours.
bool isForeignFrame(const std::string& name)
{
  static const std::vector<std::string> frames = { "detector", "amplifier", "linear", "wcs",
    "supergalactic", "supergal", "azel", "azelgeo", "itrf", "hadec", "topo" };
  const bool alternate = name.size() == 4 && name.compare(0, 3, "wcs") == 0;
  return alternate || std::find(frames.begin(), frames.end(), name) != frames.end();
}

/// A word of DS9's line `global` that stands by itself names a frame; those in quotation marks are
/// of its fonts.
void readGlobalFrame(const std::string& statement, RegionFrame& frame)
{
  std::string bare;
  char mark = 0;
  for (const char c : statement)
  {
    const bool quote = c == '"' || c == '\'' || c == '{' || c == '}';
    bare += mark == 0 && !quote ? c : 'x';
    mark = mark == 0 && quote && c != '}' ? (c == '{' ? '}' : c) : c == mark ? 0 : mark;
  }
  for (const std::string& word : splitCells(bare))
  {
    if (const std::optional<RegionFrame> named = frameNamed(word))
    {
      frame = *named;
    }
  }
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
      (cells.empty() ? "" : ", not " + quoted(cells[0])));
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
    else if (isForeignFrame(statement))
    {
      throw RegionFault(quoted(statement) +
        " is a frame not known here; use image, physical, icrs, fk5, fk4, galactic or ecliptic");
    }
    else if (statement.compare(0, 6, "global") == 0)
    {
      readGlobalFrame(statement.substr(6), this->frame);
      readProperties(statement, this->frame);
    }
    else
    {
      const bool excluded = statement[0] == '-' || statement[0] == '!';
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

/// A line without its comment and DS9's mark of a composite, cut into statements at the semicolons.
std::vector<std::string> statementsOf(const std::string& line)
{
  std::string code = lowered(line.substr(0, line.find('#')));
  std::vector<std::string> statements;
  for (std::size_t from = 0; from <= code.size();)
  {
    const std::size_t to = std::min(code.find(';', from), code.size());
    std::string statement = trimmed(code.substr(from, to - from));
    if (statement.size() > 2 && statement.compare(statement.size() - 2, 2, "||") == 0)
    {
      statement = trimmed(statement.substr(0, statement.size() - 2));
    }
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
  const std::vector<TextLine> lines = splitLines(plainText(text, file));
  const bool casa = !lines.empty() && trimmed(lines[0].text).compare(0, 5, "#CRTF") == 0;
  RegionParser parser(canvas, casa);
  for (const TextLine& line : lines)
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
      throw Error(file, lineName(line.number), fault.what());
    }
  }
  return parser.regions;
}
} // namespace galaxy
