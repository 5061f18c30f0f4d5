// DiskFit's velocity fits (Spekkens & Sellwood 2007; Sellwood & Spekkens 2015), as its sources have
// them: radii in pixels of the map; the position angle North through East to the receding side, on
// a map with North up and East to the left; an ellipse of ellipticity eps has cos i = 1 - eps.
// Beyond r_w the disc warps,
//   eps(r) = eps + f^2 welm,  PA(r) = PA + f^2 wphim,  f = (r - r_w)/(r_max - r_w),
// r_max the last ring; where eps(r) < 0 the axes change places: eps -> 1 - 1/(1 - eps),
// PA -> PA + 90 degrees. Of a parameter that was not fitted the input value holds, and of those the
// program prints wphim in radians. The inclination that it prints beside eps tells more digits of
// it and is taken. The thickness q that it may correct inclinations by is not in the file, and
// taken as 0, as in the inclination that it prints.

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"
#include "Readers/Formats/RingUnits.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double degree = 0.017453292519943295;

/// The sections of the output, found by their titles.
class Output
{
public:
  Output(const std::vector<TextLine>& lines, const std::string& file)
    : file(file)
  {
    std::vector<TextLine>* section = &this->header;
    for (const TextLine& line : lines)
    {
      const std::string text = trimmed(line.text);
      section = startsWith(text, "Input values")         ? &this->input
        : startsWith(text, "Best fitting values")        ? &this->best
        : startsWith(text, "Minimization Details")       ? &this->details
        : startsWith(text, "Fitted velocity components") ? &this->table
                                                         : section;
      section->push_back({ line.number, text });
    }
  }

  static bool startsWith(const std::string& text, const std::string& start)
  {
    return text.compare(0, start.size(), start) == 0;
  }

  /// The first number behind `label` in a section; false where there is no such line.
  bool find(const std::vector<TextLine>& section, const std::string& label, double& value) const
  {
    for (const TextLine& line : section)
    {
      if (startsWith(line.text, label))
      {
        const std::vector<std::string> cells = splitCells(line.text.substr(label.size()));
        if (cells.empty() || !parseNumber(cells[0], value))
        {
          throw Error(this->file, "line " + std::to_string(line.number),
            "'" + label + "' must be followed by a finite number");
        }
        return true;
      }
    }
    return false;
  }

  /// The fitted value, or the input value, to be multiplied by `inputFactor`.
  double value(const std::string& label, double inputFactor = 1) const
  {
    double value;
    if (this->find(this->best, label, value))
    {
      return value;
    }
    if (this->find(this->input, label, value))
    {
      return inputFactor * value;
    }
    throw Error(this->file, label, "missing; give the whole output of the fit");
  }

  /// The disc's ellipticity as the file has it most exactly: of two digits behind the point of eps
  /// and of the inclination in degrees, the latter tell more.
  double ellipticity() const
  {
    const double rounded = this->value("disk eps:");
    double inclination;
    const bool isGiven = this->find(this->best, "disk incl (deg):", inclination) ||
      this->find(this->input, "disk incl (deg):", inclination);
    return isGiven && rounded >= 0 ? 1 - std::cos(inclination * degree) : rounded;
  }

  /// The setting of a toggle, `warp: T`.
  bool toggle(const std::string& name) const
  {
    return std::any_of(this->header.begin(), this->header.end(), [&](const TextLine& line) {
      const std::vector<std::string> cells = splitCells(line.text);
      const auto at = std::find(cells.begin(), cells.end(), name + ":");
      return startsWith(line.text, "vels toggles") && at != cells.end() && at + 1 != cells.end() &&
        at[1] == "T";
    });
  }

  std::vector<TextLine> header, input, best, details, table;

private:
  std::string file;
};

/// Arcsec a pixel: the option, or what stands behind `pixscale` (with two digits only).
double pixelScale(const Output& output, const RingOptions& options, const std::string& file)
{
  if (options.pixelScale > 0)
  {
    return options.pixelScale;
  }
  for (const TextLine& line : output.header)
  {
    const std::vector<std::string> cells = splitCells(line.text);
    const auto at = std::find(cells.begin(), cells.end(), "pixscale");
    double scale;
    if (at != cells.end() && at + 1 != cells.end() && parseNumber(at[1], scale) && scale > 0)
    {
      return scale;
    }
  }
  return unitFactor(Dimension::Length, "pixels", options, file, "column r");
}

