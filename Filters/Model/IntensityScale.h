#ifndef galaxy_IntensityScale_h
#define galaxy_IntensityScale_h

#include "Readers/Formats/GalaxyDescription.h"

#include <vector>

namespace galaxy
{
/// From the values of an image to intensities: t = (v - low)/(high - low) clamped to 0..1, then
/// t, sqrt(t), asinh(10 t)/asinh(10), log10(1 + 1000 t)/log10(1001) or, for photographic density,
/// (10^t - 1)/9.
class IntensityScale
{
public:
  /// Without a clip, `low` is 0 and `high` the 99.9th percentile of the positive values; an image
  /// without positive values is dark. A clip by percentiles is of the finite values, interpolated
  /// between their ranks. Throws Error(file, image name) where the clip is empty.
  IntensityScale(
    const LayerDescription& layer, const std::vector<float>& values, const std::string& file);

  /// 0 for NaN.
  double operator()(double value) const;

  /// The values that become intensity 0 and 1; equal where the image is dark.
  std::array<double, 2> clip() const
  {
    return { this->low, this->perUnit > 0 ? this->low + 1 / this->perUnit : this->low };
  }

private:
  void setClip(double lowest, double highest, const char* key, const LayerDescription& layer,
    const std::string& file);

  double low = 0;
  double perUnit = 0;
  IntensityStretch stretch;
};
} // namespace galaxy

#endif
