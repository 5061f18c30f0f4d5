#include "Filters/Model/NearestNeighbours.h"

#include "Filters/Model/ParallelFor.h"
#include "Filters/Model/WorkProgress.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace galaxy
{
namespace
{
/// The particles with a finite position, as nanoflann sees them.
struct Cloud
{
  const float* position;
  std::vector<std::size_t> particles;

  std::size_t kdtree_get_point_count() const { return this->particles.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return this->position[3 * this->particles[i] + axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

using Metric = nanoflann::L2_Simple_Adaptor<float, Cloud, double>;
/// The k + 1 nearest; the search ends where they share one place, however many more are there.
class Nearest : public nanoflann::KNNResultSet<double, std::size_t>
{
public:
  using KNNResultSet::KNNResultSet;
  double worstDist() const
  {
    const double square = this->KNNResultSet::worstDist();
    return square > 0 ? square : -1;
  }
};
using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, 3, std::size_t>;
} // namespace

void neighbourDistances(
  const float* position, std::size_t count, int k, float* d, const Progress& progress)
{
  constexpr double ball = 4 * 3.14159265358979323846 / 3;
  Cloud cloud{ position, {} };
  cloud.particles.reserve(count);
  std::fill_n(d, count, 0.0f);
  for (std::size_t i = 0; i < count; ++i)
  {
    const float* p = position + 3 * i;
    if (std::isfinite(double(p[0]) + p[1] + p[2]))
    {
      cloud.particles.push_back(i);
    }
  }
  const std::size_t others =
    std::min<std::size_t>(k, std::max<std::size_t>(1, cloud.particles.size()) - 1);
  if (others == 0)
  {
    return;
  }
  constexpr double treeShare = 0.2; // of the time, about
  WorkProgress work(progress);
  work.begin(treeShare, 1);
  const Tree tree(3, cloud, { 16 });
  work.begin(1 - treeShare, cloud.particles.size());
  constexpr std::size_t atOnce = 1024;
  const std::size_t blocks = (cloud.particles.size() + atOnce - 1) / atOnce;
  parallelForDynamic<std::size_t>(0, blocks, 1, [&](std::size_t block) {
    std::vector<std::size_t> nearest(others + 1); // the particle itself is the first
    std::vector<double> square(others + 1);
    const std::size_t last = std::min((block + 1) * atOnce, cloud.particles.size());
    for (std::size_t i = block * atOnce; i < last && work.advance(1); ++i)
    {
      const std::size_t particle = cloud.particles[i];
      Nearest found(others + 1);
      found.init(nearest.data(), square.data());
      tree.findNeighbors(found, position + 3 * particle, {});
      d[particle] = static_cast<float>(std::sqrt(square[others]) * std::cbrt(ball / others));
    }
  });
  if (work.isAborted())
  {
    throw Aborted("particles", "", "their smoothing lengths were given up");
  }
}
} // namespace galaxy
