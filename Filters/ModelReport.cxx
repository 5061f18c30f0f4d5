#include "Filters/ModelReport.h"

#include "Filters/Model/GalaxyBuilder.h"

#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace galaxy
{
namespace
{
using Json = nlohmann::ordered_json;

/// A name on one line: what is no print is blank.
std::string printed(std::string name)
{
  const auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(name.begin(), name.end(), isControl, ' ');
  return name;
}

/// Whether a spheroid found much less light than it was to take.
bool isShort(const ComponentReport& component)
{
  return component.light < 0.75 * component.asked;
}

void addImage(const ImageReport& image, std::ostream& text)
{
  text << "  image " << printed(image.name) << ": background " << image.sky.level << ", scatter "
       << image.sky.scatter;
  if (image.clip)
  {
    text << ", clip " << (*image.clip)[0] << " to " << (*image.clip)[1] << " over the background";
  }
  text << (image.note.empty() ? "" : "; ") << printed(image.note) << "\n";
}

/// How thick a disc is drawn.
void addLayer(const std::vector<LayerHeight>& layer, std::ostream& text)
{
  const char* before = "  height (rms, kpc): drawn ";
  for (const LayerHeight& height : layer)
  {
    text << before << height.drawn << " of its model's " << height.model
         << " at R = " << height.radius;
    before = ", ";
  }
  text << (layer.empty() ? "" : "\n");
}

Json toJson(const LayerHeight& height)
{
  return { { "radius", height.radius }, { "drawn", height.drawn }, { "model", height.model } };
}

Json toJson(const ImageReport& image)
{
  Json json = { { "image", image.name }, { "background", image.sky.level },
    { "scatter", image.sky.scatter } };
  json["clip"] = image.clip ? Json(*image.clip) : Json();
  if (!image.note.empty())
  {
    json["note"] = image.note;
  }
  return json;
}

Json toJson(const StageSeconds& seconds)
{
  return { { "images", seconds.images }, { "light", seconds.light }, { "seeds", seconds.seeds },
    { "thickness", seconds.thickness }, { "photometry", seconds.photometry },
    { "smoothing", seconds.smoothing } };
}

Json toJson(const ComponentReport& component)
{
  Json json = { { "component", component.name }, { "seeds_drawn", component.seedsDrawn },
    { "seeds_kept", component.seedsKept }, { "particles", component.particles },
    { "filled", component.filled }, { "blank_pixels", component.dark.blank },
    { "negative_pixels", component.dark.negative }, { "bins", component.bins },
    { "flux", component.flux }, { "light", component.light }, { "light_asked", component.asked },
    { "end", component.end }, { "light_beyond_end", component.beyond },
    { "smoothing_length", component.smoothingLength } };
  json["images"] = Json::array();
  for (const ImageReport& image : component.images)
  {
    json["images"].push_back(toJson(image));
  }
  json["heights"] = Json::array();
  for (const LayerHeight& height : component.layer)
  {
    json["heights"].push_back(toJson(height));
  }
  json["seconds"] = toJson(component.seconds);
  return json;
}
} // namespace

std::string inWords(const BuildReport& report)
{
  std::ostringstream text;
  for (const ComponentReport& component : report.components)
  {
    text << std::fixed << std::setprecision(2) << printed(component.name) << ": "
         << component.particles << " particles of h = " << component.smoothingLength << " kpc";
    if (component.seedsDrawn > 0)
    {
      text << " from " << component.seedsKept << " of " << component.seedsDrawn << " seeds";
    }
    if (component.flux > 0)
    {
      text << "; " << std::setprecision(1) << 100 * component.light / component.flux
           << " % of its images' light lies on the disc" << std::setprecision(2);
    }
    if (component.end > 0)
    {
      text << "; ends at " << component.end << " kpc, beyond which its profile has "
           << 100 * component.beyond << " % of its light";
    }
    if (component.asked > 0)
    {
      text << "; takes " << 100 * component.light / component.asked
           << " % of the light that it is to take, as far as the pixels under it have that";
    }
    if (component.dark.blank + component.dark.negative > 0)
    {
      text << "; of the pixels of its images " << component.dark.blank << " are blank and "
           << component.dark.negative << " negative";
    }
    if (component.bins > 1)
    {
      text << "; so few seeds that pixels were joined " << component.bins << " x "
           << component.bins;
    }
    text << "; " << component.seconds.total() << " s\n"
         << std::defaultfloat << std::setprecision(5);
    for (const ImageReport& image : component.images)
    {
      addImage(image, text);
    }
    text << std::setprecision(2);
    addLayer(component.layer, text);
  }
  return text.str();
}

std::string asJSON(const BuildReport& report)
{
  Json list = Json::array();
  for (const ComponentReport& component : report.components)
  {
    list.push_back(toJson(component));
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string shortOnes(const BuildReport& report)
{
  std::string names;
  for (const ComponentReport& component : report.components)
  {
    if (isShort(component))
    {
      char share[24];
      std::snprintf(share, sizeof(share), " (%.1f %%)", 100 * component.light / component.asked);
      names += (names.empty() ? "" : ", ") + printed(component.name) + share;
    }
  }
  return names;
}

std::string darkOnes(const BuildReport& report, bool haveSeeds)
{
  std::string names;
  for (const ComponentReport& component : report.components)
  {
    const bool isMissed =
      haveSeeds ? component.seedsDrawn > 0 : component.seedsDrawn == 0 && component.flux > 0;
    if (isMissed && component.particles == 0)
    {
      names += (names.empty() ? "" : ", ") + printed(component.name);
    }
  }
  return names;
}
} // namespace galaxy
