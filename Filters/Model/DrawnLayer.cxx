#include "Filters/Model/DrawnLayer.h"

#include "Filters/Model/ThicknessProfile.h"
#include "Filters/Model/VerticalLaw.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
/// Of the model's variance, what kernels may have of it.
constexpr double mostByKernels = 0.75;
/// Particles that means over a range of radii are taken of, at most.
constexpr std::size_t mostCounted = 1 << 18;
} // namespace

VerticalLayer layerOf(const ComponentDescription& component, const TiltedDisk& disk)
{
  if (component.hasDust)
  {
    return { LayerLaw::Gaussian, [height = component.dust.scaleHeight](double) { return height; } };
  }
  const ThicknessProfile profile(component.thickness, disk);
  return { profile.law(), [profile](double r) { return profile.scaleHeight(r); } };
}

DrawnLayer::DrawnLayer(
  const TiltedDisk& disk, const ComponentDescription& component, double inner, double outer)
  : law(layerOf(component, disk))
  , inner(inner)
  , outer(outer)
  , size(component.size)
  , knots(disk.knotsBetween(0, 1.5 * outer))
  , rowsBetween(std::max<std::size_t>(32, 1024 / this->knots.size()))
  , follows(component.smoothing.model == SmoothingModel::Density ||
      component.smoothing.model == SmoothingModel::Neighbours)
  // n neighbours in a sheet are n^(1/6) of its particles' distance d apart, h = factor d.
  , leastShare(std::min(
      1.0, 1.5 / (component.smoothing.factor * std::pow(component.smoothing.neighbours, 1.0 / 6))))
  , minimum(static_cast<float>(component.smoothing.minimum))
{
  this->left.fill(1);
  const double rms = rmsHeight(this->law.law);
  for (std::size_t k = 0; k + 1 < this->knots.size(); ++k)
  {
    const double start = this->knots[k], end = this->knots[k + 1];
    for (std::size_t row = 0; row <= this->rowsBetween; ++row)
    {
      const double part = static_cast<double>(row) / static_cast<double>(this->rowsBetween);
      const double r =
        row < this->rowsBetween ? start + part * (end - start) : std::nextafter(end, start);
      const double height = rms * this->law.scaleHeight(r);
      this->rows.push_back({ disk.frame(r).n, height * height });
    }
  }
}

DrawnLayer::Row DrawnLayer::rowAt(double r, std::size_t& near) const
{
  const std::size_t last = this->knots.size() - 2;
  while (near < last && r >= this->knots[near + 1])
  {
    ++near;
  }
  while (near > 0 && r < this->knots[near])
  {
    --near;
  }
  const double width = this->knots[near + 1] - this->knots[near];
  const double most = static_cast<double>(this->rowsBetween);
  const double at = std::clamp((r - this->knots[near]) / width, 0.0, 1.0) * most;
  const auto row = static_cast<std::size_t>(std::min(at, most - 1));
  const double t = at - static_cast<double>(row);
  const Row* between = &this->rows[near * (this->rowsBetween + 1) + row];
  return { (1 - t) * between[0].normal + t * between[1].normal,
    (1 - t) * between[0].variance + t * between[1].variance };
}

DrawnLayer::Place DrawnLayer::placeOf(const float* position, std::size_t& near) const
{
  constexpr int mostSteps = 12;
  const Vec3 p = { position[0], position[1], position[2] };
  const double square = dot(p, p);
  Place place;
  place.r = std::sqrt(square);
  for (int step = 0; step < mostSteps; ++step)
  {
    const double before = place.r;
    const Row row = this->rowAt(place.r, near);
    place.normal = row.normal;
    place.variance = row.variance;
    place.z = dot(p, place.normal);
    place.r = std::sqrt(std::max(0.0, square - place.z * place.z));
    if (std::abs(place.r - before) <= 1e-4 * before)
    {
      break;
    }
  }
  return place;
}

float DrawnLayer::lowered(float h, double variance) const
{
  if (!this->follows || !(variance > 0) || !(this->size > 0))
  {
    return h;
  }
  const auto most = static_cast<float>(std::sqrt(18 * mostByKernels * variance) / this->size);
  return std::min(h, std::max({ most, this->minimum, static_cast<float>(this->leastShare * h) }));
}

int DrawnLayer::binOf(double r) const
{
  const double part = (r - this->inner) / (this->outer - this->inner);
  return static_cast<int>(std::clamp(bins * part, 0.0, bins - 1.0));
}

