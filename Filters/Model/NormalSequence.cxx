#include "Filters/Model/NormalSequence.h"

#include "Filters/Model/NormalQuantile.h"
#include "Filters/Model/SameClones.h"

namespace galaxy
{
GALAXY_SAME_CLONES void toNormalDeviates(double* numbers, std::size_t count)
{
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k)
  {
    numbers[k] = normalQuantile(numbers[k]);
  }
}
} // namespace galaxy
