#include "Filters/Model/IntensityScale.h"

#include "Readers/Formats/Error.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// The value at a percentile, linear between the ranks; reorders the values, of which there is one.
double percentile(std::vector<float>& values, double percent)
{
  const double rank = percent / 100 * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::size_t>(rank);
  std::nth_element(values.begin(), below, values.end());
  const double part = rank - std::floor(rank);
  return part > 0 ? *below + part * (*std::min_element(below + 1, values.end()) - *below) : *below;
}

/// The finite values for which `pick` is true.
template <typename Pick>
std::vector<float> finiteValues(const std::vector<float>& values, Pick pick)
{
  std::vector<float> picked;
  std::copy_if(values.begin(), values.end(), std::back_inserter(picked),
    [pick](float value) { return std::isfinite(value) && pick(value); });
  return picked;
}
} // namespace

IntensityScale::IntensityScale(
  const LayerDescription& layer, const std::vector<float>& values, const std::string& file)
  : stretch(layer.stretch)
{
  if (layer.clips)
  {
    this->setClip(layer.clip[0], layer.clip[1], "clip", layer, file);
    return;
  }
  const bool byPercentile = layer.clipsByPercentile;
  std::vector<float> valid =
    finiteValues(values, [byPercentile](float value) { return byPercentile || value > 0; });
  if (valid.empty())
  {
    return;
  }
  if (byPercentile)
  {
    const double lowest = percentile(valid, layer.clipPercentile[0]);
    this->setClip(
      lowest, percentile(valid, layer.clipPercentile[1]), "clip_percentile", layer, file);
    return;
  }
  this->perUnit = 1 / percentile(valid, 99.9);
}

void IntensityScale::setClip(double lowest, double highest, const char* key,
  const LayerDescription& layer, const std::string& file)
{
  if (!(highest > lowest))
  {
    throw Error(
      file, layer.image, std::string(key) + ": the second value must be greater than the first");
  }
  this->low = lowest;
  this->perUnit = 1 / (highest - lowest);
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
    case IntensityStretch::Log:
      return std::log10(1 + 1000 * clamped) / std::log10(1001.0);
    case IntensityStretch::Linear:
      break;
  }
  return clamped;
}
} // namespace galaxy
