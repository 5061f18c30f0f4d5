#include "Filters/Model/Random.h"
#include "Filters/Model/SmoothingLength.h"
#include "Readers/Formats/Error.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/ModelFixtures.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <limits>

namespace
{
using namespace galaxy;

using Cloud = std::vector<float>;
using Draw = std::function<Vec3(Random&)>;

Cloud cloudOf(std::size_t count, const Draw& draw)
{
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    Random random({ 7, 0 }, RandomStream::SpheroidPlace, i);
    const Vec3 p = draw(random);
    cloud.insert(cloud.end(), { float(p.x), float(p.y), float(p.z) });
  }
  return cloud;
}

Vec3 inCube(Random& random)
{
  const double x = random.uniform(), y = random.uniform();
  return { x, y, random.uniform() };
}

Vec3 inPlummerSphere(Random& random)
{
  const double r = 1 / std::sqrt(std::pow(random.uniform(), -2.0 / 3) - 1);
  const double x = random.normal(), y = random.normal();
  return r * normalized({ x, y, random.normal() });
}

/// Inclined by 37 degrees.
Vec3 inDisk(Random& random)
{
  const double r = -2.5 * std::log(random.uniform() * random.uniform());
  const double theta = 2 * pi * random.uniform();
  const double y = r * std::sin(theta), z = 0.3 * random.normal();
  return { r * std::cos(theta), 0.8 * y - 0.6 * z, 0.6 * y + 0.8 * z };
}

/// Twenty times wider than the mean distance of its 30000 particles, and as thick as that.
Vec3 inSlab(Random& random)
{
  const double x = 20 * random.uniform(), y = 20 * random.uniform();
  return { x, y, 0.1 * random.normal() };
}

Vec3 inSheet(Random& random)
{
  const double x = random.uniform();
  return { x, random.uniform(), 0.3 };
}

SmoothingDescription modelled(SmoothingModel model)
{
  SmoothingDescription smoothing;
  smoothing.model = model;
  return smoothing;
}
const SmoothingDescription density = modelled(SmoothingModel::Density);
const SmoothingDescription neighbours = modelled(SmoothingModel::Neighbours);

std::vector<float> lengths(
  const Cloud& cloud, const SmoothingDescription& smoothing, const std::vector<float>& light = {})
{
  std::vector<float> h(cloud.size() / 3);
  smoothingLengths(cloud.data(), light.data(), h.size(), smoothing, h.data());
  return h;
}

/// What the share `part` of the values is below.
double quantile(std::vector<float> values, double part)
{
  const auto at = values.begin() + std::ptrdiff_t(part * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<float> ratios(const std::vector<float>& p, const std::vector<float>& q)
{
  std::vector<float> r;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    r.push_back(p[i] / q[i]);
  }
  return r;
}

Cloud scaled(Cloud cloud, float factor)
{
  for (float& x : cloud)
  {
    x *= factor;
  }
  return cloud;
}

Cloud lattice(int side, double spacing)
{
  Cloud cloud;
  for (int i = 0; i < side * side * side; ++i)
  {
    for (const int k : { i % side, i / side % side, i / side / side })
    {
      cloud.push_back(float(k * spacing));
    }
  }
  return cloud;
}
} // namespace

TEST(Smoothing, OfALatticeFollowsItsSpacing)
{
  const double a = 0.2;
  const std::vector<float> h = lengths(lattice(50, a), density);
  EXPECT_NEAR(quantile(h, 0.5), 1.5 * a, 0.1 * 1.5 * a);
  // In cells that do not fit the spacing.
  EXPECT_GT(quantile(h, 0.05), 0.75 * 1.5 * a);
  EXPECT_LT(quantile(h, 0.95), 1.25 * 1.5 * a);
}

TEST(Smoothing, OfAUniformCloudIsTheMeanDistance)
{
  const std::size_t count = 40000;
  const Cloud cloud = cloudOf(count, inCube);
  const double expected = 1.5 * std::cbrt(1.0 / count);
  EXPECT_NEAR(quantile(lengths(cloud, density), 0.5), expected, 0.05 * expected);
  // Near the sides the balls reach out of the cube.
  EXPECT_NEAR(quantile(lengths(cloud, neighbours), 0.4), expected, 0.05 * expected);
}

TEST(Smoothing, ScalesWithTheCloud)
{
  const Cloud cloud = cloudOf(5000, inPlummerSphere);
  for (const SmoothingDescription& smoothing : { density, neighbours })
  {
    const std::vector<float> r =
      ratios(lengths(scaled(cloud, 2), smoothing), lengths(cloud, smoothing));
    EXPECT_NEAR(quantile(r, 0), 2, 1e-5);
    EXPECT_NEAR(quantile(r, 1), 2, 1e-5);
  }
}

