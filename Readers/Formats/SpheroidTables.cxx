#include "Readers/Formats/SpheroidTables.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/NumberTable.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
NumberTable clusterTable(const std::string& text, const std::string& file)
{
  return NumberTable(text, file,
    { { "x", Measure::Kpc }, { "y", Measure::Kpc }, { "z", Measure::Kpc },
      { "ra", Measure::RightAscension,
        { "ra_icrs", "raj2000", "ra_j2000", "_raj2000", "radeg", "right_ascension" } },
      { "dec", Measure::Degrees,
        { "de_icrs", "dec_icrs", "dej2000", "decj2000", "dec_j2000", "_dej2000", "dedeg", "decdeg",
          "declination", "de" } },
      { "distance", Measure::Mpc, { "dist" } }, { "luminosity", Measure::Number, { "lum" } },
      { "radius", Measure::Kpc } });
}

/// Seen from Earth at (0, 0, D), the direction through (x, y) of the plane Z = 0.
Vec3 skyPlace(const NumberTable& table, std::size_t row, const SkyFrame& sky, double distance)
{
  const SkyPosition position = { table.number(row, "ra", Range::any()),
    table.number(row, "dec", Range::from(-90, 90)) };
  Vec3 p;
  if (!sky.skyToPlane(position, p.x, p.y))
  {
    table.fail(row, "ra, dec must lie less than 90 degrees from the galaxy");
  }
  if (!table.has("distance"))
  {
    return p;
  }
  const Vec3 earth = { 0, 0, 1000 * distance };
  return earth + 1000 * table.number(row, "distance", Range::positive()) * normalized(p - earth);
}

/// The angle's equal, modulo `period`, that is nearest to `before`.
double unwrapped(double angle, double before, double period)
{
  return before + std::remainder(angle - before, period);
}
} // namespace

std::vector<StarCluster> parseClusterList(
  const std::string& text, const std::string& file, const SkyPosition& centre, double distance)
{
  const NumberTable table = clusterTable(text, file);
  const SkyFrame sky(centre, distance);
  const bool cartesian = table.has("x") || table.has("y") || table.has("z");
  std::vector<StarCluster> clusters(table.size());
  double light = 0;
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    const auto coordinate = [&](const char* axis) { return table.number(row, axis, Range::any()); };
    clusters[row].position = cartesian ? Vec3{ coordinate("x"), coordinate("y"), coordinate("z") }
                                       : skyPlace(table, row, sky, distance);
    clusters[row].luminosity = table.number(row, "luminosity", Range::notNegative(), 1);
    clusters[row].radius = table.number(row, "radius", Range::positive(), 0);
    light += clusters[row].luminosity;
  }
  if (!(light > 0 && std::isfinite(light)))
  {
    throw Error(file, "luminosity", "the sum must be greater than 0, and finite");
  }
  return clusters;
}

std::vector<StarCluster> parseClusterList(const std::string& text, const std::string& file)
{
  if (!clusterTable(text, file).has("x"))
  {
    throw Error(file, "x", "the columns must be x, y and z, for no sky is known here");
  }
  return parseClusterList(text, file, {}, 1);
}

std::vector<EllipsoidShell> parseEllipsoidShells(const std::string& text, const std::string& file)
{
  constexpr Range ratio = { 0, 1, true };
  const NumberTable table(text, file,
    { { "semi_major", Measure::Kpc, { "semi_major_axis", "semimajor_axis", "semimajor", "sma" } },
      { "axis_ratio_b", Measure::Number, { "b/a" } },
      { "axis_ratio_c", Measure::Number, { "c/a" } },
      { "position_angle", Measure::Degrees, { "pa" } },
      { "inclination", Measure::Degrees, { "inc", "incl" } } });
  std::vector<EllipsoidShell> shells(table.size());
  for (std::size_t row = 0; row < table.size(); ++row)
  {
    EllipsoidShell& shell = shells[row];
    shell.semiMajor = table.number(row, "semi_major", Range::notNegative());
    shell.axisRatios = { table.number(row, "axis_ratio_b", ratio),
      table.number(row, "axis_ratio_c", ratio) };
    shell.positionAngle = table.number(row, "position_angle", Range::any());
    shell.inclination = table.number(row, "inclination", Range::from(-180, 180), 0);
    if (row > 0 && !(shell.semiMajor > shells[row - 1].semiMajor))
    {
      table.fail(row, "semi_major must be greater than in the row before");
    }
  }
  const bool inclined = std::any_of(shells.begin(), shells.end(),
    [](const EllipsoidShell& shell) { return shell.inclination != 0; });
  for (std::size_t k = 1; k < shells.size(); ++k)
  {
    shells[k].positionAngle =
      unwrapped(shells[k].positionAngle, shells[k - 1].positionAngle, inclined ? 360 : 180);
    shells[k].inclination = unwrapped(shells[k].inclination, shells[k - 1].inclination, 360);
  }
  return shells;
}
} // namespace galaxy
