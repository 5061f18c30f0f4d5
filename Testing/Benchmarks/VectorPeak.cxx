#include "VectorPeak.h"

#include <algorithm>
#include <omp.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "VectorPeak.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// So many rounds of ten multiply-adds; their sum, so that none can be left out.
float multiplyAdd(long rounds)
{
  const hn::CappedTag<float, 8> d;
  using V = hn::Vec<decltype(d)>;
  constexpr int chains = 10;
  V sums[chains];
  for (int k = 0; k < chains; ++k)
  {
    sums[k] = hn::Set(d, 1.0F + 0.1F * static_cast<float>(k));
  }
  const V factor = hn::Set(d, 0.999F), more = hn::Set(d, 0.001F);
  for (long round = 0; round < rounds; ++round)
  {
    for (V& sum : sums)
    {
      sum = hn::MulAdd(sum, factor, more);
    }
  }
  V all = sums[0];
  for (int k = 1; k < chains; ++k)
  {
    all = hn::Add(all, sums[k]);
  }
  return hn::GetLane(hn::SumOfLanes(d, all));
}

double flopsOf(long rounds)
{
  return 20.0 * static_cast<double>(hn::Lanes(hn::CappedTag<float, 8>())) *
    static_cast<double>(rounds);
}
} // namespace HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
HWY_EXPORT(multiplyAdd);
HWY_EXPORT(flopsOf);

double vectorPeak()
{
  constexpr long rounds = 20000000;
  double best = 0;
  for (int k = 0; k < 4; ++k)
  {
    float sum = 0;
    const double start = omp_get_wtime();
#pragma omp parallel reduction(+ : sum)
    sum += HWY_DYNAMIC_DISPATCH(multiplyAdd)(rounds);
    const double seconds = omp_get_wtime() - start;
    const double flops = HWY_DYNAMIC_DISPATCH(flopsOf)(rounds) * omp_get_max_threads();
    best = std::max(best, sum > 0 ? flops / seconds : 0);
  }
  return best;
}
#endif