TEST(Smoothing, HalvesWithEightTimesTheParticles)
{
  for (const Draw& draw : { Draw(inCube), Draw(inPlummerSphere) })
  {
    const double few = quantile(lengths(cloudOf(20000, draw), density), 0.5);
    const double many = quantile(lengths(cloudOf(160000, draw), density), 0.5);
    EXPECT_NEAR(few / many, 2, 0.08);
  }
}

// The counts against the exact neighbours: the median within 15 %, and within these limits 68 % and
// 98 % of the particles.
TEST(Smoothing, CountsAgreeWithNeighbours)
{
  struct Case
  {
    const char* name;
    Draw draw;
    double low68, high68, low98, high98;
  };
  const Case cases[] = {
    { "cube", inCube, 0.87, 1.1, 0.7, 1.3 },
    { "Plummer", inPlummerSphere, 0.85, 1.2, 0.6, 2 },
    { "disk", inDisk, 0.85, 1.45, 0.6, 4 },
    { "slab", inSlab, 0.83, 1.3, 0.65, 1.8 },
    { "sheet", inSheet, 0.95, 1.3, 0.75, 1.6 },
  };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.name);
    const Cloud cloud = cloudOf(30000, c.draw);
    const std::vector<float> r = ratios(lengths(cloud, density), lengths(cloud, neighbours));
    EXPECT_NEAR(quantile(r, 0.5), 1, 0.15);
    EXPECT_GT(quantile(r, 0.16), c.low68);
    EXPECT_LT(quantile(r, 0.84), c.high68);
    EXPECT_GT(quantile(r, 0.01), c.low98);
    EXPECT_LT(quantile(r, 0.99), c.high98);
  }
}

// A gradient of 1:100 in a smooth cloud: no step between neighbouring slices is larger than the
// scatter about the mean, though they lie in cells of different sizes.
TEST(Smoothing, HasNoSteps)
{
  const std::size_t count = 400000;
  const double steepness = std::log(100.0);
  const Cloud cloud = cloudOf(count, [&](Random& random) {
    const double u = random.uniform();
    const double x = -std::log(1 - u * (1 - 0.01)) / steepness;
    const double y = random.uniform();
    return Vec3{ x, y, random.uniform() };
  });
  const std::vector<float> h = lengths(cloud, density);
  const double central = count * steepness / 0.99; // particles per volume at x = 0
  std::vector<double> sum(100), number(100);
  for (std::size_t i = 0; i < count; ++i)
  {
    const int slice = std::min(99, int(100 * cloud[3 * i]));
    const double d = std::cbrt(1 / (central * std::exp(-steepness * cloud[3 * i])));
    sum[slice] += h[i] / (1.5 * d);
    ++number[slice];
  }
  for (int slice = 3; slice < 97; ++slice)
  {
    EXPECT_NEAR(sum[slice] / number[slice], 1, 0.08) << slice;
  }
}

namespace
{
Cloud backward(const Cloud& cloud)
{
  Cloud turned(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); i += 3)
  {
    std::copy_n(&cloud[i], 3, &turned[cloud.size() - 3 - i]);
  }
  return turned;
}

/// Every coordinate along the first `axes` axes by its last bit, up or down.
Cloud nudged(Cloud cloud, std::size_t axes, bool up)
{
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    const std::uint32_t odd = randomBits({}, RandomStream::Preview, i, 0)[0] & 1;
    const float end = up || odd ? 1e30F : -1e30F;
    cloud[i] = i % 3 < axes ? std::nextafter(cloud[i], end) : cloud[i];
  }
  return cloud;
}
} // namespace

TEST(Smoothing, IsTheSameForAnyThreadsAndOrder)
{
  const int threads = omp_get_max_threads();
  // Of the larger cloud only a share is counted.
  for (const std::size_t count : { 300000, 2200000 })
  {
    const Cloud cloud = cloudOf(count, inCube);
    const std::vector<float> h = lengths(cloud, density);
    omp_set_num_threads(threads == 3 ? 1 : 3);
    EXPECT_EQ(lengths(cloud, density), h);
    std::vector<float> back = lengths(backward(cloud), density);
    omp_set_num_threads(threads);
    std::reverse(back.begin(), back.end());
    EXPECT_NEAR(
      quantile(h, 0.5), 1.5 * std::cbrt(1.0 / count), 0.05 * 1.5 * std::cbrt(1.0 / count));
    if (count <= 1 << 21)
    {
      EXPECT_EQ(back, h);
      continue;
    }
    // Another order has another share counted: the same to the noise of some 30 neighbours.
    const std::vector<float> r = ratios(back, h);
    EXPECT_NEAR(quantile(r, 0.5), 1, 0.01);
    EXPECT_GT(quantile(r, 0.01), 0.75);
    EXPECT_LT(quantile(r, 0.99), 1 / 0.75);
  }
}