/// The disc's plane as a function of radius, all in the file's units.
class Warp
{
public:
  Warp(const Output& output, double last)
    : eps(output.ellipticity())
    , positionAngle(output.value("disk PA, phi_d^prime (deg):"))
    , last(last)
  {
    if (output.toggle("warp"))
    {
      this->start = output.value("r_w (data units):");
      this->epsMost = output.value("Warp eps welm:");
      this->angleMost = output.value("Warp PA wphim:", 1 / degree);
    }
    else
    {
      this->start = last;
    }
  }

  void incline(double r, Ring& ring) const
  {
    const double f = r > this->start ? (r - this->start) / (this->last - this->start) : 0;
    double e = this->eps + f * f * this->epsMost;
    ring.positionAngle = this->positionAngle + f * f * this->angleMost;
    if (e < 0)
    {
      e = 1 - 1 / (1 - e);
      ring.positionAngle += 90;
    }
    ring.inclination = std::acos(std::max(0.0, 1 - e)) / degree;
  }

private:
  double eps;
  double positionAngle;
  double last;
  double start = 0;
  double epsMost = 0;
  double angleMost = 0;
};

const char* const columnNames[] = { "r", "npts", "Vt", "eVt", "Vr", "eVr", "Vm,t", "eVm,t", "Vm,r",
  "eVm,r" };
constexpr std::size_t rotationColumn = 2, radialColumn = 4, mostColumns = 10;

/// The rows of numbers below the table's rule.
std::vector<std::pair<int, std::vector<double>>> readRows(
  const Output& output, const std::string& file)
{
  std::vector<std::pair<int, std::vector<double>>> rows;
  bool below = false;
  for (const TextLine& line : output.table)
  {
    const std::vector<std::string> cells = splitCells(line.text);
    if (below && !cells.empty())
    {
      const std::string where = "line " + std::to_string(line.number);
      std::vector<double> row;
      for (std::size_t k = 0; k < std::min(cells.size(), mostColumns); ++k)
      {
        double number;
        if (!parseNumber(cells[k], number))
        {
          throw Error(file, where,
            std::string("column ") + columnNames[k] + " must be a finite number, not '" + cells[k] +
              "'");
        }
        row.push_back(number);
      }
      if (row.size() < mostColumns)
      {
        throw Error(file, where,
          "has " + std::to_string(row.size()) + " columns, must have " +
            std::to_string(mostColumns));
      }
      rows.emplace_back(line.number, std::move(row));
    }
    below = below || Output::startsWith(line.text, "-----");
  }
  return rows;
}
} // namespace

bool isDiskFit(const std::vector<TextLine>& lines)
{
  const auto first = std::find_if(
    lines.begin(), lines.end(), [](const TextLine& line) { return !trimmed(line.text).empty(); });
  return first != lines.end() && Output::startsWith(trimmed(first->text), "Minimization output");
}

RingTable parseDiskFit(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options)
{
  const Output output(lines, file);
  RingTable table;
  table.file = file;
  table.code = RingCode::Rotcur;
  const auto rows = readRows(output, file);
  if (rows.empty())
  {
    throw Error(file, "Fitted velocity components", "missing; give the output of a velocity fit");
  }
  const double scale = pixelScale(output, options, file);
  const Warp warp(output, rows.back().second[0]);
  for (const auto& [number, row] : rows)
  {
    Ring ring;
    ring.radius = scale * row[0];
    ring.rotationVelocity = row[rotationColumn];
    // Its azimuth runs toward PA + 90 degrees, against the rotation of the clockwise disc that
    // RingCode::Rotcur stands for: the same line-of-sight velocities are the opposite flow there.
    ring.expansionVelocity = -row[radialColumn];
    ring.systemicVelocity = output.value("Vsys (km/s):");
    warp.incline(row[0], ring);
    addRing(table, ring, "line " + std::to_string(number));
  }
  for (std::size_t k = 1; k < mostColumns; ++k)
  {
    RingColumn column{ columnNames[k], k == 1 ? "" : "km/s", {} };
    for (const auto& row : rows)
    {
      column.values.push_back(row.second[k]);
    }
    if (k != rotationColumn && k != radialColumn)
    {
      table.columns.push_back(std::move(column));
    }
  }
  return table;
}
} // namespace galaxy
