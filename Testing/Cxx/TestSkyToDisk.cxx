#include "Filters/Model/DiskInverse.h"
#include "Filters/Model/SkyToDisk.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

namespace galaxy
{
namespace
{
/// The nearest of the places found to (r, theta), as a distance on the surface's rings.
double nearestTo(const std::vector<DiskPoint>& found, double r, double theta)
{
  double nearest = 1e300;
  for (const DiskPoint& point : found)
  {
    const double turn = std::remainder(point.theta - theta, 2 * pi);
    nearest = std::min(nearest, std::hypot(point.r - r, r * turn));
  }
  return nearest;
}

/// A fold: 40 degrees more of inclination and 60 of position angle between two rings, then flat.
TiltedDisk fold(SpinSense sense = SpinSense::FromCode)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 40, 0), ring(400, 100, 1, 40, 0), ring(600, 100, 1, 80, 60),
    ring(3000, 100, 1, 80, 60) };
  return TiltedDisk(table, m83Distance, sense);
}
} // namespace

TEST(SkyToDisk, ReturnsEveryPlaceOfTheDisc)
{
  const TiltedDisk disks[] = { TiltedDisk(flatDisk(12, 65, 200), m83Distance),
    TiltedDisk(m83Rings(), m83Distance), TiltedDisk(m83Rings(), m83Distance, SpinSense::Clockwise),
    TiltedDisk(m83Rings(), m83Distance, SpinSense::FromCode, RingInterpolation::Slerp), fold(),
    fold(SpinSense::Clockwise) };
  for (const TiltedDisk& disk : disks)
  {
    // Where a fold begins and at the very edge, what is seen is a matter of rounding.
    std::vector<double> radii = { 0, disk.knots()[1] * (1 - 1e-9), disk.knots()[1] * (1 + 1e-9) };
    for (double r = 0.013; r < disk.outerRadius(); r += 0.671)
    {
      radii.push_back(r);
    }
    for (const double r : radii)
    {
      if (r >= disk.outerRadius())
      {
        continue;
      }
      for (double theta = -3.1; theta < 3.1; theta += 0.37)
      {
        const Vec3 p = disk.position(r, theta);
        const std::vector<DiskPoint> found = skyToDisk(disk, p.x, p.y);
        EXPECT_LT(nearestTo(found, r, r == 0 ? 0 : theta), 1e-5 * (1 + r)) << r << " " << theta;
        for (const DiskPoint& point : found)
        {
          const Vec3 q = disk.position(point.r, point.theta);
          EXPECT_NEAR(std::hypot(q.x - p.x, q.y - p.y), 0, 1e-6 * (1 + r));
        }
      }
    }
  }
}

TEST(SkyToDisk, FoldsShowThreeSheets)
{
  const TiltedDisk disk = fold();
  // Sheets are entered and left where the Jacobian vanishes: their number is 1 or 3.
  int three = 0;
  for (double x = -12; x < 12; x += 0.5)
  {
    for (double y = -12; y < 12; y += 0.5)
    {
      const auto found = skyToDisk(disk, x + 0.01, y + 0.02);
      three += found.size() == 3;
      EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
        [](const DiskPoint& p, const DiskPoint& q) { return p.r < q.r; }));
    }
  }
  EXPECT_GT(three, 0);
  // M83's warp has no fold: one place a point.
  const TiltedDisk m83(m83Rings(), m83Distance);
  for (double x = -20; x < 20; x += 0.9)
  {
    for (double y = -20; y < 20; y += 0.9)
    {
      EXPECT_EQ(skyToDisk(m83, x, y).size(), 1u) << x << " " << y;
    }
  }
}

TEST(SkyToDisk, SheetsCoverTheSkyAsOftenAsTheDiscDoes)
{
  // The integral of the number of sheets over the sky is that of the sky Jacobian over the disc.
  const TiltedDisk disk = fold();
  const double outer = disk.outerRadius();
  double area = 0;
  const int rings = 1000, azimuths = 720;
  for (int k = 0; k < rings; ++k)
  {
    for (int j = 0; j < azimuths; ++j)
    {
      area += disk.skyJacobian((k + 0.5) * outer / rings, 2 * pi * (j + 0.5) / azimuths) * outer /
        rings * 2 * pi / azimuths;
    }
  }
  double sheets = 0;
  const double pixel = outer / 100;
  for (double x = -outer + pixel / 2; x < outer; x += pixel)
  {
    for (double y = -outer + pixel / 2; y < outer; y += pixel)
    {
      sheets += static_cast<double>(skyToDisk(disk, x, y).size()) * pixel * pixel;
    }
  }
  EXPECT_NEAR(sheets / area, 1, 0.005);
}

TEST(SkyToDisk, EdgeOnDiscCoversNothingBeyondItsLine)
{
  const TiltedDisk disk(flatDisk(10, 90, 0), m83Distance);
  EXPECT_LE(skyToDisk(disk, 1, 1).size(), 1u);
  RingTable table;
  table.rings = { ring(0, 100, 1, 0, 0), ring(600, 100, 1, 90, 0) };
  const TiltedDisk warp(table, m83Distance);
  for (double x = 0.1; x < 12; x += 0.7)
  {
    for (const DiskPoint& point : skyToDisk(warp, x, 0.3))
    {
      EXPECT_TRUE(std::isfinite(point.r) && std::isfinite(point.theta));
    }
  }
}

