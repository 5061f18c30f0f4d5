#include "Filters/Splatting/TileSummary.h"

#include "Filters/Splatting/CubicSpline.h"
#include "Filters/Splatting/GaussianKernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace galaxy
{
namespace
{
/// The most of a splat's light, or optical depth, that a pixel can have.
float mostOfAPixel(const TileTask& task, const Splat& splat)
{
  const Kernel kernel = task.kernel;
  const float h = splat.h;
  if (splat.kind() == SplatKind::Near)
  {
    return nearMostOfAPixel(kernel, task.projection->lens().camera());
  }
  return kernel == Kernel::Gaussian ? gaussianMostOfAPixel(3 / h) : splineMostOfAPixel(h);
}
} // namespace

void SumsBySize::add(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  const int exponent = std::min<int>(bits >> 23 & 0xff, exponents - 1);
  this->sums[exponent] += x;
  ++this->counts[exponent];
  this->all += x;
}

SumsBySize::Smallest SumsBySize::smallest(double most) const
{
  Smallest all;
  int exponent = 0;
  for (; exponent < exponents && all.sum + this->sums[exponent] <= most; ++exponent)
  {
    all.sum += this->sums[exponent];
    all.count += this->counts[exponent];
  }
  if (all.sum > 0)
  {
    all.below = exponent < exponents ? std::ldexp(1.0F, exponent - 127)
                                     : std::numeric_limits<float>::infinity();
  }
  return all;
}

double OneSource::source(int channel) const
{
  return std::max(0.0, this->S[channel]);
}

void OneSource::add(const SlabLight& slab)
{
  for (int c = 0; c < 3 && this->isOne; ++c)
  {
    if (slab.t[c] > 0 && this->S[c] < 0)
    {
      this->S[c] = double(slab.e[c]) / slab.t[c];
    }
    // Products that were rounded to float.
    this->isOne = std::abs(slab.e[c] - this->source(c) * slab.t[c]) <= 5e-7 * slab.e[c];
  }
}

bool Omission::omits(const Splat& splat, const TileTask& task) const
{
  const SlabLight slab = task.projection->lightOf(splat);
  const float most = mostOfAPixel(task, splat);
  const bool isFaint = splat.kind() == SplatKind::Absorbs || mostOf(slab.e) * most < this->light;
  const bool isThin = splat.kind() == SplatKind::Emits || mostOf(slab.t) * most < this->tau;
  return isFaint && isThin;
}

TileSummary::TileSummary(const TileTask& task, bool sums)
  : splats(task.count)
{
  sums ? this->add<true>(task) : this->add<false>(task);
}

template <bool sums>
void TileSummary::add(const TileTask& task)
{
  for (std::size_t slot = 0; slot < task.count; ++slot)
  {
    const Splat& splat = task.splats[slot];
    const SlabLight slab = task.projection->lightOf(splat);
    const float most = mostOf(slab.e);
    this->brightest = std::max(this->brightest, most);
    if (this->source.holds())
    {
      this->source.add(slab);
    }
    if (sums)
    {
      this->light.add(most * mostOfAPixel(task, splat));
    }
    if (splat.kind() != SplatKind::Emits && mostOf(slab.t) > 0)
    {
      const bool isGrey = slab.t[0] == slab.t[1] && slab.t[1] == slab.t[2];
      this->absorption =
        std::max(this->absorption, isGrey ? TileAbsorption::Grey : TileAbsorption::Color);
      const float depth = mostOf(slab.t) * mostOfAPixel(task, splat);
      this->thickest = std::max(this->thickest, depth);
      if (sums)
      {
        this->tau.add(depth);
      }
    }
  }
}

Omission TileSummary::omission(const ErrorBound& allowed) const
{
  Omission omission;
  if (allowed.light <= 0 && allowed.share <= 0)
  {
    return omission;
  }
  // Dimmed by e^-tau too little, light is too much by the share e^tau - 1.
  const double mostTau = std::log1p(allowed.share / 2) / 2;
  SumsBySize::Smallest faint = this->light.smallest(allowed.light / 2);
  SumsBySize::Smallest thin = this->tau.smallest(mostTau);
  // To find a few takes longer than to draw them.
  if (faint.count + thin.count < this->splats / 8)
  {
    faint = thin = {};
  }
  omission.light = faint.below;
  omission.bound.light = faint.sum;
  omission.tau = thin.below;
  const double rest = this->tau.total() - thin.sum;
  omission.isOrdered = rest > mostTau;
  omission.bound.share = std::expm1(thin.sum + (omission.isOrdered ? 0 : rest));
  if (rest > 0)
  {
    // Where drawing may end behind dust.
    omission.bound.light += allowed.light / 2;
    omission.bound.share += allowed.share / 2;
  }
  return omission;
}
} // namespace galaxy
