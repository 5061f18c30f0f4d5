#include "Filters/Model/Viewpoints.h"

#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/SkyFrame.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr double degree = 3.14159265358979323846 / 180;
constexpr double nearViewAngle = 30; // ParaView's own

/// The corners and the middles of the edges of an image; 0 where none has a place on the sky.
double halfSizeOf(const Image& image, const ImageDescription& description, const SkyFrame& frame)
{
  const WorldCoordinates coordinates = coordinatesOf(image, description);
  double halfSize = 0;
  for (const double u : { 0.0, 0.5, 1.0 })
  {
    for (const double v : { 0.0, 0.5, 1.0 })
    {
      SkyPosition sky;
      double x = 0, y = 0;
      if (coordinates.pixelToSky({ 0.5 + u * image.width, 0.5 + v * image.height }, sky) &&
        frame.skyToPlane(sky, x, y))
      {
        halfSize = std::max({ halfSize, std::abs(x), std::abs(y) });
      }
    }
  }
  return halfSize;
}

std::vector<ImageField> fieldsOf(const Galaxy& galaxy)
{
  const SkyFrame frame(galaxy.description.centre, galaxy.description.distance);
  std::vector<ImageField> fields;
  for (std::size_t k = 0; k < galaxy.images.size(); ++k)
  {
    const ImageDescription& description = galaxy.description.images[k];
    try
    {
      // One that is combined of others is empty here.
      const double halfSize =
        galaxy.images[k].values.empty() ? 0 : halfSizeOf(galaxy.images[k], description, frame);
      if (halfSize > 0 && std::isfinite(halfSize))
      {
        fields.push_back({ description.name, halfSize });
      }
    }
    catch (const Error&)
    {
      // Said when a component asks for this image.
    }
  }
  return fields;
}

/// The field of the first image that a component is lit from, or 0.
double litField(const GalaxyDescription& description, const std::vector<ImageField>& fields)
{
  for (const ComponentDescription& component : description.components)
  {
    for (const LayerDescription& layer : component.layers)
    {
      const auto found = std::find_if(fields.begin(), fields.end(),
        [&layer](const ImageField& field) { return field.image == layer.image; });
      if (found != fields.end())
      {
        return found->halfSize;
      }
    }
  }
  return 0;
}

/// The disc's axes as seen from Earth: the normal on the observer's side, and the minor axis that
/// completes (major, minor, normal) to a right-handed frame.
struct SeenAxes
{
  Vec3 normal;
  Vec3 minor;
};

SeenAxes seenAxes(const Outlook& outlook)
{
  const Vec3 normal = (outlook.normal.z < 0 ? -1.0 : 1.0) * outlook.normal;
  return { normal, cross(normal, outlook.majorAxis) };
}

Viewpoint nearView(const Outlook& outlook, const Vec3& direction, const Vec3& up)
{
  const double distance = outlook.halfSize / std::tan(0.5 * nearViewAngle * degree);
  return { distance * direction, {}, up, nearViewAngle };
}
} // namespace

Outlook outlookOf(const Galaxy& galaxy)
{
  const GalaxyDescription& description = galaxy.description;
  const TiltedDisk disk(galaxy.rings, description.distance, description.spin,
    description.interpolation, description.beyondLastRing);
  const RingFrame centre = disk.frame(0);
  Outlook outlook;
  outlook.distance = 1000 * description.distance;
  outlook.normal = centre.n;
  outlook.majorAxis = centre.a;
  outlook.fields = fieldsOf(galaxy);
  outlook.halfSize = litField(description, outlook.fields);
  if (outlook.halfSize == 0)
  {
    outlook.halfSize = disk.lastRadius() > 0 ? disk.lastRadius() : 1;
  }
  return outlook;
}

double halfSizeOf(const Particles& particles, double distance)
{
  double halfSize = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    const float* p = &particles.position[3 * i];
    const double depth = distance - p[2];
    if (depth > 0)
    {
      const double off = std::max(std::abs(p[0]), std::abs(p[1]));
      halfSize = std::max(halfSize, off * distance / depth);
    }
  }
  return halfSize;
}

Viewpoint earthView(double distance, double halfSize)
{
  return { { 0, 0, distance }, {}, { 0, 1, 0 }, 2 * std::atan2(halfSize, distance) / degree };
}

double fittedAngle(double viewAngle, double aspect)
{
  return aspect < 1 ? 2 * std::atan(std::tan(0.5 * viewAngle * degree) / aspect) / degree
                    : viewAngle;
}

// Tilted about the major axis M until the normal points to the eye, the sky's North (0, 1, 0) stays
// as far along M and turns from Z x M, at right angles to M on the sky, to the minor axis.
Viewpoint faceOnView(const Outlook& outlook)
{
  const Vec3 major = outlook.majorAxis;
  const SeenAxes axes = seenAxes(outlook);
  const Vec3 across = cross({ 0, 0, 1 }, major);
  return nearView(outlook, axes.normal, normalized(major.y * major + across.y * axes.minor));
}

Viewpoint edgeOnView(const Outlook& outlook)
{
  const SeenAxes axes = seenAxes(outlook);
  return nearView(outlook, (axes.minor.z < 0 ? -1.0 : 1.0) * axes.minor, axes.normal);
}

Viewpoint majorAxisView(const Outlook& outlook)
{
  return nearView(outlook, outlook.majorAxis, seenAxes(outlook).normal);
}
} // namespace galaxy