/// Of every so many-th particle, by blocks of fixed size, so that it is the same for any number of
/// threads.
template <class Count>
DrawnLayer::Sums DrawnLayer::summed(std::size_t first, std::size_t last, const Count& count) const
{
  constexpr std::size_t block = 4096;
  const std::size_t stride = (last - first) / mostCounted * 2 + 1;
  const std::size_t counted = (last - first + stride - 1) / stride;
  std::vector<Sums> parts((counted + block - 1) / block, Sums{});
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    std::size_t near = 0;
    for (std::size_t j = k * block; j < std::min(counted, (k + 1) * block); ++j)
    {
      count(first + j * stride, near, parts[k]);
    }
  }
  Sums all{};
  for (const Sums& part : parts)
  {
    for (int bin = 0; bin < bins; ++bin)
    {
      std::transform(
        all[bin].begin(), all[bin].end(), part[bin].begin(), all[bin].begin(), std::plus<double>());
    }
  }
  return all;
}

double DrawnLayer::shareLeft(float h, double variance) const
{
  const double byKernel = variance > 0 ? this->kernelVariance(h) / variance : 0;
  return std::sqrt(1 - std::min(byKernel, mostByKernels));
}

void DrawnLayer::settle(Particles& particles, std::size_t first, std::size_t last)
{
  const Buffer<float>& position = particles.position;
  Buffer<float>& lengths = particles.smoothingLength;
  // High above the plane kernels are larger, and shrink the tails: what the layer then lacks.
  const Sums sums = this->summed(first, last, [&](std::size_t i, std::size_t& near, Sums& sum) {
    const Place place = this->placeOf(&position[3 * i], near);
    const float h = this->lowered(lengths[i], place.variance);
    const double z = this->shareLeft(h, place.variance) * place.z;
    std::array<double, 4>& mine = sum[this->binOf(place.r)];
    mine[0] += z * z;
    mine[1] += place.z * place.z;
    mine[2] += this->kernelVariance(h);
    mine[3] += place.variance;
  });
  std::array<double, bins> correction;
  for (int bin = 0; bin < bins; ++bin)
  {
    const auto [shrunk, whole, kernels, model] = sums[bin];
    const double wanted = model > 0 ? whole * (1 - kernels / model) : 0;
    correction[bin] = shrunk > 0 ? std::sqrt(std::clamp(wanted / shrunk, 0.25, 1.5)) : 1;
    this->left[bin] = whole > 0 ? std::min(1.0, correction[bin] * std::sqrt(shrunk / whole)) : 1;
  }
  constexpr std::size_t block = 4096;
#pragma omp parallel for schedule(static)
  for (std::size_t start = first; start < last; start += block)
  {
    std::size_t near = 0;
    for (std::size_t i = start; i < std::min(last, start + block); ++i)
    {
      float* p = &particles.position[3 * i];
      const Place place = this->placeOf(p, near);
      lengths[i] = this->lowered(lengths[i], place.variance);
      const double share = std::min(
        1.0, correction[this->binOf(place.r)] * this->shareLeft(lengths[i], place.variance));
      const Vec3 down = (share - 1) * place.z * place.normal;
      p[0] = static_cast<float>(p[0] + down.x);
      p[1] = static_cast<float>(p[1] + down.y);
      p[2] = static_cast<float>(p[2] + down.z);
    }
  }
}

void DrawnLayer::lower(Particles& particles, std::size_t first, std::size_t last) const
{
#pragma omp parallel for schedule(static)
  for (std::size_t i = first; i < last; ++i)
  {
    std::size_t near = 0;
    float& h = particles.smoothingLength[i];
    h = this->lowered(h, this->placeOf(&particles.position[3 * i], near).variance);
  }
}

VerticalLayer DrawnLayer::layer() const
{
  return { this->law.law,
    [this](double r) { return this->left[this->binOf(r)] * this->law.scaleHeight(r); } };
}

std::vector<LayerHeight> DrawnLayer::heights(
  const Particles& particles, std::size_t first, std::size_t last) const
{
  const Sums sums = this->summed(first, last, [&](std::size_t i, std::size_t& near, Sums& sum) {
    const Place place = this->placeOf(&particles.position[3 * i], near);
    const double light = particles.intensity[i];
    std::array<double, 4>& mine = sum[this->binOf(place.r)];
    mine[0] += light;
    mine[1] += light * place.r;
    mine[2] += light * (place.z * place.z + this->kernelVariance(particles.smoothingLength[i]));
    mine[3] += light * place.variance;
  });
  std::vector<LayerHeight> found;
  for (const std::array<double, 4>& sum : sums)
  {
    if (sum[0] > 0)
    {
      found.push_back({ sum[1] / sum[0], std::sqrt(sum[2] / sum[0]), std::sqrt(sum[3] / sum[0]) });
    }
  }
  return found;
}
} // namespace galaxy
