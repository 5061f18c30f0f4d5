#include "Filters/Model/SkyToDisk.h"
#include "Readers/Formats/CelestialFrame.h"
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/SkyFrame.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace galaxy
{
namespace
{
const std::string folder = GALAXY_SOURCE_DIR "/../shared/data/NGC2903/";
constexpr double distance2903 = 8.7;

/// How two velocity fields compare where both are known.
struct Comparison
{
  int count = 0;
  double correlation = 0;
  double scatter = 0; ///< km/s, 1.4826 times the median difference from the median difference
  double rms = 0;     ///< km/s, of the differences about their mean
};

double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

Comparison compare(const std::vector<double>& model, const std::vector<double>& data)
{
  std::vector<double> differences;
  double n = 0, sumM = 0, sumD = 0, sumMM = 0, sumDD = 0, sumMD = 0;
  for (std::size_t k = 0; k < model.size(); ++k)
  {
    if (std::isfinite(model[k]) && std::isfinite(data[k]))
    {
      n += 1;
      sumM += model[k];
      sumD += data[k];
      sumMM += model[k] * model[k];
      sumDD += data[k] * data[k];
      sumMD += model[k] * data[k];
      differences.push_back(model[k] - data[k]);
    }
  }
  const double varM = sumMM / n - sumM / n * sumM / n, varD = sumDD / n - sumD / n * sumD / n;
  const double covariance = sumMD / n - sumM / n * sumD / n;
  double sumE = 0, sumEE = 0;
  for (const double difference : differences)
  {
    sumE += difference;
    sumEE += difference * difference;
  }
  const double rms = std::sqrt(sumEE / n - sumE / n * sumE / n);
  const double middle = median(differences);
  for (double& difference : differences)
  {
    difference = std::abs(difference - middle);
  }
  return { static_cast<int>(n), covariance / std::sqrt(varM * varD), 1.4826 * median(differences),
    rms };
}

/// The model's velocity, km/s, at each pixel of the image; NaN where the disc is not seen.
std::vector<double> velocityField(
  const TiltedDisk& disk, const SkyFrame& frame, const WorldCoordinates& sky, int width, int height)
{
  std::vector<double> field(static_cast<std::size_t>(width) * height, std::nan(""));
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      SkyPosition position;
      double x, y;
      if (sky.pixelToSky({ i + 1.0, j + 1.0 }, position) && frame.skyToPlane(position, x, y))
      {
        const std::vector<DiskPoint> seen = skyToDisk(disk, x, y);
        double sum = 0;
        for (const DiskPoint& point : seen)
        {
          sum += disk.lineOfSightVelocity(point.r, point.theta);
        }
        field[static_cast<std::size_t>(j) * width + i] =
          seen.empty() ? std::nan("") : sum / static_cast<double>(seen.size());
      }
    }
  }
  return field;
}

RingTable turned(RingTable table, double angle)
{
  for (Ring& ring : table.rings)
  {
    ring.positionAngle += angle;
  }
  return table;
}
} // namespace

TEST(VelocityField, OfAFlatDiscIsItsClosedForm)
{
  RingTable table = flatDisk(10, 60, 90);
  table.rings[0].systemicVelocity = 500;
  const TiltedDisk disk(table, m83Distance);
  // Position angle 90: the receding half lies to the East, at negative X.
  for (double x = -8; x < 8.1; x += 1.6)
  {
    for (double y = -3; y < 3.1; y += 0.7)
    {
      const auto seen = skyToDisk(disk, x, y);
      ASSERT_EQ(seen.size(), 1u);
      const double r = std::hypot(x, y / std::cos(60 * degree));
      EXPECT_NEAR(seen[0].r, r, 1e-12 * r);
      EXPECT_NEAR(disk.lineOfSightVelocity(seen[0].r, seen[0].theta),
        500 - 200 * x / r * std::sin(60 * degree), 1e-9);
    }
  }
}

