#include "Filters/Model/Viewpoints.h"

#include "Filters/Model/RingGeometry.h"
#include "Readers/Formats/BadPixels.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/SkyFrame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

namespace galaxy
{
namespace
{
constexpr double degree = 3.14159265358979323846 / 180;
constexpr double nearViewAngle = 30; // ParaView's own

/// Where a place of an image, from (0, 0) at its lower left corner to (1, 1), is seen in the plane
/// Z = 0; none where that is not before the observer.
using Place = std::function<std::optional<Vec3>(double u, double v)>;

Place placeOf(const Image& image, const ImageDescription& description, const SkyFrame& frame)
{
  const auto coordinates =
    std::make_shared<const WorldCoordinates>(coordinatesOf(image, description));
  const double width = image.width, height = image.height;
  return [=](double u, double v) -> std::optional<Vec3> {
    SkyPosition sky;
    double x = 0, y = 0;
    if (coordinates->pixelToSky({ 0.5 + u * width, 0.5 + v * height }, sky) &&
      frame.skyToPlane(sky, x, y) && std::isfinite(x) && std::isfinite(y))
    {
      return Vec3{ x, y, 0 };
    }
    return std::nullopt;
  };
}

/// To the farthest of the corners and the middles of the edges.
double halfSizeOf(const Place& place)
{
  double halfSize = 0;
  for (const double u : { 0.0, 0.5, 1.0 })
  {
    for (const double v : { 0.0, 0.5, 1.0 })
    {
      if (const std::optional<Vec3> p = place(u, v))
      {
        halfSize = std::max({ halfSize, std::abs(p->x), std::abs(p->y) });
      }
    }
  }
  return halfSize;
}

/// From the observer's place onto the middle of an image, up from the middle of its lower edge to
/// that of its upper one. A camera cannot mirror: an image whose East is to the right of its North
/// is seen as the sky is.
std::optional<Viewpoint> imageView(const Place& place, double distance)
{
  const auto lower = place(0.5, 0), middle = place(0.5, 0.5), upper = place(0.5, 1);
  if (!lower || !middle || !upper)
  {
    return std::nullopt;
  }
  const Vec3 eye{ 0, 0, distance };
  const Vec3 forward = normalized(*middle - eye);
  const Vec3 right = normalized(cross(forward, *upper - *lower));
  const Vec3 up = cross(right, forward);
  const auto tangent = [&](const Vec3& p) { return dot(p - eye, up) / dot(p - eye, forward); };
  const double halfHeight = 0.5 * (tangent(*upper) - tangent(*lower));
  return Viewpoint{ eye, *middle, up, 2 * std::atan(halfHeight) / degree };
}

std::vector<ImageField> fieldsOf(const Galaxy& galaxy)
{
  const double distance = galaxy.description.distance;
  const SkyFrame frame(galaxy.description.centre, distance);
  std::vector<ImageField> fields;
  for (std::size_t k = 0; k < galaxy.images.size(); ++k)
  {
    const ImageDescription& description = galaxy.description.images[k];
    if (galaxy.images[k].values.empty())
    {
      continue; // combined of others
    }
    try
    {
      const Place place = placeOf(galaxy.images[k], description, frame);
      if (const std::optional<Viewpoint> view = imageView(place, 1000 * distance))
      {
        fields.push_back({ description.name, halfSizeOf(place), *view });
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
