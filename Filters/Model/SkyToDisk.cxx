#include "Filters/Model/SkyToDisk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace galaxy
{
namespace
{
/// Steps that a range of radii between two rings is searched in, before extrema are.
constexpr int steps = 64;

/// The search for the places seen at one point of the sky.
class Search
{
public:
  Search(const TiltedDisk& disk, double x, double y)
    : disk(disk)
    , x(x)
    , y(y)
  {
  }

  /// A flat range of radii has its one root in closed form.
  void flat(double start, double end)
  {
    const RingFrame ring = this->disk.frame(start);
    if (ring.n.z != 0 && this->f(start) < 0 && (std::isinf(end) || this->f(end) >= 0))
    {
      const double r = std::hypot(this->alongAxis(ring), this->acrossAxis(ring) / ring.n.z);
      this->add(std::min(std::max(r, start), end));
    }
  }

  void warped(double start, double end)
  {
    // Nothing is seen farther out than it is: r >= |(x, y)|.
    const double first = std::max(start, std::hypot(this->x, this->y) * (1 - 1e-12));
    if (!(first < end))
    {
      return;
    }
    std::array<double, steps + 1> r, f;
    for (int k = 0; k <= steps; ++k)
    {
      r[k] = k < steps ? first + (end - first) * k / steps : end;
      f[k] = this->f(r[k]);
    }
    for (int k = 1; k <= steps; ++k)
    {
      if ((f[k - 1] < 0) != (f[k] < 0))
      {
        this->add(this->bisect(r[k - 1], r[k], f[k] >= 0));
      }
      else if (k < steps && (f[k] < 0) == (f[k + 1] < 0))
      {
        this->pair(r[k - 1], r[k + 1],
          f[k] < 0 ? f[k] > std::max(f[k - 1], f[k + 1]) : f[k] < std::min(f[k - 1], f[k + 1]),
          f[k] < 0);
      }
    }
  }

  std::vector<DiskPoint> found;

private:
  double alongAxis(const RingFrame& ring) const { return this->x * ring.a.x + this->y * ring.a.y; }
  double acrossAxis(const RingFrame& ring) const { return this->y * ring.a.x - this->x * ring.a.y; }

  double f(double r) const
  {
    const RingFrame ring = this->disk.frame(r);
    const double u = this->alongAxis(ring), w = this->acrossAxis(ring);
    return (r - u) * (r + u) * ring.n.z * ring.n.z - w * w;
  }

  /// The two roots on either side of an extremum that lies beyond 0, where there are any.
  void pair(double low, double high, bool turns, bool below)
  {
    if (turns)
    {
      const double turn = this->extremum(low, high, below ? 1 : -1);
      if ((this->f(turn) < 0) != below)
      {
        this->add(this->bisect(low, turn, below));
        this->add(this->bisect(turn, high, !below));
      }
    }
  }

  double bisect(double low, double high, bool risesFromBelow) const
  {
    for (double middle = 0.5 * (low + high); middle > low && middle < high;
         middle = 0.5 * (low + high))
    {
      ((this->f(middle) < 0) == risesFromBelow ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  /// The maximum of sign * f by golden section.
  double extremum(double low, double high, double sign) const
  {
    constexpr double golden = 0.6180339887498949;
    for (int k = 0; k < 40; ++k)
    {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      (sign * this->f(left) < sign * this->f(right) ? low : high) =
        sign * this->f(left) < sign * this->f(right) ? left : right;
    }
    return 0.5 * (low + high);
  }

  void add(double r)
  {
    const RingFrame ring = this->disk.frame(r);
    const double across = this->acrossAxis(ring);
    const double theta = std::atan2(across == 0 ? 0 : across / ring.n.z, this->alongAxis(ring));
    this->found.push_back({ r, theta });
  }

  const TiltedDisk& disk;
  double x;
  double y;
};

/// Just inside a knot the frame is that of the ring before it, where the disc has a step there.
double insideOf(const TiltedDisk& disk, double knot)
{
  const double inside = std::nextafter(knot, 0);
  const bool step = length(disk.frame(inside).n - disk.frame(knot).n) > 1e-9 ||
    length(disk.frame(inside).a - disk.frame(knot).a) > 1e-9;
  return step ? inside : knot;
}
} // namespace

std::vector<DiskPoint> skyToDisk(const TiltedDisk& disk, double x, double y)
{
  if (x == 0 && y == 0)
  {
    return { {} };
  }
  const std::vector<double> knots = disk.knots();
  Search search(disk, x, y);
  for (std::size_t k = 0; k < knots.size() && knots[k] < disk.outerRadius(); ++k)
  {
    const RingFrame ring = disk.frame(knots[k]);
    const double end =
      k + 1 < knots.size() ? insideOf(disk, knots[k + 1]) : std::numeric_limits<double>::infinity();
    if (ring.bendA == 0 && ring.bendB == 0)
    {
      search.flat(knots[k], end);
    }
    else
    {
      search.warped(knots[k], end);
    }
  }
  std::sort(search.found.begin(), search.found.end(),
    [](const DiskPoint& p, const DiskPoint& q) { return p.r < q.r; });
  return std::move(search.found);
}
} // namespace galaxy
