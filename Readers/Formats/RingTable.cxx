#include "Readers/Formats/RingTable.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingText.h"

#include <cmath>

namespace galaxy
{
namespace
{
/// Folds each angle to within half a turn of the one before.
void unwrap(std::vector<Ring>& rings, double Ring::*angle)
{
  for (std::size_t k = 1; k < rings.size(); ++k)
  {
    const double turns = (rings[k].*angle - rings[k - 1].*angle) / 360;
    rings[k].*angle -= 360 * std::rint(turns);
  }
}

RingTable parse(
  const std::vector<TextLine>& lines, const std::string& file, const RingOptions& options)
{
  const bool tirific = !isRotcur(lines) && isTirific(lines);
  if ((isDiskFit(lines) || tirific) && !(options.galaxyName.empty() && options.columns.empty()))
  {
    throw Error(file, "",
      "must have a column with the galaxies' names and a heading for ring_galaxy, GalaxyName or "
      "ring_columns; leave them out");
  }
  if (isDiskFit(lines))
  {
    return parseDiskFit(lines, file, options);
  }
  if (isRotcur(lines))
  {
    return parseRotcur(lines, file, options);
  }
  return tirific ? parseTirific(lines, file, options) : parseRingColumns(lines, file, options);
}
} // namespace

void checkRing(
  const Ring& ring, const Ring* before, const std::string& file, const std::string& where)
{
  constexpr double leastStep = 1e-6; // arcsec; a plane that turns on less is no disc
  constexpr double halfSky = 180 * 3600;
  constexpr double lightSpeed = 299792.458;
  const auto fail = [&](const char* what) { throw Error(file, where, what); };
  if (ring.radius < 0)
  {
    fail("the radius must be at least 0");
  }
  if (before != nullptr && ring.radius < before->radius)
  {
    fail("the radius must not be smaller than that of the ring before");
  }
  if (before != nullptr && ring.radius > before->radius && ring.radius - before->radius < leastStep)
  {
    fail("the radius must be that of the ring before, which makes a step, or at least 1e-6 arcsec "
         "more");
  }
  if (ring.scaleHeight < 0)
  {
    fail("the scale height must be at least 0");
  }
  if (!(ring.radius <= halfSky && ring.scaleHeight <= halfSky))
  {
    fail("the ring is larger than the sky; check the units of radius and scale height");
  }
  for (const double velocity : { ring.rotationVelocity, ring.expansionVelocity })
  {
    if (!(std::abs(velocity) <= lightSpeed))
    {
      fail("a velocity is greater than that of light; check its unit");
    }
  }
  for (const double angle : { ring.inclination, ring.positionAngle })
  {
    if (!(std::abs(angle) <= 3600))
    {
      fail("an angle is more than ten turns; check the columns' order");
    }
  }
}

void addRing(RingTable& table, const Ring& ring, const std::string& where)
{
  checkRing(ring, table.rings.empty() ? nullptr : &table.rings.back(), table.file, where);
  table.rings.push_back(ring);
}

RingTable parseRingTable(
  const std::string& text, const std::string& file, const RingOptions& options)
{
  RingTable table = parse(splitLines(plainText(text, file)), file, options);
  if (table.rings.empty())
  {
    throw Error(file, "", "holds no rings; give a row for each: r vrot Z0 i PA");
  }
  unwrap(table.rings, &Ring::positionAngle);
  unwrap(table.rings, &Ring::inclination);
  if (options.layerLaw != LayerLaw::FromFile)
  {
    table.layerLaw = options.layerLaw;
  }
  return table;
}

RingTable readRingTable(const std::string& file, const RingOptions& options)
{
  return parseRingTable(readText(file), file, options);
}
} // namespace galaxy
