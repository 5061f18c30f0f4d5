#include "PlaceOnSky.h"

#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Error.h"

#include "vtkImageData.h"

namespace galaxy
{
namespace
{
/// Where a pixel's centre lies in the plane; false where it has no place there.
bool pixelToPlane(const WorldCoordinates& coordinates, const SkyFrame& frame,
  const PixelPosition& pixel, Vec3& place)
{
  SkyPosition sky;
  return coordinates.pixelToSky(pixel, sky) && frame.skyToPlane(sky, place.x, place.y);
}
}

void placeOnSky(const Image& image, const ImageDescription& description, const SkyFrame& frame,
  vtkImageData* output)
{
  const PixelPosition middle = { 0.5 * (image.width + 1), 0.5 * (image.height + 1) };
  Vec3 centre, right, up;
  try
  {
    const WorldCoordinates coordinates = coordinatesOf(image, description);
    if (!pixelToPlane(coordinates, frame, middle, centre) ||
      !pixelToPlane(coordinates, frame, { middle.x + 1, middle.y }, right) ||
      !pixelToPlane(coordinates, frame, { middle.x, middle.y + 1 }, up))
    {
      return;
    }
  }
  catch (const Error&)
  {
    return; // said when a component asks for this image
  }
  const Vec3 dx = right - centre, dy = up - centre;
  const double width = length(dx), height = length(dy);
  if (!(width > 0 && height > 0 && cross(dx, dy).z != 0))
  {
    return;
  }
  const Vec3 first = centre - (middle.x - 1) * dx - (middle.y - 1) * dy;
  output->SetOrigin(first.x, first.y, 0);
  output->SetSpacing(width, height, 1);
  output->SetDirectionMatrix(
    dx.x / width, dy.x / height, 0, dx.y / width, dy.y / height, 0, 0, 0, 1);
}
}
