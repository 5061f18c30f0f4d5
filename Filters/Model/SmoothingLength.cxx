#include "Filters/Model/SmoothingLength.h"

#include "Filters/Model/DensityGrid.h"
#include "Filters/Model/NearestNeighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace galaxy
{
namespace
{
constexpr double leastLength = 1e-9;

/// Light relative to the brightest particle.
double lightOf(float intensity, float brightest)
{
  return std::isfinite(intensity) && intensity > 0 ? double(intensity) / brightest : 0;
}

/// sum(I)/sum(I^(1+p)) of light relative to the brightest, the same for any number of threads.
double perLight(const float* intensity, std::size_t count, float brightest, double p)
{
  constexpr std::size_t block = 1 << 16;
  std::vector<std::array<double, 2>> sums((count + block - 1) / block);
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < sums.size(); ++b)
  {
    for (std::size_t i = b * block; i < std::min(count, (b + 1) * block); ++i)
    {
      const double I = lightOf(intensity[i], brightest);
      sums[b][0] += I;
      sums[b][1] += I * std::pow(I, p);
    }
  }
  std::array<double, 2> all{};
  for (const std::array<double, 2>& sum : sums)
  {
    all[0] += sum[0];
    all[1] += sum[1];
  }
  return all[0] / all[1];
}

void lengthsByLight(
  const float* intensity, std::size_t count, const SmoothingDescription& smoothing, float* h)
{
  float brightest = 0;
#pragma omp parallel for schedule(static) reduction(max : brightest)
  for (std::size_t i = 0; i < count; ++i)
  {
    brightest = std::isfinite(intensity[i]) ? std::max(brightest, intensity[i]) : brightest;
  }
  const double p = brightest > 0 ? smoothing.exponent : 0;
  const double length =
    smoothing.length * (brightest > 0 ? perLight(intensity, count, brightest, p) : 1);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count; ++i)
  {
    h[i] = static_cast<float>(length * std::pow(lightOf(intensity[i], brightest), p));
  }
}
/// From d, or h itself where the factor is 1.
void keepInRange(double factor, const SmoothingDescription& smoothing, std::size_t count, float* h)
{
  const auto least = static_cast<float>(std::max(smoothing.minimum, leastLength));
  const auto most = std::max(least,
    static_cast<float>(std::min(smoothing.maximum, double(std::numeric_limits<float>::max()))));
#pragma omp parallel for simd schedule(static)
  for (std::size_t i = 0; i < count; ++i)
  {
    h[i] = std::min(std::max(static_cast<float>(factor * h[i]), least), most);
  }
}
} // namespace

void smoothingLengths(const float* position, const float* intensity, std::size_t count,
  const SmoothingDescription& smoothing, float* h, const Progress& progress)
{
  requireInRange(smoothing, "particles", "");
  double factor = 1;
  switch (smoothing.model)
  {
    case SmoothingModel::Density:
      factor = smoothing.factor;
      DensityGrid(position, count, smoothing.neighbours)
        .meanDistances(position, count, h, progress);
      break;
    case SmoothingModel::Neighbours:
      factor = smoothing.factor;
      neighbourDistances(position, count, smoothing.neighbours, h, progress);
      break;
    case SmoothingModel::Constant:
      std::fill_n(h, count, static_cast<float>(smoothing.length));
      break;
    case SmoothingModel::Brightness:
      lengthsByLight(intensity, count, smoothing, h);
      break;
  }
  keepInRange(factor, smoothing, count, h);
}

void setSmoothingLengths(Particles& particles, std::size_t first, std::size_t last,
  const SmoothingDescription& smoothing, const Progress& progress)
{
  smoothingLengths(particles.position.data() + 3 * first, particles.intensity.data() + first,
    last - first, smoothing, particles.smoothingLength.data() + first, progress);
}

void smoothAmongOthers(Particles& particles, std::size_t first, std::size_t placed,
  const SmoothingDescription& smoothing)
{
  const std::size_t last = particles.size();
  if (smoothing.model == SmoothingModel::Density || smoothing.model == SmoothingModel::Neighbours)
  {
    float* h = particles.smoothingLength.data() + placed;
    const float* position = particles.position.data();
    if (placed < last)
    {
      DensityGrid(position + 3 * first, last - first, smoothing.neighbours)
        .meanDistances(position + 3 * placed, last - placed, h);
      keepInRange(smoothing.factor, smoothing, last - placed, h);
    }
    return;
  }
  setSmoothingLengths(particles, first, last, smoothing);
}
} // namespace galaxy
