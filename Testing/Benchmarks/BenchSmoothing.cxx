// Seconds to set the smoothing lengths of an exponential disc, inclined, its particles in random
// order: the least of five runs.
// Use: galaxy_bench_smoothing [N ...], by default 1 million and 22 million particles. The model
// Neighbours is left out above 2 million.
#include "Filters/Model/Random.h"
#include "Filters/Model/SmoothingLength.h"

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{
using namespace galaxy;

/// Scale length 2.5 kpc, rms height 0.3 kpc, inclined by 37 degrees.
std::vector<float> exponentialDisk(std::size_t count)
{
  std::vector<float> position(3 * count);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < count; ++i)
  {
    Random random({}, RandomStream::SpheroidPlace, i);
    const double r = -2.5 * std::log(random.uniform() * random.uniform());
    const double theta = 6.283185307179586 * random.uniform();
    const double y = r * std::sin(theta);
    const double z = 0.3 * random.normal();
    position[3 * i] = static_cast<float>(r * std::cos(theta));
    position[3 * i + 1] = static_cast<float>(0.8 * y - 0.6 * z);
    position[3 * i + 2] = static_cast<float>(0.6 * y + 0.8 * z);
  }
  return position;
}

void measure(const char* name, SmoothingModel model, const std::vector<float>& position, int runs)
{
  SmoothingDescription smoothing;
  smoothing.model = model;
  std::setbuf(stdout, nullptr);
  std::vector<float> h(position.size() / 3);
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs; ++run)
  {
    const double start = omp_get_wtime();
    smoothingLengths(position.data(), nullptr, h.size(), smoothing, h.data());
    least = std::min(least, omp_get_wtime() - start);
  }
  std::printf(
    "%-10s %9zu particles, %d threads: %.3f s\n", name, h.size(), omp_get_max_threads(), least);
}
} // namespace

int main(int argc, char** argv)
{
  std::vector<std::size_t> counts = { 1000000, 22000000 };
  if (argc > 1)
  {
    counts.clear();
    for (int k = 1; k < argc; ++k)
    {
      counts.push_back(static_cast<std::size_t>(std::atof(argv[k])));
    }
  }
  for (const std::size_t count : counts)
  {
    const std::vector<float> position = exponentialDisk(count);
    for (const int threads : { 1, 2 })
    {
      omp_set_num_threads(threads);
      measure("Density", SmoothingModel::Density, position, 5);
      if (count <= 2000000)
      {
        measure("Neighbours", SmoothingModel::Neighbours, position, 1);
      }
    }
  }
}