// What no one can know of a coordinate, its last bit, decides nothing: the cells stay where they
// are and the few particles that go over their edges are counted elsewhere.
TEST(Smoothing, HardlyDependsOnTheLastBit)
{
  struct Case
  {
    const char* name;
    std::size_t count;
    Draw draw;
  };
  const Case cases[] = {
    { "Plummer", 200000, inPlummerSphere },
    { "disk", 1000000, inDisk },
    { "slab", 1000000, inSlab },
    { "a share of a disk", 2500000, inDisk },
  };
  for (const Case& c : cases)
  {
    const Cloud cloud = cloudOf(c.count, c.draw);
    const std::vector<float> h = lengths(cloud, density);
    for (const auto& [axes, up] :
      { std::pair<std::size_t, bool>{ 1, true }, { 1, false }, { 3, false } })
    {
      const std::vector<float> other = lengths(nudged(cloud, axes, up), density);
      std::size_t changed = 0;
      for (std::size_t i = 0; i < h.size(); ++i)
      {
        changed += std::abs(other[i] - h[i]) > 1e-3F * h[i];
      }
      EXPECT_LE(static_cast<double>(changed), 1e-3 * c.count) << c.name << ", axes: " << axes;
    }
  }
}

TEST(Smoothing, OfNeighboursGoesWithTheLastBit)
{
  const Cloud cloud = cloudOf(20000, inPlummerSphere);
  const std::vector<float> r =
    ratios(lengths(nudged(cloud, 3, false), neighbours), lengths(cloud, neighbours));
  EXPECT_NEAR(quantile(r, 0), 1, 1e-3);
  EXPECT_NEAR(quantile(r, 1), 1, 1e-3);
}

TEST(Smoothing, SurvivesHardClouds)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  Cloud outlier = cloudOf(20000, inCube);
  const double inside = quantile(lengths(outlier, density), 0.5);
  outlier.insert(outlier.end(), { 1e6f, 0, 0 });
  EXPECT_NEAR(quantile(lengths(outlier, density), 0.5), inside, 0.1 * inside);
  Cloud invalid = cloudOf(20000, inCube);
  invalid.insert(invalid.end(), { nan, 0, 0, 0, infinity, 0, -infinity, nan, infinity });
  EXPECT_NEAR(quantile(lengths(invalid, density), 0.5), inside, 0.1 * inside);
  const Cloud clouds[] = { {}, { 1, 2, 3 }, { 0, 0, 0 }, { 1, 2, 3, 1, 2, 4 }, Cloud(3 * 20000, 5),
    cloudOf(20000,
      [](Random& random) {
        return Vec3{ random.uniform(), 1, 1 };
      }),
    cloudOf(20000,
      [](Random& random) {
        return Vec3{ random.uniform() < 0.5 ? -1.0 : 1.0, 1, 1 };
      }),
    cloudOf(1000,
      [=](Random&) {
        return Vec3{ nan, nan, nan };
      }),
    { 3e38f, 0, 0, -3e38f, 1, 2 }, outlier, invalid, { nan, 0, 0, 1, 2, 3 } };
  for (const Cloud& cloud : clouds)
  {
    for (const SmoothingDescription& smoothing : { density, neighbours })
    {
      for (const float h : lengths(cloud, smoothing))
      {
        ASSERT_TRUE(std::isfinite(h) && h > 0) << h << " of " << cloud.size() / 3;
      }
    }
  }
}

TEST(Smoothing, StaysBetweenMinimumAndMaximum)
{
  SmoothingDescription smoothing;
  smoothing.minimum = 0.1;
  smoothing.maximum = 0.2;
  const std::vector<float> h = lengths(cloudOf(20000, inPlummerSphere), smoothing);
  EXPECT_EQ(quantile(h, 0), 0.1f);
  EXPECT_EQ(quantile(h, 1), 0.2f);
  EXPECT_EQ(lengths({ 1, 2, 3 }, smoothing)[0], 0.1f);
}

