#include "Filters/Model/IntensityScale.h"

#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// The value that a share of 0.999 of the positive ones does not exceed; 0 where there is none.
double highPercentile(const std::vector<float>& values)
{
  std::vector<float> positive;
  std::copy_if(values.begin(), values.end(), std::back_inserter(positive),
    [](float value) { return value > 0 && std::isfinite(value); });
  if (positive.empty())
  {
    return 0;
  }
  const auto rank = static_cast<std::size_t>(0.999 * (positive.size() - 1));
  std::nth_element(positive.begin(), positive.begin() + rank, positive.end());
  return positive[rank];
}
} // namespace

IntensityScale::IntensityScale(
  const LayerDescription& layer, const std::vector<float>& values, const std::string& file)
  : stretch(layer.stretch)
{
  if (!layer.clips)
  {
    const double high = highPercentile(values);
    this->perUnit = high > 0 ? 1 / high : 0;
    return;
  }
  if (!(layer.clip[1] > layer.clip[0]))
  {
    throw Error(file, layer.image, "clip needs its second value above its first");
  }
  this->low = layer.clip[0];
  this->perUnit = 1 / (layer.clip[1] - layer.clip[0]);
}

double IntensityScale::operator()(double value) const
{
  const double t = (value - this->low) * this->perUnit;
  if (!(t > 0))
  {
    return 0;
  }
  const double clamped = std::min(t, 1.0);
  switch (this->stretch)
  {
    case IntensityStretch::Sqrt:
      return std::sqrt(clamped);
    case IntensityStretch::Asinh:
      return std::asinh(10 * clamped) / std::asinh(10.0);
    case IntensityStretch::Density:
      return (std::pow(10.0, clamped) - 1) / 9;
    case IntensityStretch::Linear:
      break;
  }
  return clamped;
}
} // namespace galaxy
