#include "Filters/Model/DiskInverse.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
constexpr int stepsPerRange = 192;
} // namespace

DiskInverse::DiskInverse(const TiltedDisk& disk, double inner, double outer)
  : disk(disk)
{
  const std::vector<double> ends = disk.knotsBetween(inner, outer);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
  {
    this->tabulate(ends[k], ends[k + 1]);
  }
  this->simple = this->jacobianKeepsItsSign();
}

DiskInverse::Row DiskInverse::rowOf(const RingFrame& ring, double r)
{
  return { r, ring.a.x, ring.a.y, ring.n.z * ring.n.z };
}

// The last row of a range is that of its inside: where the disc has a step the next range begins
// with another row at the same radius.
void DiskInverse::tabulate(double start, double end)
{
  this->starts.push_back(this->rows.size());
  for (int k = 0; k < stepsPerRange; ++k)
  {
    const double r = start + (end - start) * k / stepsPerRange;
    this->rows.push_back(rowOf(this->disk.frame(r), r));
  }
  this->rows.push_back(rowOf(this->disk.frame(std::nextafter(end, start)), end));
}

// J_sky / r = n_z + r kappa e_r,z takes, over the azimuth, all values between
// n_z + (r b_z / 2) (B -+ hypot(A, B)), where (A, B) = n' along (a, b).
bool DiskInverse::jacobianKeepsItsSign() const
{
  int sign = 0;
  for (std::size_t k = 0; k < this->rows.size(); ++k)
  {
    const Row& row = this->rows[k];
    const bool step = k > 0 && this->rows[k - 1].r == row.r &&
      (std::abs(this->rows[k - 1].ax - row.ax) > 1e-9 ||
        std::abs(this->rows[k - 1].ay - row.ay) > 1e-9 ||
        std::abs(this->rows[k - 1].cos2 - row.cos2) > 1e-9);
    const RingFrame ring = this->disk.frame(row.r);
    const double half = 0.5 * row.r * ring.b.z;
    const double turn = std::hypot(ring.bendA, ring.bendB);
    const double low = ring.n.z + half * ring.bendB - std::abs(half) * turn;
    const double high = ring.n.z + half * ring.bendB + std::abs(half) * turn;
    const int here = low > 0 ? 1 : high < 0 ? -1 : 0;
    sign = k == 0 ? here : sign;
    if (step || here == 0 || here != sign)
    {
      return false;
    }
  }
  return true;
}

bool DiskInverse::covers(double x, double y) const
{
  if (this->simple)
  {
    return this->seenFrom(0, x, y) <= 0 && this->seenFrom(this->rows.size() - 1, x, y) >= 0;
  }
  Roots roots;
  std::size_t near = 0;
  return this->search(x, y, roots, near) > 0;
}

// The first row, but for the very first, whose f is not below 0; looked for about `near` first.
std::size_t DiskInverse::firstAbove(double x, double y, std::size_t near) const
{
  const std::size_t last = this->rows.size() - 1;
  for (std::size_t k = std::max<std::size_t>(near, 2) - 1; k <= near + 1 && k <= last; ++k)
  {
    if (this->rows[k - 1].f(x, y) < 0 && this->rows[k].f(x, y) >= 0)
    {
      return k;
    }
  }
  return std::partition_point(this->rows.begin() + 1, this->rows.end() - 1,
           [x, y](const Row& row) { return row.f(x, y) < 0; }) -
    this->rows.begin();
}

int DiskInverse::search(double x, double y, Roots& roots, std::size_t& near) const
{
  if (this->simple)
  {
    if (!this->covers(x, y))
    {
      return 0;
    }
    near = this->firstAbove(x, y, near);
    roots[0] = this->refine(this->rows[near - 1], this->rows[near], x, y);
    return 1;
  }
  int found = 0;
  for (std::size_t range = 0; range < this->starts.size(); ++range)
  {
    const std::size_t first = this->starts[range];
    double before = this->seenFrom(first, x, y);
    for (std::size_t k = first + 1; k <= first + stepsPerRange && found < mostSheets; ++k)
    {
      const double here = this->seenFrom(k, x, y);
      if ((before < 0) != (here < 0))
      {
        roots[found++] = this->refine(this->rows[k - 1], this->rows[k], x, y);
      }
      before = here;
    }
  }
  return found;
}