TEST(VelocityField, OfARotcurTableIsRotcursFormula)
{
  const RingTable table = parseRingTable("! ROTCUR\n"
                                         "50 50 500 1 120 1 35 1 30 1 55 1\n"
                                         "450 50 500 1 120 1 35 1 30 1 55 1\n",
    "some.rotcur");
  const double sinPA = std::sin(30 * degree), cosPA = std::cos(30 * degree);
  for (const SpinSense spin : { SpinSense::Clockwise, SpinSense::CounterClockwise })
  {
    const TiltedDisk disk(table, m83Distance, spin);
    for (const double x : { -2.1, 2.3 })
    {
      for (const double y : { -3.0, 1.9 })
      {
        const auto seen = skyToDisk(disk, x, y);
        ASSERT_EQ(seen.size(), 1u);
        const double cosT = (-x * sinPA + y * cosPA) / seen[0].r;
        const double sinT = (-x * cosPA - y * sinPA) / (seen[0].r * std::cos(55 * degree));
        EXPECT_NEAR(disk.lineOfSightVelocity(seen[0].r, seen[0].theta),
          500 + (120 * cosT + 35 * sinT) * std::sin(55 * degree), 1e-6);
      }
    }
  }
}

TEST(VelocityField, DoesNotKnowTheSpin)
{
  RingTable table = m83Rings();
  for (Ring& ring : table.rings)
  {
    ring.expansionVelocity = 30;
  }
  const TiltedDisk one(table, m83Distance, SpinSense::Clockwise);
  const TiltedDisk other(table, m83Distance, SpinSense::CounterClockwise);
  for (double x = -15; x < 15; x += 2.3)
  {
    for (double y = -15; y < 15; y += 2.1)
    {
      const auto p = skyToDisk(one, x, y), q = skyToDisk(other, x, y);
      ASSERT_EQ(p.size(), 1u);
      ASSERT_EQ(q.size(), 1u);
      EXPECT_NEAR(one.lineOfSightVelocity(p[0].r, p[0].theta),
        other.lineOfSightVelocity(q[0].r, q[0].theta), 1e-6);
    }
  }
}

TEST(VelocityField, OfNgc2903IsThatObserved)
{
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << "no observations at " << folder;
  }
  const RingTable table = readRingTable(folder + "NGC_2903.def");
  const Image observed = readFitsImage(folder + "NGC_2903_HI_mom1.fits");
  const WorldCoordinates sky(observed.file, observed.cards, observed.width, observed.height);
  const auto column = [&](const char* name) {
    return std::find_if(table.columns.begin(), table.columns.end(), [&](const RingColumn& c) {
      return c.name == name;
    })->values.at(0);
  };
  const SkyPosition centre = CelestialFrame::fk4(1950).toIcrs({ column("XPOS"), column("YPOS") });
  const SkyFrame frame(centre, distance2903);
  const Image intensity = readFitsImage(folder + "NGC_2903_HI_mom0.fits");
  double brightest = 0;
  for (const double value : intensity.values)
  {
    brightest = value > brightest ? value : brightest;
  }
  // The map is in m/s. Its faintest pixels are noise, of velocities down to -720 km/s.
  std::vector<double> data = observed.values;
  for (std::size_t k = 0; k < data.size(); ++k)
  {
    data[k] = intensity.values[k] > 0.02 * brightest ? data[k] / 1000 : std::nan("");
  }
  const auto against = [&](const RingTable& rings) {
    return compare(
      velocityField(TiltedDisk(rings, distance2903), frame, sky, observed.width, observed.height),
      data);
  };
  const Comparison right = against(table);
  RecordProperty("pixels", right.count);
  std::printf("NGC 2903: %d pixels, correlation %.5f, robust scatter %.3f, rms %.3f km/s\n",
    right.count, right.correlation, right.scatter, right.rms);
  EXPECT_GT(right.count, 1000);
  EXPECT_GE(right.correlation, 0.98);
  EXPECT_LE(right.scatter, 12);
  // The bar's streaming and the outermost, noisy pixels make long tails.
  EXPECT_LE(right.rms, 18);
  EXPECT_LE(against(turned(table, 180)).correlation, -0.98);
}
} // namespace galaxy
