#include "Readers/Formats/BadPixels.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsHeader.h"
#include "Readers/Formats/PixelIndex.h"
#include "Readers/Formats/PixelLattice.h"
#include "Readers/Formats/RegionList.h"
#include "Readers/Formats/TextFile.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace galaxy
{
namespace
{
std::optional<WorldCoordinates> coordinatesIfAny(const Image& image)
{
  try
  {
    return WorldCoordinates(image.file, image.cards, image.width, image.height, image.axes);
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

/// From the image's pixels to the mask's.
PixelLattice wayToMask(
  const Image& image, const WorldCoordinates& own, const WorldCoordinates& masks)
{
  return PixelLattice(
    0.5, 0.5, image.width + 0.5, image.height + 0.5, [&own, &masks](double x, double y) {
      SkyPosition sky;
      PixelPosition pixel;
      return own.pixelToSky({ x, y }, sky) && masks.skyToPixel(sky, pixel)
        ? pixel
        : PixelLattice::nowhere();
    });
}

bool marks(const Image& mask, const PixelPosition& pixel)
{
  const double column = pixelIndex(pixel.x), row = pixelIndex(pixel.y);
  if (!(column >= 0 && column < mask.width && row >= 0 && row < mask.height))
  {
    return false;
  }
  // NaN is not 0 either.
  return !(mask.at(static_cast<int>(column), static_cast<int>(row)) == 0);
}

void applyMask(const Image& mask, const ImageDescription& description, Image& image)
{
  PixelLattice way;
  if (const std::optional<WorldCoordinates> masks = coordinatesIfAny(mask))
  {
    way = wayToMask(image, coordinatesOf(image, description), *masks);
  }
  else if (mask.width != image.width || mask.height != image.height)
  {
    throw Error(
      mask.file, "mask", "must have celestial coordinates, or as many pixels as " + image.file);
  }
  std::size_t pixel = 0;
  for (int row = 1; row <= image.height; ++row)
  {
    for (int column = 1; column <= image.width; ++column, ++pixel)
    {
      const PixelPosition here = { double(column), double(row) };
      image.bad[pixel] |= marks(mask, way.size() > 0 ? way.at(here.x, here.y) : here);
    }
  }
}

/// Sets the pixels of a region, for which only its bounding box is looked at.
void applyRegion(const PixelRegion& region, Image& image)
{
  const std::uint8_t value = region.excluded ? 0 : 1;
  const auto byX = [](const PixelPosition& p, const PixelPosition& q) { return p.x < q.x; };
  const auto byY = [](const PixelPosition& p, const PixelPosition& q) { return p.y < q.y; };
  const auto& corners = region.corners;
  const auto [left, right] = std::minmax_element(corners.begin(), corners.end(), byX);
  const auto [bottom, top] = std::minmax_element(corners.begin(), corners.end(), byY);
  const auto within = [](double value, int size) {
    return value > 0 ? static_cast<int>(std::min(value, size + 1.0)) : 0; // also of NaN
  };
  const int lastColumn = std::min(within(right->x, image.width), image.width);
  const int lastRow = std::min(within(top->y, image.height), image.height);
  const auto set = [&](int column, int row) {
    image.bad[static_cast<std::size_t>(row - 1) * image.width + column - 1] = value;
  };
  for (int row = std::max(1, within(bottom->y, image.height)); row <= lastRow; ++row)
  {
    for (int column = std::max(1, within(left->x, image.width)); column <= lastColumn; ++column)
    {
      // A little beside the middle: borders through the middles of pixels are as frequent as
      // between.
      if (region.contains({ column + borderWidth, row + 0.7 * borderWidth }))
      {
        set(column, row);
      }
    }
  }
  const int column = within(pixelIndex(region.middle.x) + 1, image.width);
  const int row = within(pixelIndex(region.middle.y) + 1, image.height);
  if (column >= 1 && column <= image.width && row >= 1 && row <= image.height)
  {
    set(column, row);
  }
}

void applyRegions(const std::string& file, const ImageDescription& description, Image& image)
{
  std::optional<WorldCoordinates> coordinates;
  if (description.suppliesCoordinates)
  {
    coordinates = coordinatesOf(image, description);
  }
  else
  {
    coordinates = coordinatesIfAny(image);
  }
  RegionCanvas canvas;
  canvas.coordinates = coordinates ? &*coordinates : nullptr;
  const FitsHeader header(image.cards);
  canvas.shift = { header.number("LTV1").value_or(0), header.number("LTV2").value_or(0) };
  canvas.scale = { header.number("LTM1_1").value_or(1), header.number("LTM2_2").value_or(1) };
  std::vector<PixelRegion> regions = parseRegions(readText(file), file, canvas);
  // What is excluded stays good wherever its line stands.
  std::stable_partition(
    regions.begin(), regions.end(), [](const PixelRegion& region) { return !region.excluded; });
  for (const PixelRegion& region : regions)
  {
    applyRegion(region, image);
  }
}
} // namespace

WorldCoordinates coordinatesOf(const Image& image, const ImageDescription& description)
{
  return description.suppliesCoordinates
    ? WorldCoordinates(description.coordinates, image.width, image.height)
    : WorldCoordinates(image.file, image.cards, image.width, image.height, image.axes);
}

void markBadPixels(const ImageDescription& description, const std::string& file, Image& image)
{
  if (description.mask.empty() && description.regions.empty())
  {
    return;
  }
  image.bad.assign(image.values.size(), 0);
  if (!description.regions.empty())
  {
    applyRegions(besideFile(file, description.regions), description, image);
  }
  if (!description.mask.empty())
  {
    applyMask(readFitsImage(besideFile(file, description.mask)), description, image);
  }
}
} // namespace galaxy