// Between two rows everything is nearly linear in r^2: the root of the interpolated f is the first
// guess, good to some 1e-7.
double DiskInverse::guess(const Row& low, const Row& high, double x, double y)
{
  const double inner = low.r * low.r, width = high.r * high.r - inner;
  const auto f = [&](double t) {
    const auto between = [t](double a, double b) { return a + t * (b - a); };
    const Row row = { std::sqrt(inner + t * width), between(low.ax, high.ax),
      between(low.ay, high.ay), between(low.cos2, high.cos2) };
    return row.f(x, y);
  };
  double before = 0, t = 1;
  double fBefore = low.f(x, y), fHere = high.f(x, y);
  for (int step = 0; step < 3 && fHere != fBefore; ++step)
  {
    const double next = std::clamp(t - fHere * (t - before) / (fHere - fBefore), 0.0, 1.0);
    before = t;
    fBefore = fHere;
    t = next;
    fHere = f(t);
  }
  return inner + t * width;
}

// False position with the Illinois rule, never out of the bracket, from a guess so good that one
// step mostly does: its error is then that of the slope.
DiskInverse::Root DiskInverse::refine(const Row& low, const Row& high, double x, double y) const
{
  double left = low.r * low.r, right = high.r * high.r;
  double fLeft = low.f(x, y), fRight = high.f(x, y);
  const double rise = std::abs(fRight - fLeft);
  double square = guess(low, high, x, y);
  int side = 0;
  for (int step = 0; step < 60 && fLeft != fRight; ++step)
  {
    const double r = std::sqrt(square);
    const RingFrame ring = this->disk.frame(r);
    const double f = rowOf(ring, r).f(x, y);
    if (std::abs(f) <= 1e-5 * rise)
    {
      // So small a step does not turn the ring by as much as single precision shows.
      const double stepped = square - f * (right - left) / (fRight - fLeft);
      return { std::sqrt(std::clamp(stepped, left, right)), ring };
    }
    const bool isRight = (f < 0) == (fRight < 0);
    (isRight ? right : left) = square;
    (isRight ? fRight : fLeft) = f;
    // An end that stays twice would slow the search: it counts half.
    (isRight ? fLeft : fRight) *= side == (isRight ? 1 : -1) ? 0.5 : 1;
    side = isRight ? 1 : -1;
    square = std::clamp((left * fRight - right * fLeft) / (fRight - fLeft), left, right);
  }
  const double r = std::sqrt(square);
  return { r, this->disk.frame(r) };
}

DiskSheet DiskInverse::sheetAt(const Root& root, double x, double y)
{
  const auto& [r, ring] = root;
  const double u = x * ring.a.x + y * ring.a.y;
  const double w = y * ring.a.x - x * ring.a.y;
  // b is turned by 90 degrees from a on the sky and shortened by n_z.
  const double v = w == 0 ? 0 : w / ring.n.z;
  const double length2 = u * u + v * v;
  DiskSheet sheet;
  sheet.r = r;
  if (length2 > 0)
  {
    const double perLength = 1 / std::sqrt(length2);
    sheet.cosTheta = u * perLength;
    sheet.sinTheta = v * perLength;
  }
  const double kappa = ring.bendA * sheet.cosTheta + ring.bendB * sheet.sinTheta;
  const double bend = r * kappa;
  const double towards = std::abs(ring.n.z + bend * sheet.sinTheta * ring.b.z);
  sheet.share = std::sqrt(1 + bend * bend) / std::max(towards, 1e-9);
  return sheet;
}

int DiskInverse::find(double x, double y, Sheets& sheets) const
{
  std::size_t near = 0;
  return this->find(x, y, sheets, near);
}

int DiskInverse::find(double x, double y, Sheets& sheets, std::size_t& near) const
{
  Roots roots;
  const int found = this->search(x, y, roots, near);
  double sum = 0;
  for (int k = 0; k < found; ++k)
  {
    sheets[k] = sheetAt(roots[k], x, y);
    sum += sheets[k].share;
  }
  for (int k = 0; k < found; ++k)
  {
    sheets[k].share /= sum;
  }
  return found;
}
} // namespace galaxy
