#include "Filters/Model/ImageCleaning.h"

#include "Filters/Model/Background.h"
#include "Filters/Model/ForegroundStars.h"
#include "Filters/Model/HoleFilling.h"
#include "Readers/Formats/BadPixels.h"

#include <algorithm>
#include <limits>

namespace galaxy
{
std::vector<float> cleanedValues(
  const Image& image, const ImageDescription& description, double background)
{
  std::vector<float> values(image.values.size());
  std::transform(image.values.begin(), image.values.end(), values.begin(),
    [background](double value) { return static_cast<float>(value - background); });
  if (!image.bad.empty())
  {
    fillHoles(image.width, image.height, image.bad, values);
  }
  if (description.maskStarsAbove < std::numeric_limits<double>::infinity())
  {
    fillHoles(image.width, image.height,
      foregroundStars(image.width, image.height, description.maskStarsAbove, values), values);
  }
  return values;
}

SkyGrid gridOf(const Image& image, const ImageDescription& description)
{
  return { std::make_shared<const WorldCoordinates>(coordinatesOf(image, description)), image.width,
    image.height };
}

CleanImage cleanedImage(const Image& image, const ImageDescription& description)
{
  CleanImage clean;
  clean.grid = gridOf(image, description);
  clean.sky = skyOf(image);
  if (!description.automaticBackground)
  {
    clean.sky.level = description.background;
  }
  clean.values = cleanedValues(image, description, clean.sky.level);
  return clean;
}
} // namespace galaxy
