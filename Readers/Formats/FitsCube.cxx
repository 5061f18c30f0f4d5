#include "Readers/Formats/FitsCube.h"

#include "Readers/Formats/Error.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/SpectralAxis.h"

#include <algorithm>
#include <limits>

namespace galaxy
{
namespace
{
/// The part of a CTYPE that names the celestial system, with `?` for longitude or latitude.
struct CelestialType
{
  std::string system;
  bool longitude = false;
};

CelestialType celestialType(const FitsHdu& hdu, std::size_t axis)
{
  std::string type = hdu.header.text(fitsKeyword("CTYPE", axis + 1)).value_or("");
  type = upperCase(type.substr(0, type.find_first_of("- ")));
  if (type == "RA" || type == "DEC")
  {
    return { "equatorial", type == "RA" };
  }
  const std::string end = type.size() == 4 ? type.substr(1) : "";
  if (end == "LON" || end == "LAT")
  {
    return { type.substr(0, 1), end == "LON" };
  }
  const std::string shortEnd = type.size() == 4 ? type.substr(2) : "";
  if (shortEnd == "LN" || shortEnd == "LT")
  {
    return { type.substr(0, 2), shortEnd == "LN" };
  }
  return {};
}

/// The planes of a cube: all axes but the image's, the lowest-numbered fastest.
class Planes
{
public:
  Planes(const FitsHdu& hdu, const std::array<int, 2>& image)
    : axes(hdu.axes)
  {
    for (std::size_t axis = 0; axis < this->axes.size(); ++axis)
    {
      const int number = static_cast<int>(axis) + 1;
      if (number != image[0] && number != image[1])
      {
        this->others.push_back(axis);
        this->count *= this->axes[axis];
      }
    }
  }

  /// The slab of plane `index` alone.
  FitsSlab slab(long long index) const
  {
    FitsSlab slab;
    slab.first.assign(this->axes.size(), 1);
    slab.last.assign(this->axes.begin(), this->axes.end());
    for (const std::size_t axis : this->others)
    {
      slab.first[axis] = slab.last[axis] = 1 + static_cast<long>(index % this->axes[axis]);
      index /= this->axes[axis];
    }
    slab.summedAxis = this->fastest();
    slab.weights = { 1 };
    return slab;
  }

  /// Slabs that hold the planes first to last, each as long as its fastest axis allows.
  std::vector<FitsSlab> slabs(long long first, long long last) const
  {
    std::vector<FitsSlab> slabs;
    while (first <= last)
    {
      FitsSlab slab = this->slab(first);
      const std::size_t axis = slab.summedAxis;
      const long long run = this->others.empty()
        ? 1
        : std::min<long long>(last - first + 1, this->axes[axis] - slab.first[axis] + 1);
      slab.last[axis] += static_cast<long>(this->others.empty() ? 0 : run - 1);
      slab.weights.assign(static_cast<std::size_t>(run), 1);
      slabs.push_back(std::move(slab));
      first += run;
    }
    return slabs;
  }

  void require(const std::string& file, long long index) const
  {
    if (index < 0 || index >= this->count)
    {
      throw Error(file, "plane " + std::to_string(index),
        "out of range, the image has " + std::to_string(this->count) +
          (this->count == 1 ? " plane" : " planes") + "; choose from 0 to " +
          std::to_string(this->count - 1));
    }
  }

private:
  /// The first further axis of any length.
  std::size_t fastest() const
  {
    const auto found = std::find_if(this->others.begin(), this->others.end(),
      [this](std::size_t axis) { return this->axes[axis] > 1; });
    return found != this->others.end() ? *found : this->others.empty() ? 0 : this->others[0];
  }

  const std::vector<long long> axes;
  std::vector<std::size_t> others;
  long long count = 1;
};

/// The channels whose centres lie in the range, each weighted by its width.
FitsSlab channelsOf(
  const std::string& file, const SpectralAxis& axis, std::array<double, 2> range, FitsSlab slab)
{
  std::sort(range.begin(), range.end());
  const long channels = axis.channels();
  const auto inside = [&](long channel) {
    const double v = axis.velocity(static_cast<double>(channel));
    return v >= range[0] && v <= range[1];
  };
  long first = 1;
  while (first <= channels && !inside(first))
  {
    ++first;
  }
  long last = first;
  while (last < channels && inside(last + 1))
  {
    ++last;
  }
  if (first > channels)
  {
    throw Error(file, "velocity range",
      "no channel lies in it; choose from " + std::to_string(axis.velocity(1)) + " to " +
        std::to_string(axis.velocity(static_cast<double>(channels))) + " km/s");
  }
  slab.summedAxis = axis.index();
  slab.first[slab.summedAxis] = first;
  slab.last[slab.summedAxis] = last;
  slab.weights.clear();
  for (long channel = first; channel <= last; ++channel)
  {
    slab.weights.push_back(axis.width(static_cast<double>(channel)));
  }
  return slab;
}
} // namespace

std::array<int, 2> imagePlane(const FitsHdu& hdu)
{
  for (std::size_t i = 0; i < hdu.axes.size(); ++i)
  {
    const CelestialType a = celestialType(hdu, i);
    for (std::size_t j = i + 1; j < hdu.axes.size() && !a.system.empty(); ++j)
    {
      const CelestialType b = celestialType(hdu, j);
      if (a.system == b.system && a.longitude != b.longitude)
      {
        return { static_cast<int>(i) + 1, static_cast<int>(j) + 1 };
      }
    }
  }
  return { 1, 2 };
}

FitsPlan planOf(const std::string& file, const FitsHdu& hdu, const FitsSelection& selection)
{
  FitsPlan plan;
  plan.axes = imagePlane(hdu);
  const Planes planes(hdu, plan.axes);
  if (selection.planes && selection.velocityRange)
  {
    throw Error(file, "planes", "contradicts the velocity range; give one or the other");
  }
  if (selection.planes)
  {
    const auto [first, last] = *selection.planes;
    planes.require(file, first);
    planes.require(file, last);
    if (first > last)
    {
      throw Error(file, "planes", "the first must not be after the last");
    }
    plan.slabs = planes.slabs(first, last);
    plan.isMean = first < last;
    return plan;
  }
  planes.require(file, selection.plane);
  plan.slabs = { planes.slab(selection.plane) };
  if (selection.velocityRange)
  {
    const SpectralAxis axis(file, hdu, plan.axes);
    plan.slabs[0] = channelsOf(file, axis, *selection.velocityRange, plan.slabs[0]);
    plan.unitSuffix = "km/s";
  }
  return plan;
}
} // namespace galaxy
