#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"
#include "Readers/Formats/TirificKeywords.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
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

/// What else a ring has that is worth a column.
struct FurtherParameter
{
  const char* keyword;
  const char* unit;
};
constexpr FurtherParameter furtherParameters[] = {
  { "SDIS", "km/s" },
  { "XPOS", "deg" },
  { "YPOS", "deg" },
  { "DVRO", "km/s/arcsec" },
  { "ZDRO", "arcsec" },
  { "VVER", "km/s" },
};
/// Those that FAT leaves errors of, in comments.
constexpr FurtherParameter errors[] = {
  { "VROT", "km/s" },
  { "Z0", "arcsec" },
  { "SBR", "Jy km/s/arcsec^2" },
  { "INCL", "deg" },
  { "PA", "deg" },
  { "VSYS", "km/s" },
  { "SDIS", "km/s" },
  { "XPOS", "deg" },
  { "YPOS", "deg" },
};

/// The keyword of a disk: VROT, VROT_2, ...
std::string ofDisk(const std::string& keyword, int disk)
{
  return disk == 1 ? keyword : keyword + "_" + std::to_string(disk);
}

/// Of a list that may be shorter than the rings, the last holds.
double held(const std::vector<double>& values, std::size_t index)
{
  return values[std::min(index, values.size() - 1)];
}

std::vector<Ring> ringsAtRadii(const TirificKeywords& keywords, const std::string& file)
{
  const std::vector<double> radii = keywords.numbers("RADI");
  if (radii.empty())
  {
    throw Error(file, keywords.where("RADI"), "missing; give the radius of every ring");
  }
  constexpr int mostRings = 1000000;
  const int count = keywords.whole("NUR", 1, mostRings, static_cast<int>(radii.size()));
  if (static_cast<int>(radii.size()) < count)
  {
    throw Error(file, keywords.where("RADI"),
      "has " + std::to_string(radii.size()) + " values, must have NUR = " + std::to_string(count));
  }
  std::vector<Ring> rings(count);
  for (int i = 0; i < count; ++i)
  {
    rings[i].radius = radii[i];
  }
  return rings;
}

void addColumn(
  RingTable& table, const std::string& name, const char* unit, const std::vector<double>& values)
{
  if (!values.empty())
  {
    RingColumn column{ name, unit, {} };
    for (std::size_t i = 0; i < table.rings.size(); ++i)
    {
      column.values.push_back(held(values, i));
    }
    table.columns.push_back(std::move(column));
  }
}

RingTable readDisk(const TirificKeywords& keywords, int disk, const std::string& file)
{
  RingTable table;
  table.file = file;
  table.code = RingCode::Tirific;
  const int law = keywords.whole("LTYPE", 1, 5, static_cast<int>(LayerLaw::Sech2));
  table.layerLaw = static_cast<LayerLaw>(keywords.whole(ofDisk("LTYPE", disk), 1, 5, law));
  table.rings = ringsAtRadii(keywords, file);
  for (const Parameter& parameter : parameters)
  {
    const std::string keyword = ofDisk(parameter.keyword, disk);
    const std::vector<double> values = keywords.numbers(keyword);
    if (values.empty() && parameter.required)
    {
      throw Error(file, keywords.where(keyword),
        "missing, or without a value; give one a ring, or one for all");
    }
    for (std::size_t i = 0; i < table.rings.size() && !values.empty(); ++i)
    {
      table.rings[i].*parameter.member = held(values, i);
    }
  }
  for (const FurtherParameter& parameter : furtherParameters)
  {
    // Only of a right ascension are colons hours; other values have none.
    const bool ascension = std::string(parameter.keyword) == "XPOS";
    addColumn(table, parameter.keyword, parameter.unit,
      keywords.angles(ofDisk(parameter.keyword, disk), ascension));
  }
  for (const FurtherParameter& parameter : errors)
  {
    addColumn(table, std::string(parameter.keyword) + "_ERR", parameter.unit,
      keywords.commentedNumbers(ofDisk(parameter.keyword, disk) + "_ERR"));
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

/// True where two disks are halves of one: both 180 degrees wide, centred 180 degrees apart.
bool areHalves(const TirificKeywords& keywords, int first, int second)
{
  const auto values = [&](const char* keyword, int disk, double absent) {
    const std::vector<double> numbers = keywords.numbers(ofDisk(keyword, disk));
    return numbers.empty() ? std::vector<double>{ absent } : numbers;
  };
  const auto widths = values("AZ1W", first, 360), otherWidths = values("AZ1W", second, 360);
  const auto centres = values("AZ1P", first, 0), otherCentres = values("AZ1P", second, 0);
  const auto isHalf = [](double width) { return width == 180; };
  bool opposite = true;
  for (std::size_t i = 0; i < std::max(centres.size(), otherCentres.size()); ++i)
  {
    opposite =
      opposite && std::abs(std::remainder(held(centres, i) - held(otherCentres, i), 360)) == 180;
  }
  return opposite && std::all_of(widths.begin(), widths.end(), isHalf) &&
    std::all_of(otherWidths.begin(), otherWidths.end(), isHalf);
}

/// The disk that is the other half of `disk`.
int otherHalf(const TirificKeywords& keywords, int disk, int disks, const std::string& file)
{
  for (int other = 1; other <= disks; ++other)
  {
    if (other != disk && areHalves(keywords, disk, other))
    {
      return other;
    }
  }
  throw Error(file, keywords.where(ofDisk("AZ1W", disk)),
    "no disk is the other half of disk " + std::to_string(disk) + "; use ring_sides = \"First\"");
}

/// Moves every value half way to the other side's, angles by the shorter way.
void average(RingTable& table, const RingTable& other)
{
  for (std::size_t i = 0; i < table.rings.size(); ++i)
  {
    for (const Parameter& parameter : parameters)
    {
      double& value = table.rings[i].*parameter.member;
      const double step = other.rings[i].*parameter.member - value;
      const bool turns =
        parameter.member == &Ring::positionAngle || parameter.member == &Ring::inclination;
      value += (turns ? std::remainder(step, 360) : step) / 2;
    }
  }
  for (RingColumn& column : table.columns)
  {
    for (const RingColumn& same : other.columns)
    {
      for (std::size_t i = 0; same.name == column.name && i < column.values.size(); ++i)
      {
        column.values[i] += (same.values[i] - column.values[i]) / 2;
      }
    }
  }
}
} // namespace

RingTable parseTirific(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options)
{
  const TirificKeywords keywords(lines, file);
  constexpr int mostDisks = 1000;
  const int disks = keywords.whole("NDISKS", 1, mostDisks, 1);
  if (options.disk < 1 || options.disk > disks)
  {
    throw Error(file, keywords.where("NDISKS"),
      "there is no disk " + std::to_string(options.disk) + "; choose ring_disk from 1 to " +
        std::to_string(disks));
  }
  if (options.sides == RingSides::First)
  {
    return readDisk(keywords, options.disk, file);
  }
  const int other = otherHalf(keywords, options.disk, disks, file);
  RingTable second = readDisk(keywords, other, file);
  if (options.sides == RingSides::Second)
  {
    return second;
  }
  RingTable table = readDisk(keywords, options.disk, file);
  average(table, second);
  return table;
}
} // namespace galaxy
