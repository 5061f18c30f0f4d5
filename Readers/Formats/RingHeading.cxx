#include "Readers/Formats/RingHeading.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/KeyTable.h"

#include <algorithm>
#include <set>

namespace galaxy
{
namespace
{
bool contains(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string headingPlace(const TextTable& table)
{
  return table.headingLine > 0 ? lineName(table.headingLine) : "";
}

/// The column that the options name for a quantity.
int chosenColumn(const std::string& symbol, const std::string& name, const TextTable& table)
{
  std::vector<std::string> known;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
  {
    const TableColumn& column = table.columns[k];
    if (plainName(column.name) == plainName(name) || column.text == name)
    {
      return static_cast<int>(k);
    }
    known.push_back(column.name);
  }
  throw Error(table.file, headingPlace(table),
    "there is no column " + quoted(name) + " for " + symbol + ", as ring_columns says" +
      suggestion(name, known));
}

/// How well a column serves for a quantity; the least is the best.
int rank(const Quantity& quantity, const TableColumn& column)
{
  const int lesser = contains(quantity.names, plainName(column.name)) ? 0 : 1;
  if (quantity.dimension != Dimension::Length)
  {
    return lesser;
  }
  double kpc;
  return lesser + (isAngularLength(column.unit) ? 0 : kpcOf(column.unit, kpc) ? 2 : 4);
}

/// Names equal but for capitals and blanks: NGC 628 and ngc628.
std::string bareName(const std::string& name)
{
  std::string bare = lowered(name);
  bare.erase(std::remove_if(bare.begin(), bare.end(), [](char c) { return c == ' ' || c == '_'; }),
    bare.end());
  return bare;
}

int galaxyColumn(const TextTable& table, const RingOptions& options)
{
  const auto chosen = options.columns.find("name");
  if (chosen != options.columns.end())
  {
    return chosenColumn("name", chosen->second, table);
  }
  for (std::size_t k = 0; k < table.columns.size(); ++k)
  {
    if (table.headingLine > 0 && ringWords({}).meaning(plainName(table.columns[k].name)) == "name")
    {
      return static_cast<int>(k);
    }
  }
  return -1;
}

std::string listed(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(names.size(), most); ++k)
  {
    text += (k == 0 ? "" : ", ") + printable(shortened(names[k], 30));
  }
  return text +
    (names.size() > most ? " and " + std::to_string(names.size() - most) + " more" : "");
}

const char* const choose = "; choose one: ring_galaxy in [galaxy], GalaxyName of the ring reader";
} // namespace

const std::vector<Quantity>& ringQuantities()
{
  static const std::vector<Quantity> all = {
    { "r", &Ring::radius, true, Dimension::Length,
      { "r", "rad", "radi", "radius", "radii", "ring_radius", "galactocentric_radius" },
      { "sma", "semi_major_axis", "semimajor_axis" } },
    { "vrot", &Ring::rotationVelocity, true, Dimension::Velocity,
      { "vrot", "v_rot", "rotation_velocity", "rotationvelocity", "rotational_velocity", "rot_vel",
        "rotvel", "v_rotation", "vrotation" },
      { "vc", "v_c", "vcirc", "v_circ", "circular_velocity", "v", "vobs", "v_obs", "vt", "v_t",
        "vphi", "v_phi" } },
    { "Z0", &Ring::scaleHeight, false, Dimension::Length,
      { "z0", "z_0", "scale_height", "scaleheight", "hz", "h_z" }, { "height", "heights" } },
    { "i", &Ring::inclination, true, Dimension::Angle,
      { "inc", "incl", "inclin", "inclination", "inclination_angle" }, { "i" } },
    { "PA", &Ring::positionAngle, true, Dimension::Angle,
      { "pa", "position_angle", "positionangle", "posang", "pos_ang", "pos_angle" }, {} },
    { "SBR", &Ring::surfaceBrightness, false, Dimension::Number, { "sbr", "surface_brightness" },
      {} },
    { "vrad", &Ring::expansionVelocity, false, Dimension::Velocity,
      { "vrad", "v_rad", "vexp", "v_exp", "expansion_velocity" }, {} },
    { "vsys", &Ring::systemicVelocity, false, Dimension::Velocity,
      { "vsys", "v_sys", "systemic_velocity", "systemicvelocity" }, {} },
  };
  return all;
}

const Quantity* quantityOf(const std::string& name)
{
  // EDGE's tables have bbRad, bbVrot, bbInc, bbPA.
  const bool edge = name.size() > 3 && name.compare(0, 2, "bb") == 0;
  for (const Quantity& quantity : ringQuantities())
  {
    for (const std::string& plain : { name, edge ? name.substr(2) : name })
    {
      if (contains(quantity.names, plain) || contains(quantity.lesserNames, plain))
      {
        return &quantity;
      }
    }
  }
  return nullptr;
}

TableWords ringWords(const RingOptions& options)
{
  TableWords words;
  words.meaning = [columns = options.columns](const std::string& name) -> std::string {
    static const std::vector<std::string> galaxies = { "name", "galaxy", "galaxy_name",
      "galaxyname", "gal", "object", "object_name", "objname", "target", "source", "bbname" };
    for (const auto& [symbol, column] : columns)
    {
      if (plainName(column) == name)
      {
        return symbol;
      }
    }
    const Quantity* quantity = quantityOf(name);
    return quantity != nullptr ? quantity->symbol : contains(galaxies, name) ? "name" : "";
  };
  words.lengths = { "r", "Z0" };
  words.unnamed = { "r", "vrot", "Z0", "i", "PA" };
  return words;
}

int columnOf(const Quantity& quantity, const TextTable& table, const RingOptions& options)
{
  const auto chosen = options.columns.find(quantity.symbol);
  if (chosen != options.columns.end())
  {
    return chosenColumn(quantity.symbol, chosen->second, table);
  }
  int best = -1, equal = -1;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
  {
    if (quantityOf(plainName(table.columns[k].name)) != &quantity)
    {
      continue;
    }
    const int here = rank(quantity, table.columns[k]);
    const int before = best < 0 ? here + 1 : rank(quantity, table.columns[std::size_t(best)]);
    equal = here == before ? static_cast<int>(k) : here < before ? -1 : equal;
    best = here < before ? static_cast<int>(k) : best;
  }
  if (equal >= 0)
  {
    throw Error(table.file, headingPlace(table),
      "the columns " + quoted(table.columns[std::size_t(best)].text) + " and " +
        quoted(table.columns[std::size_t(equal)].text) + " both stand for " + quantity.symbol +
        "; choose one: ring_columns = { " + lowered(quantity.symbol) + " = \"" +
        table.columns[std::size_t(best)].text + "\" } in [galaxy], or leave one out");
  }
  return best;
}

void chooseGalaxy(TextTable& table, const RingOptions& options)
{
  const int column = galaxyColumn(table, options);
  if (column < 0)
  {
    if (!options.galaxyName.empty())
    {
      throw Error(table.file, headingPlace(table),
        "has no column with the galaxies' names, Name or Galaxy; leave ring_galaxy and GalaxyName "
        "out");
    }
    return;
  }
  const auto nameOf = [&](const TableRow& row) { return row.cells[std::size_t(column)]; };
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const TableRow& row : table.rows)
  {
    if (seen.insert(nameOf(row)).second)
    {
      names.push_back(nameOf(row));
    }
  }
  if (options.galaxyName.empty())
  {
    if (names.size() > 1)
    {
      throw Error(table.file, "column " + quoted(table.columns[std::size_t(column)].text),
        "holds " + std::to_string(names.size()) + " galaxies, " + listed(names) + choose);
    }
    return;
  }
  const bool exact = seen.count(options.galaxyName) > 0;
  const auto isOther = [&](const TableRow& row) {
    return exact ? nameOf(row) != options.galaxyName
                 : bareName(nameOf(row)) != bareName(options.galaxyName);
  };
  table.rows.erase(std::remove_if(table.rows.begin(), table.rows.end(), isOther), table.rows.end());
  if (table.rows.empty())
  {
    throw Error(table.file, "column " + quoted(table.columns[std::size_t(column)].text),
      "there is no galaxy " + quoted(options.galaxyName) + suggestion(options.galaxyName, names));
  }
}
} // namespace galaxy
