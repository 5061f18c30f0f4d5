#include "Readers/Formats/RingHeading.h"

#include "Readers/Formats/RingText.h"

#include <algorithm>

namespace galaxy
{
namespace
{
std::string unquoted(const std::string& cell)
{
  const bool quoted =
    cell.size() > 1 && (cell.front() == '"' || cell.front() == '\'') && cell.back() == cell.front();
  return quoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// A name as the quantities list it: small letters, no dots, blanks as underscores.
std::string plainName(const std::string& name)
{
  std::string plain = lowered(trimmed(name));
  plain.erase(std::remove(plain.begin(), plain.end(), '.'), plain.end());
  std::replace(plain.begin(), plain.end(), ' ', '_');
  return plain;
}

const Quantity* quantityOf(const std::string& name)
{
  for (const Quantity& quantity : ringQuantities())
  {
    const auto& names = quantity.names;
    if (std::find(names.begin(), names.end(), plainName(name)) != names.end())
    {
      return &quantity;
    }
  }
  return nullptr;
}

/// The value of `key` in a line of YAML's flow style, {key: value, ...}.
std::string flowValue(const std::string& line, const std::string& key)
{
  const std::size_t at = line.find(key + ":");
  if (at == std::string::npos || at == 0 || (line[at - 1] != ' ' && line[at - 1] != '{'))
  {
    return "";
  }
  const std::size_t start = std::min(line.find_first_not_of(' ', at + key.size() + 1), line.size());
  const bool quoted = start < line.size() && (line[start] == '"' || line[start] == '\'');
  const std::size_t end = quoted ? std::min(line.find(line[start], start + 1), line.size() - 1) + 1
                                 : std::min(line.find_first_of(",}", start), line.size());
  return unquoted(trimmed(line.substr(start, end - start)));
}
} // namespace

const std::vector<Quantity>& ringQuantities()
{
  static const std::vector<Quantity> all = {
    { "r", &Ring::radius, true, Dimension::Length, { "r", "rad", "radi", "radius", "radii" } },
    { "vrot", &Ring::rotationVelocity, true, Dimension::Velocity,
      { "vrot", "v_rot", "vc", "vcirc", "v_circ", "rotation_velocity", "rotationvelocity" } },
    { "Z0", &Ring::scaleHeight, false, Dimension::Length,
      { "z0", "z_0", "scale_height", "scaleheight" } },
    { "i", &Ring::inclination, true, Dimension::Angle, { "i", "inc", "incl", "inclination" } },
    { "PA", &Ring::positionAngle, true, Dimension::Angle,
      { "pa", "position_angle", "positionangle" } },
    { "SBR", &Ring::surfaceBrightness, false, Dimension::Number, { "sbr", "surface_brightness" } },
    { "vrad", &Ring::expansionVelocity, false, Dimension::Velocity,
      { "vrad", "v_rad", "vexp", "v_exp", "radial_velocity", "expansion_velocity" } },
    { "vsys", &Ring::systemicVelocity, false, Dimension::Velocity,
      { "vsys", "v_sys", "systemic_velocity" } },
  };
  return all;
}

Heading parseHeading(const std::string& cell)
{
  Heading heading;
  heading.text = trimmed(cell);
  const std::size_t open = heading.text.find_first_of("([");
  const std::size_t close = heading.text.find_last_of(")]");
  if (open != std::string::npos && close != std::string::npos && close > open)
  {
    heading.name = trimmed(heading.text.substr(0, open));
    heading.unit = trimmed(heading.text.substr(open + 1, close - open - 1));
    heading.quantity = quantityOf(heading.name);
    return heading;
  }
  heading.name = heading.text;
  heading.quantity = quantityOf(heading.name);
  // "vrot_km_s" has its unit from the first underscore, "v_rot_kms" from the last; "vrot_err" none.
  for (const std::size_t at : { heading.text.find('_'), heading.text.rfind('_') })
  {
    if (heading.quantity == nullptr && at != std::string::npos)
    {
      const Quantity* quantity = quantityOf(heading.text.substr(0, at));
      std::string unit = lowered(heading.text.substr(at + 1));
      unit = unit == "km_s" ? "km/s" : unit;
      if (quantity != nullptr && isUnit(quantity->dimension, unit))
      {
        heading.quantity = quantity;
        heading.unit = unit;
      }
    }
  }
  return heading;
}

std::vector<std::string> splitRow(const std::string& text)
{
  std::vector<std::string> cells;
  if (text.find(',') == std::string::npos)
  {
    cells = splitCells(text);
  }
  else
  {
    for (std::size_t start = 0, end = 0; start <= text.size(); start = end + 1)
    {
      end = std::min(text.find(',', start), text.size());
      cells.push_back(trimmed(text.substr(start, end - start)));
    }
  }
  std::transform(cells.begin(), cells.end(), cells.begin(), unquoted);
  return cells;
}

std::vector<std::string> splitHeadings(const std::string& text)
{
  std::vector<std::string> headings;
  bool open = false;
  for (const std::string& cell : splitRow(text))
  {
    const bool unit = !cell.empty() && (cell[0] == '(' || cell[0] == '[');
    if (!headings.empty() && (open || unit))
    {
      headings.back() += ' ' + cell;
    }
    else
    {
      headings.push_back(cell);
    }
    const std::string& all = headings.back();
    open = std::count_if(all.begin(), all.end(), [](char c) { return c == '(' || c == '['; }) >
      std::count_if(all.begin(), all.end(), [](char c) { return c == ')' || c == ']'; });
  }
  return headings;
}

std::map<std::string, std::string> ecsvUnits(const std::vector<std::string>& comments)
{
  std::map<std::string, std::string> units;
  for (const std::string& comment : comments)
  {
    if (comment.compare(0, 3, "- {") == 0)
    {
      units[flowValue(comment, "name")] = flowValue(comment, "unit");
    }
  }
  return units;
}
} // namespace galaxy
