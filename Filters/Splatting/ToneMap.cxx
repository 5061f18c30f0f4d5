#include "Filters/Splatting/ToneMap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// NaN and negative light show as black.
double positive(double x)
{
  return x > 0 ? x : 0;
}

/// The softening of Lupton et al. (2004), equation 1 with their Q and alpha in one: linear for
/// faint light, logarithmic for bright, 1 at 1.
double stretched(double x, double Q)
{
  return Q > 0 ? std::asinh(Q * x) / std::asinh(Q) : x;
}
/// How a channel comes to the stretch: (x exposure - black)/(white - black) as gain x - offset.
struct Levels
{
  double gain;
  double offset;

  Levels(const ToneMap& map, int channel)
  {
    const double range = std::max(map.white[channel] - map.black[channel], 1e-300);
    this->gain = map.exposure / range;
    this->offset = map.black[channel] / range;
  }
  double operator()(double x) const { return positive(this->gain * x - this->offset); }
};
} // namespace

ErrorBound allowedError(const ToneMap& map, double tolerance)
{
  const double half = tolerance / 2;
  // x^(1/gamma) with gamma > 1 is concave: its steepest rise is from 0.
  const double value = map.gamma > 1 ? std::pow(half, map.gamma) : half * map.gamma;
  double gain = 1e-300, offset = 0;
  for (int c = 0; c < 3; ++c)
  {
    const Levels levels(map, c);
    gain = std::max(gain, levels.gain);
    offset = std::max(offset, levels.offset);
  }
  // Before gamma, a channel is its light l times S(m)/m, m the mean of the three, and divided by
  // the brightest if that is above 1. With all three off by d, and since S is concave and l <= 3 m,
  // it changes by no more than S'(0) d + 3 (S/m - S') d <= 4 S'(0) d; by no more than 2 r of itself
  // if they are off by a share r. Dividing makes it twice that.
  const double slope = map.stretch > 0 ? map.stretch / std::asinh(map.stretch) : 1;
  const double step = value / (8 * slope);
  const double share = half * std::min(1.0, map.gamma) / 4;
  if (offset == 0)
  {
    return { step / gain, share };
  }
  // With l = gain x - offset, a share r of x is r l + r offset: the part that does not shrink with
  // l is an error like d, and each of the two has half of the step.
  return { step / (2 * gain), std::min(share, step / (2 * offset)) };
}

void applyToneMap(const ToneMap& map, const float* radiance, float* display, std::size_t count)
{
  const std::ptrdiff_t pixels = static_cast<std::ptrdiff_t>(count);
  const double largest = std::numeric_limits<float>::max();
  const Levels levels[3] = { { map, 0 }, { map, 1 }, { map, 2 } };
#pragma omp parallel for if (pixels > 1000)
  for (std::ptrdiff_t i = 0; i < pixels; ++i)
  {
    double light[3];
    for (int c = 0; c < 3; ++c)
    {
      light[c] = std::min(levels[c](radiance[3 * i + c]), largest);
    }
    const double mean = (light[0] + light[1] + light[2]) / 3;
    const double gain = mean > 0 ? stretched(mean, map.stretch) / mean : 0;
    // Clipping the three channels one by one would turn bright colours white: scale them together.
    const double brightest = gain * std::max({ light[0], light[1], light[2] });
    const double fit = gain / std::max(1.0, brightest);
    for (int c = 0; c < 3; ++c)
    {
      const double value = std::min(1.0, light[c] * fit);
      display[3 * i + c] = static_cast<float>(std::pow(value, 1 / map.gamma));
    }
  }
}
} // namespace galaxy
