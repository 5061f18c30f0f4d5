#include "Readers/Formats/RegionOutline.h"

#include "Readers/Formats/Printable.h"
#include "Readers/Formats/RegionNumbers.h"

#include <cmath>

namespace galaxy
{
namespace
{
const double radian = std::acos(-1.0) / 180;

/// A point `east` and `north` of another, in degrees of the tangent plane there.
SkyPosition offsetPosition(const SkyPosition& from, double east, double north)
{
  const double xi = east * radian, eta = north * radian, dec = from.dec * radian;
  const double depth = std::cos(dec) - eta * std::sin(dec);
  return { from.ra + std::atan2(xi, depth) / radian,
    std::atan2(std::sin(dec) + eta * std::cos(dec), std::hypot(xi, depth)) / radian };
}

/// Turns statements into outlines.
class Outliner
{
public:
  Outliner(const RegionCanvas& canvas, const RegionFrame& frame)
    : canvas(canvas)
    , frame(frame)
  {
  }

  PixelRegion outline(const RegionShape& shape) const
  {
    const std::string& name = shape.name;
    const std::size_t count = shape.arguments.size();
    if (name == "circle" && count == 3)
    {
      return this->round(shape, 2, 2, 0);
    }
    if (name == "ellipse" && (count == 5 || count == 4))
    {
      // CASA gives the position angle of the first axis, DS9 the turn of it from the West.
      const double turn = count == 5 ? regionNumber(shape.arguments[4], false).value : 0;
      return this->round(shape, 2, 3, shape.casa ? turn + 90 : turn);
    }
    if ((name == "poly" || name == "polygon") && count >= 6 && count % 2 == 0)
    {
      return this->polygon(shape);
    }
    if (name == "box" && shape.casa && count == 4)
    {
      return this->cornerBox(shape);
    }
    if ((name == "box" || name == "centerbox" || name == "rotbox") && (count == 4 || count == 5))
    {
      return this->box(shape);
    }
    const bool known = name == "circle" || name == "ellipse" || name == "poly" ||
      name == "polygon" || name == "box" || name == "centerbox" || name == "rotbox";
    throw RegionFault(known
        ? name + " with " + std::to_string(count) + " numbers; give as many as DS9 or CASA write"
        : quoted(name) + " is not a shape; use circle, ellipse, box or polygon");
  }

private:
  struct Place
  {
    std::string x, y;
  };

  bool isSky() const { return this->frame.sky.has_value(); }

  /// The pixel `along` and `up` of a place, in the frame's own lengths: pixels, or degrees of which
  /// the first is to the West.
  PixelPosition pixel(const Place& place, double along, double up) const
  {
    if (!this->isSky())
    {
      PixelPosition at = { regionNumber(place.x, true).value + along,
        regionNumber(place.y, true).value + up };
      if (this->frame.physical)
      {
        at = { this->canvas.scale.x * at.x + this->canvas.shift.x,
          this->canvas.scale.y * at.y + this->canvas.shift.y };
      }
      return at;
    }
    if (this->canvas.coordinates == nullptr)
    {
      throw RegionFault(
        "sky coordinates need an image with celestial coordinates; use image pixels");
    }
    const SkyPosition own = { regionAngle(place.x, this->frame.colonsAreHours),
      regionAngle(place.y, false) };
    if (!(std::abs(own.dec) <= 90))
    {
      throw RegionFault(
        "the declination or latitude must be -90 to 90 degrees, not " + quoted(place.y));
    }
    PixelPosition at;
    if (!this->canvas.coordinates->skyToPixel(
          this->frame.sky->toIcrs(offsetPosition(own, -along, up)), at) ||
      !std::isfinite(at.x) || !std::isfinite(at.y))
    {
      // Behind the image's sky: nothing of it can be masked.
      return { -1e9, -1e9 };
    }
    return at;
  }

