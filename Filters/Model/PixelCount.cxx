#include "Filters/Model/PixelCount.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace galaxy
{
namespace
{
/// The names of a component's images, those combined replaced by what makes them.
std::set<std::string> imagesOf(
  const GalaxyDescription& galaxy, const ComponentDescription& component)
{
  std::set<std::string> names;
  for (const LayerDescription& layer : component.layers)
  {
    const auto image = std::find_if(galaxy.images.begin(), galaxy.images.end(),
      [&](const ImageDescription& description) { return description.name == layer.image; });
    if (image == galaxy.images.end() || image->combine.empty())
    {
      names.insert(layer.image);
      continue;
    }
    names.insert(image->combine.begin(), image->combine.end());
  }
  return names;
}

PixelCount countIn(const std::vector<double>& values)
{
  std::size_t blank = 0, negative = 0;
#pragma omp parallel for schedule(static) reduction(+ : blank, negative)
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    blank += std::isnan(values[i]);
    negative += values[i] < 0;
  }
  return { blank, negative };
}
} // namespace

PixelCount countPixels(const Galaxy& galaxy, const ComponentDescription& component)
{
  const std::set<std::string> names = imagesOf(galaxy.description, component);
  PixelCount total;
  for (std::size_t k = 0; k < galaxy.images.size(); ++k)
  {
    if (names.count(galaxy.description.images[k].name))
    {
      const PixelCount count = countIn(galaxy.images[k].values);
      total.blank += count.blank;
      total.negative += count.negative;
    }
  }
  return total;
}
} // namespace galaxy