TEST(SkyToDisk, StepsLeaveNoFalsePlaces)
{
  RingTable table;
  table.rings = { ring(0, 100, 1, 0, 0), ring(300, 100, 1, 0, 0), ring(300, 100, 1, 60, 0),
    ring(600, 100, 1, 60, 0) };
  const TiltedDisk disk(table, m83Distance);
  const double step = 300 * m83Kpc;
  EXPECT_EQ(skyToDisk(disk, 0.9 * step, 0).size(), 2u); // face-on inside, inclined outside
  EXPECT_EQ(skyToDisk(disk, 0, 0.9 * step).size(), 1u);
  EXPECT_EQ(skyToDisk(disk, 0.3 * step, 0).size(), 1u);
  EXPECT_EQ(skyToDisk(disk, 0, 0).size(), 1u);
  EXPECT_EQ(skyToDisk(disk, 1.01 * step, 0).size(), 0u);
}

TEST(SkyToDisk, CentreAndBeyond)
{
  const TiltedDisk disk(flatDisk(10, 60, 30), m83Distance);
  ASSERT_EQ(skyToDisk(disk, 0, 0).size(), 1u);
  EXPECT_EQ(skyToDisk(disk, 0, 0)[0].r, 0);
  EXPECT_TRUE(skyToDisk(disk, 30, 0).empty());
  const TiltedDisk held(flatDisk(10, 60, 30), m83Distance, SpinSense::FromCode,
    RingInterpolation::LinearAngles, BeyondLastRing::HoldLast);
  EXPECT_EQ(skyToDisk(held, 30, 0).size(), 1u);
}

TEST(DiskInverse, FindsWhatTheReferenceFinds)
{
  const TiltedDisk disks[] = { TiltedDisk(flatDisk(12, 65, 200), m83Distance),
    TiltedDisk(flatDisk(12), m83Distance), TiltedDisk(m83Rings(), m83Distance),
    TiltedDisk(m83Rings(), m83Distance, SpinSense::Clockwise),
    TiltedDisk(m83Rings(), m83Distance, SpinSense::FromCode, RingInterpolation::Slerp), fold() };
  for (const TiltedDisk& disk : disks)
  {
    const DiskInverse inverse(disk, 0, disk.lastRadius());
    EXPECT_EQ(inverse.isSimple(), &disk != &disks[5]);
    int places = 0, missed = 0;
    for (double x = -1.01 * disk.lastRadius(); x < disk.lastRadius();
         x += 0.0371 * disk.lastRadius())
    {
      for (double y = -disk.lastRadius(); y < disk.lastRadius(); y += 0.0413 * disk.lastRadius())
      {
        const std::vector<DiskPoint> wanted = skyToDisk(disk, x, y);
        DiskInverse::Sheets sheets;
        const auto found = static_cast<std::size_t>(inverse.find(x, y, sheets));
        EXPECT_EQ(inverse.covers(x, y), found > 0);
        missed += std::abs(static_cast<int>(wanted.size()) - static_cast<int>(found));
        for (std::size_t k = 0; found == wanted.size() && k < found; ++k)
        {
          ++places;
          EXPECT_NEAR(sheets[k].r / wanted[k].r, 1, 1e-8);
          EXPECT_NEAR(sheets[k].cosTheta, std::cos(wanted[k].theta), 1e-6);
          EXPECT_NEAR(sheets[k].sinTheta, std::sin(wanted[k].theta), 1e-6);
        }
      }
    }
    EXPECT_GT(places, 300);
    EXPECT_LE(missed, 4); // pairs beside the caustics of the fold
  }
}

TEST(DiskInverse, KeepsToItsRadii)
{
  const TiltedDisk disk(flatDisk(12, 60, 90), m83Distance);
  const DiskInverse inverse(disk, 3, 8);
  DiskInverse::Sheets sheets;
  EXPECT_FALSE(inverse.covers(0, 0));
  EXPECT_EQ(inverse.find(2.9, 0, sheets), 0);
  ASSERT_EQ(inverse.find(3.1, 0, sheets), 1);
  EXPECT_NEAR(sheets[0].r, 3.1, 1e-9);
  EXPECT_EQ(inverse.find(8.1, 0, sheets), 0);
  ASSERT_EQ(inverse.find(0, 3.9, sheets), 1); // the minor axis is half as long
  EXPECT_NEAR(sheets[0].r, 7.8, 1e-9);
  EXPECT_EQ(inverse.find(0, 4.1, sheets), 0);
  // An edge-on disc covers no area (hard case 15), a face-on one is the sky itself (14).
  const TiltedDisk edge(flatDisk(12, 90), m83Distance);
  EXPECT_EQ(DiskInverse(edge, 0, 12).find(1, 1, sheets), 0);
  const TiltedDisk face(flatDisk(12, 0), m83Distance);
  ASSERT_EQ(DiskInverse(face, 0, 12).find(-3, 4, sheets), 1);
  EXPECT_NEAR(sheets[0].r, 5, 1e-9);
}
} // namespace galaxy