  /// A length in the frame's own unit: degrees, or pixels.
  double length(const std::string& text) const
  {
    const RegionNumber number = regionNumber(text, !this->isSky());
    const double value =
      number.value * (number.isPixels == this->isSky() ? this->lengthRatio() : 1);
    if (!(value >= 0))
    {
      throw RegionFault("a length must be at least 0, not " + quoted(text));
    }
    return value;
  }

  /// Frame lengths to a length given in the other kind: degrees a pixel, or pixels a degree.
  double lengthRatio() const
  {
    if (this->canvas.coordinates == nullptr)
    {
      throw RegionFault(
        "a length on the sky needs an image with celestial coordinates; use pixels");
    }
    SkyPosition here, there;
    this->canvas.coordinates->pixelToSky({ 1, 1 }, here);
    this->canvas.coordinates->pixelToSky({ 1, 2 }, there);
    const double degrees = std::hypot(there.dec - here.dec,
      std::remainder(there.ra - here.ra, 360.0) * std::cos(here.dec * radian));
    return this->isSky() ? degrees : 1 / degrees;
  }

  PixelRegion round(
    const RegionShape& shape, std::size_t first, std::size_t second, double turn) const
  {
    constexpr int count = 96;
    // The polygon of `count` corners with the area of the circle.
    const double step = 2 * std::acos(-1.0) / count;
    const double swell = std::sqrt(step / std::sin(step));
    const Place centre = { shape.arguments[0], shape.arguments[1] };
    const double a = swell * this->length(shape.arguments[first]);
    const double b = swell * this->length(shape.arguments[second]);
    PixelRegion region;
    region.middle = this->pixel(centre, 0, 0);
    for (int k = 0; k < count; ++k)
    {
      region.corners.push_back(
        this->turned(centre, a * std::cos(k * step), b * std::sin(k * step), turn));
    }
    return region;
  }

  PixelPosition turned(const Place& centre, double u, double v, double turn) const
  {
    const double c = std::cos(turn * radian), s = std::sin(turn * radian);
    return this->pixel(centre, c * u - s * v, s * u + c * v);
  }

  PixelRegion box(const RegionShape& shape) const
  {
    const std::vector<std::string>& given = shape.arguments;
    const double turn = given.size() == 5 ? regionNumber(given[4], false).value : 0;
    const Place centre = { given[0], given[1] };
    const double a = this->length(given[2]) / 2, b = this->length(given[3]) / 2;
    PixelRegion region;
    region.middle = this->pixel(centre, 0, 0);
    for (const auto& [u, v] : { std::pair(a, b), { -a, b }, { -a, -b }, { a, -b } })
    {
      region.corners.push_back(this->turned(centre, u, v, turn));
    }
    return region;
  }

  PixelRegion cornerBox(const RegionShape& shape) const
  {
    const std::vector<std::string>& given = shape.arguments;
    return this->through({ { given[0], given[1] }, { given[2], given[1] }, { given[2], given[3] },
      { given[0], given[3] } });
  }

  PixelRegion polygon(const RegionShape& shape) const
  {
    std::vector<Place> places;
    for (std::size_t i = 0; i < shape.arguments.size(); i += 2)
    {
      places.push_back({ shape.arguments[i], shape.arguments[i + 1] });
    }
    return this->through(places);
  }

  PixelRegion through(const std::vector<Place>& places) const
  {
    PixelRegion region;
    for (const Place& place : places)
    {
      region.corners.push_back(this->pixel(place, 0, 0));
      region.middle.x += region.corners.back().x / places.size();
      region.middle.y += region.corners.back().y / places.size();
    }
    return region;
  }

  const RegionCanvas& canvas;
  const RegionFrame& frame;
};
} // namespace

PixelRegion outlineRegion(
  const RegionShape& shape, const RegionFrame& frame, const RegionCanvas& canvas)
{
  return Outliner(canvas, frame).outline(shape);
}
} // namespace galaxy
