#include "Readers/Formats/GalaxyDescription.h"

#include "Readers/Formats/AbsorptionKeys.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyKeys.h"
#include "Readers/Formats/RingPlane.h"
#include "Readers/Formats/SpheroidTables.h"
#include "Readers/Formats/WidthTable.h"

#include <filesystem>
#include <functional>

namespace galaxy
{
namespace
{
/// Every layer must name an image that the file declares.
void checkLayers(const toml::table& root, const GalaxyDescription& galaxy)
{
  std::vector<std::string> declared;
  for (const ImageDescription& image : galaxy.images)
  {
    declared.push_back(image.name);
  }
  for (std::size_t c = 0; c < galaxy.components.size(); ++c)
  {
    const std::vector<LayerDescription>& layers = galaxy.components[c].layers;
    for (std::size_t l = 0; l < layers.size(); ++l)
    {
      const std::string& name = layers[l].image;
      if (std::find(declared.begin(), declared.end(), name) == declared.end())
      {
        KeyValue(galaxy.file, "image", *root["component"][c]["layers"][l]["image"].node())
          .fail("there is no [image." + name + "]" + suggestion(name, declared));
      }
    }
  }
}

/// A spheroid can take its light only from a disk whose images the file names.
void checkLightSources(const toml::table& root, const GalaxyDescription& galaxy)
{
  std::vector<std::string> sources;
  for (const ComponentDescription& component : galaxy.components)
  {
    if (usesImages(component) && component.role == ComponentRole::Emits)
    {
      sources.push_back(component.name);
    }
  }
  for (std::size_t c = 0; c < galaxy.components.size(); ++c)
  {
    const std::string& name = galaxy.components[c].spheroid.lightFrom;
    if (!name.empty() && std::find(sources.begin(), sources.end(), name) == sources.end())
    {
      KeyValue(galaxy.file, "light_from", *root["component"][c]["spheroid"]["light_from"].node())
        .fail("there is no component '" + name + "' of type Disk that emits the light of layers" +
          suggestion(name, sources));
    }
  }
}
/// Gives the text of a table by its path as the description has it.
using TextOf = std::function<std::string(const std::string& path)>;

/// The tables that the description names, each read once.
void readTables(GalaxyDescription& galaxy, const TextOf& textOf)
{
  const auto tableOf = [&](const std::string& path) -> const std::string& {
    const auto known = galaxy.tables.find(path);
    return known != galaxy.tables.end() ? known->second : galaxy.tables[path] = textOf(path);
  };
  for (ComponentDescription& component : galaxy.components)
  {
    const std::string& widths = component.thickness.profileFile;
    if (!widths.empty())
    {
      component.thickness.profileTable =
        parseWidthTable(tableOf(widths), besideFile(galaxy.file, widths));
    }
    SpheroidDescription& spheroid = component.spheroid;
    if (!spheroid.clusterList.empty())
    {
      spheroid.listed = parseClusterList(tableOf(spheroid.clusterList),
        besideFile(galaxy.file, spheroid.clusterList), galaxy.centre, galaxy.distance);
    }
    if (!spheroid.shells.empty())
    {
      spheroid.ellipsoids =
        parseEllipsoidShells(tableOf(spheroid.shells), besideFile(galaxy.file, spheroid.shells));
    }
  }
}

GalaxyDescription parse(const std::string& text, const std::string& file, const TextOf& textOf)
{
  const toml::table root = parseToml(text, file);
  GalaxyDescription galaxy;
  galaxy.file = file;
  galaxy.text = text;
  galaxy.name = std::filesystem::path(file).stem().string();
  readTable(file, "", root, fileKeys(), galaxy);
  checkLayers(root, galaxy);
  checkAbsorption(root, galaxy);
  checkLightSources(root, galaxy);
  noteRotation(root, galaxy);
  readTables(galaxy, textOf);
  return galaxy;
}
} // namespace

toml::table parseToml(const std::string& text, const std::string& file)
{
  try
  {
    return toml::parse(plainText(text, file), file);
  }
  catch (const toml::parse_error& error)
  {
    throw Error(file, "line " + std::to_string(error.source().begin.line),
      std::string(error.description()) + "; correct it as TOML");
  }
}

GalaxyDescription parseGalaxyDescription(const std::string& text, const std::string& file)
{
  return parse(
    text, file, [&](const std::string& path) { return readText(besideFile(file, path)); });
}

GalaxyDescription parseGalaxyDescription(
  const std::string& text, const std::string& file, const NamedTexts& tables)
{
  return parse(text, file, [&](const std::string& path) {
    const auto table = tables.find(path);
    if (table == tables.end())
    {
      throw Error(
        file, path, "the table did not come with the galaxy; connect GalaxyReader itself");
    }
    return table->second;
  });
}

GalaxyDescription readGalaxyDescription(const std::string& file)
{
  return parseGalaxyDescription(readText(file), file);
}

std::string besideFile(const std::string& file, const std::string& path)
{
  return (std::filesystem::path(file).parent_path() / path).string();
}

RingTable readRings(const GalaxyDescription& galaxy)
{
  if (!galaxy.rings.empty())
  {
    RingOptions options = galaxy.ringOptions;
    options.distance = galaxy.distance;
    return readRingTable(besideFile(galaxy.file, galaxy.rings), options);
  }
  Ring centre;
  centre.rotationVelocity = galaxy.rotationVelocity;
  centre.inclination = galaxy.inclination;
  centre.positionAngle = galaxy.positionAngle;
  Ring edge = centre;
  edge.radius = galaxy.radius / kpcPerArcsec(galaxy.distance);
  RingTable table;
  table.file = galaxy.file;
  table.rings = { centre, edge };
  return table;
}
} // namespace galaxy
