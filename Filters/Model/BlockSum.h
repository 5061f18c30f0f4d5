#ifndef galaxy_BlockSum_h
#define galaxy_BlockSum_h

#include <algorithm>
#include <cstddef>
#include <vector>

namespace galaxy
{
/// The sum of values[first] to values[last - 1] in double precision, by blocks of fixed size, so
/// that it is the same for any number of threads.
template <typename Values>
double blockSum(const Values& values, std::size_t first, std::size_t last)
{
  constexpr std::size_t block = 65536;
  std::vector<double> sums((last - first + block - 1) / block);
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < sums.size(); ++k)
  {
    const std::size_t start = first + k * block, end = std::min(last, start + block);
    double sum = 0;
    for (std::size_t i = start; i < end; ++i)
    {
      sum += values[i];
    }
    sums[k] = sum;
  }
  double sum = 0;
  for (const double part : sums)
  {
    sum += part;
  }
  return sum;
}
} // namespace galaxy

#endif
