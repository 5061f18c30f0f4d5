#include "Filters/Model/ImageCleaning.h"

#include "Filters/Model/Background.h"
#include "Filters/Model/ForegroundStars.h"
#include "Filters/Model/HoleFilling.h"
#include "Readers/Formats/BadPixels.h"

#include <algorithm>
#include <limits>

namespace galaxy
{
std::vector<float> cleanedValues(const Image& image, const ImageDescription& description)
{
  const double background =
    description.automaticBackground ? borderBackground(image) : description.background;
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

CleanImage cleanedImage(const Image& image, const ImageDescription& description)
{
  CleanImage clean;
  clean.grid.coordinates =
    std::make_shared<const WorldCoordinates>(coordinatesOf(image, description));
  clean.grid.width = image.width;
  clean.grid.height = image.height;
  clean.values = cleanedValues(image, description);
  return clean;
}
} // namespace galaxy
