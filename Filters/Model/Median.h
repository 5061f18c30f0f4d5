#ifndef galaxy_Median_h
#define galaxy_Median_h

#include <algorithm>
#include <vector>

namespace galaxy
{
/// The median of values of which there is at least one; reorders them.
template <typename T>
T median(std::vector<T>& values)
{
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 != 0)
  {
    return *middle;
  }
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}
} // namespace galaxy

#endif