TEST(Smoothing, ConstantIsTheLength)
{
  SmoothingDescription smoothing = modelled(SmoothingModel::Constant);
  smoothing.length = 0.25;
  EXPECT_EQ(lengths(cloudOf(3, inCube), smoothing), std::vector<float>(3, 0.25f));
}

TEST(Smoothing, ByBrightnessKeepsTheMeanOfTheLight)
{
  const std::size_t count = 100000;
  std::vector<float> light(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    light[i] = i % 5 == 0 ? 0 : float(1e-30 * std::pow(1e6, i / double(count)));
  }
  SmoothingDescription smoothing = modelled(SmoothingModel::Brightness);
  smoothing.length = 0.4;
  smoothing.exponent = 0.5;
  smoothing.minimum = 1e-4;
  const std::vector<float> h = lengths(Cloud(3 * count), smoothing, light);
  double lightSum = 0, sum = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    sum += double(light[i]) * h[i];
    lightSum += light[i];
  }
  EXPECT_NEAR(sum / lightSum, 0.4, 1e-5);
  EXPECT_NEAR(h[90001] / h[40001], std::sqrt(light[90001] / light[40001]), 1e-3);
  EXPECT_EQ(h[0], 1e-4f);
  EXPECT_EQ(lengths(Cloud(6), smoothing, { 0, 0 }), std::vector<float>(2, 0.4f));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(
    lengths(Cloud(9), smoothing, { nan, -1, 2 }), (std::vector<float>{ 1e-4f, 1e-4f, 0.4f }));
}

TEST(Smoothing, IsSetForOneComponentAlone)
{
  Particles particles;
  const Cloud cloud = cloudOf(300, inCube);
  particles.position = Buffer<float>(900);
  particles.intensity = Buffer<float>(300);
  particles.smoothingLength = Buffer<float>(300);
  std::copy(cloud.begin(), cloud.end(), particles.position.begin());
  std::fill(particles.smoothingLength.begin(), particles.smoothingLength.end(), -1.0f);
  setSmoothingLengths(particles, 100, 200, density);
  const std::vector<float> h = lengths({ cloud.begin() + 300, cloud.begin() + 600 }, density);
  EXPECT_TRUE(std::equal(h.begin(), h.end(), particles.smoothingLength.begin() + 100));
  EXPECT_EQ(particles.smoothingLength[99], -1);
  EXPECT_EQ(particles.smoothingLength[200], -1);
}

TEST(Smoothing, RefusesWhatIsOutOfRange)
{
  const auto refused = [](const char* name, auto change) {
    SmoothingDescription smoothing;
    change(smoothing);
    const std::string message = errorOf([&] { lengths({ 1, 2, 3 }, smoothing); });
    EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
  };
  refused("factor", [](auto& s) { s.factor = 0; });
  refused("neighbours", [](auto& s) { s.neighbours = 0; });
  refused("length", [](auto& s) { s.length = -1; });
  refused("exponent", [](auto& s) { s.exponent = std::nan(""); });
  refused("minimum", [](auto& s) { s.minimum = -1; });
  refused("maximum", [](auto& s) { s.minimum = 2, s.maximum = 1; });
}

TEST(Smoothing, IsReadFromTheFile)
{
  const std::string head =
    "[galaxy]\ndistance = 1\nra = 10\ndec = 20\n[[component]]\nname = \"c\"\n"
    "profile = \"Exponential\"\n";
  const auto read = [&](const std::string& text) {
    return parseGalaxyDescription(head + text, "g.galaxy").components[0].smoothing;
  };
  EXPECT_EQ(read("").model, SmoothingModel::Density);
  const SmoothingDescription flat = read("smoothing_length = 0.3\n");
  EXPECT_EQ(flat.model, SmoothingModel::Constant);
  EXPECT_EQ(flat.length, 0.3);
  const SmoothingDescription full = read("[component.smoothing]\nmodel = \"Neighbours\"\n"
                                         "neighbours = 12\nfactor = 2\nminimum = 0.1\n");
  EXPECT_EQ(full.model, SmoothingModel::Neighbours);
  EXPECT_EQ(full.neighbours, 12);
  EXPECT_EQ(full.factor, 2);
  EXPECT_EQ(full.minimum, 0.1);
  EXPECT_EQ(read("smoothing_length = 0\n[component.smoothing]\nfactor = 2\n").factor, 2);
  EXPECT_THROW(read("smoothing_length = 1\n[component.smoothing]\nlength = 2\n"), Error);
  EXPECT_THROW(read("[component.smoothing]\nminimum = 2\nmaximum = 1\n"), Error);
  EXPECT_THROW(read("[component.smoothing]\nneighbours = 0\n"), Error);
}
