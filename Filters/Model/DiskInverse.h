#ifndef galaxy_DiskInverse_h
#define galaxy_DiskInverse_h

#include "Filters/Model/RingGeometry.h"

#include <array>
#include <vector>

namespace galaxy
{
/// A place on a disc that is seen at a point of the sky, and how much of the disc is seen there.
struct DiskSheet
{
  double r = 0; ///< kpc
  double cosTheta = 1;
  double sinTheta = 0;
  double share = 1; ///< of the light seen there: area of disc per area of sky, 1 in sum
};

/// From the sky to the disc, for many points: the same places as skyToDisk finds, by tables.
///
/// The function whose roots they are, f(r) = (r^2 - u^2) cos^2 i - w^2 (see skyToDisk), needs only
/// three numbers a ring, which are tabulated. Where the Jacobian of the surface on the sky has one
/// sign throughout, the root is single and a binary search finds its place in the table; elsewhere
/// the whole table is looked through. Radii are right to 1e-8 of themselves, azimuths to 1e-6; two
/// roots on either side of a caustic that lie closer than a step of the table, 1/192 of a range
/// between two rings, can go unseen together.
class DiskInverse
{
public:
  static constexpr int mostSheets = 16;
  using Sheets = std::array<DiskSheet, mostSheets>;

  /// Looks at radii from `inner` to `outer` (kpc).
  DiskInverse(const TiltedDisk& disk, double inner, double outer);

  /// Writes the sheets seen at (x, y), kpc to the West and North, by increasing radius; their
  /// number.
  int find(double x, double y, Sheets& sheets) const;
  /// The same where points come in order: `near` keeps the place in the table from one to the next.
  int find(double x, double y, Sheets& sheets, std::size_t& near) const;
  /// Whether there is any.
  bool covers(double x, double y) const;
  /// Whether every point of the sky shows one sheet at most.
  bool isSimple() const { return this->simple; }

private:
  /// A ring: the receding axis's direction on the sky and cos^2 of its inclination.
  struct Row
  {
    double r;
    double ax, ay;
    double cos2;
    double f(double x, double y) const
    {
      const double u = x * this->ax + y * this->ay;
      const double w = y * this->ax - x * this->ay;
      return (this->r - u) * (this->r + u) * this->cos2 - w * w;
    }
  };

  /// A root of f, and the ring there.
  struct Root
  {
    double r;
    RingFrame ring;
  };
  using Roots = std::array<Root, mostSheets>;

  /// f of a row, of the first and the last a little farther out of the disc: the last bit of a
  /// point on its edge, such as a pixel's middle, must not decide.
  double seenFrom(std::size_t row, double x, double y) const
  {
    constexpr double margin = 2e-9; // of f, hence half of that of r
    const Row& at = this->rows[row];
    const double out = row == 0 ? -margin : row + 1 == this->rows.size() ? margin : 0;
    return at.f(x, y) + out * at.r * at.r * at.cos2;
  }

  void tabulate(double start, double end);
  bool jacobianKeepsItsSign() const;
  static Row rowOf(const RingFrame& ring, double r);
  int search(double x, double y, Roots& roots, std::size_t& near) const;
  std::size_t firstAbove(double x, double y, std::size_t near) const;
  static double guess(const Row& low, const Row& high, double x, double y);
  Root refine(const Row& low, const Row& high, double x, double y) const;
  static DiskSheet sheetAt(const Root& root, double x, double y);

  const TiltedDisk& disk;
  std::vector<Row> rows;
  std::vector<std::size_t> starts; ///< of the ranges between rings, where the disc may have a step
  bool simple;
};
} // namespace galaxy

#endif
