#include "Testing/Cxx/HardCaseFixtures.h"

// Hard cases of tilted rings, each from its rings to the finished particles. The numbers are those
// of the catalogue of hard cases, as in the other TestHardCases files.

namespace galaxy
{
namespace
{
/// The largest distance between particles of the same number, kpc; of unlike counts infinite.
/// `mirror` is the factor on the second ones' depth.
double farthest(const Particles& p, const Particles& q, double mirror = 1)
{
  if (p.size() != q.size() || p.size() == 0)
  {
    return INFINITY;
  }
  double most = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    Vec3 other = seenFromEarth(q, i).place;
    other.z *= mirror;
    most = std::max(most, length(seenFromEarth(p, i).place - other));
  }
  return most;
}

RingTable inclined(RingTable table, const std::function<double(double)>& change)
{
  for (Ring& ring : table.rings)
  {
    ring.inclination = change(ring.inclination);
  }
  return table;
}

RingTable twoRings(double firstAngle, double secondAngle)
{
  RingTable table;
  table.file = "two.txt";
  table.rings = { ring(0, 200, 10, 60, firstAngle), ring(420, 200, 10, 60, secondAngle) };
  return table;
}

/// The largest radius of a particle, kpc.
double reach(const Particles& particles)
{
  double most = 0;
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    most = std::max(most, length(seenFromEarth(particles, i).place));
  }
  return most;
}
} // namespace

TEST(HardCase, N13_PositionAngleTakesTheShortWayOverNorth)
{
  const auto built = [](const RingTable& rings) {
    return buildGalaxy(galaxyOf(rings, { thickLayer() }));
  };
  const Particles wrapped = built(twoRings(350, 10));
  EXPECT_LT(farthest(wrapped, built(twoRings(350, 370))), 1e-5);
  EXPECT_LT(farthest(wrapped, built(twoRings(-10, 10))), 1e-5);
  const RingTable read = parseRingTable("0 200 10 60 350\n420 200 10 60 10\n", "two.txt");
  EXPECT_LT(farthest(wrapped, built(read)), 1e-5);
  expectPictureKept(galaxyOf(read, { thickLayer() }), wrapped);
  // The long way would have led over South.
  EXPECT_GT(farthest(wrapped, built(twoRings(10, 30))), 0.1);
}

TEST(HardCase, N14_FaceOnTheNodesMeanNothing)
{
  const auto round = [](double x, double y) { return std::exp(-(x * x + y * y) / 18); };
  RingTable twisted = flatDisk(10);
  twisted.rings = { ring(0, 200, 10, 0, 0), ring(200, 200, 10, 0, 100),
    ring(10 / m83Kpc, 200, 10, 0, 250) };
  for (const RingTable& rings :
    { flatDisk(10), flatDisk(10, 0, 37), flatDisk(10, 0, 251), twisted })
  {
    for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
    {
      ComponentDescription stars = thickLayer();
      stars.sampling = sampling;
      const Galaxy input = galaxyOf(rings, { stars }, round);
      const Particles particles = buildGalaxy(input, withVelocities());
      expectPictureKept(input, particles);
      double sum = 0, cosines[3] = {}, sines[3] = {}, squares = 0, outward = 0;
      for (std::size_t i = 0; i < particles.size(); ++i)
      {
        const auto [p, h, light] = seenFromEarth(particles, i);
        const Vec3 v = velocityOf(particles, i);
        sum += light;
        squares += light * (p.x * p.x + p.y * p.y);
        for (int m = 0; m < 3; ++m)
        {
          cosines[m] += light * std::cos((m + 1) * std::atan2(p.y, p.x));
          sines[m] += light * std::sin((m + 1) * std::atan2(p.y, p.x));
        }
        // A filled pixel's particle moves with the place of the disc behind it.
        const double r = std::hypot(p.x, p.y);
        outward += light * std::abs(p.x * v.x + p.y * v.y) / (200 * r);
        ASSERT_NEAR(length(v), 200, 1e-3);
      }
      for (int m = 0; m < 3; ++m)
      {
        EXPECT_LT(std::hypot(cosines[m], sines[m]) / sum, 0.01) << m + 1;
      }
      EXPECT_NEAR(squares / sum, 18 * (1 - 100 / 18.0 / std::expm1(100 / 18.0)), 0.1);
      EXPECT_LT(outward / sum, 1e-4);
    }
  }
}

TEST(HardCase, N15_EdgeOnRingsHoldNoneOfTheSky)
{
  BuildReport report;
  const Particles none = buildGalaxy(galaxyOf(flatDisk(10, 90, 30), { thickLayer() }), {}, &report);
  EXPECT_GT(report.components[0].flux, 0);
  EXPECT_EQ(none.size(), 0u);
  EXPECT_EQ(report.components[0].light, 0);
  // Face-on within 5 kpc, edge-on from there: the rest of the light is reported as off the disc.
  RingTable step = flatDisk(10);
  const double half = 5 / m83Kpc;
  step.rings = { ring(0, 200, 10, 0, 30), ring(half, 200, 10, 0, 30), ring(half, 200, 10, 90, 30),
    ring(2 * half, 200, 10, 90, 30) };
  const Galaxy input = galaxyOf(step, { thickLayer() });
  const Particles inside = buildGalaxy(input, {}, &report);
  expectFinite(inside);
  expectPictureKept(input, inside);
  const ComponentReport& done = report.components[0];
  EXPECT_NEAR(done.light / (0.5 * 25 * pi), 1, 0.02);
  const double square = pictureSide * pictureKpc;
  EXPECT_NEAR((done.flux - done.light) / (0.5 * (square * square - 25 * pi)), 1, 0.005);
  // Seeds spread over the surface do stand there, on a line of the sky.
  ComponentDescription even = thickLayer();
  even.sampling = SeedSampling::SurfaceUniform;
  const Particles line = buildGalaxy(galaxyOf(step, { even }), {}, &report);
  expectFinite(line);
  EXPECT_LE(report.components[0].light, report.components[0].flux * (1 + 1e-6));
}

TEST(HardCase, N16_InclinationBeyond90TurnsTheOtherWay)
{
  const auto built = [](const RingTable& rings, SpinSense spin) {
    Galaxy input = galaxyOf(rings, { ofPoints(thickLayer()) });
    input.description.spin = spin;
    return buildGalaxy(input, withVelocities());
  };
  const auto beyond = [](double i) { return 180 - i; };
  for (const RingTable& rings : { flatDisk(10, 65, 40), m83Rings() })
  {
    const Particles plain = built(rings, SpinSense::CounterClockwise);
    const Particles same = built(inclined(rings, beyond), SpinSense::Clockwise);
    EXPECT_LT(farthest(plain, same), 1e-4);
    // With the same sense in the table it is the mirror image: near and far side change places.
    const Particles mirror = built(inclined(rings, beyond), SpinSense::CounterClockwise);
    EXPECT_LT(farthest(plain, mirror, -1), 1e-4);
    EXPECT_GT(farthest(plain, mirror), 1);
    double apart = 0, apartMirrored = 0;
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      const Vec3 v = velocityOf(plain, i), w = velocityOf(mirror, i);
      apart = std::max(apart, length(v - velocityOf(same, i)));
      apartMirrored = std::max(apartMirrored, length(v - Vec3{ -w.x, -w.y, w.z }));
    }
    EXPECT_LT(apart, 0.01);
    EXPECT_LT(apartMirrored, 0.01);
  }
}

TEST(HardCase, N17_SheetsOfAFoldShareTheFlux)
{
  RingTable rings;
  rings.file = "fold.txt";
  rings.rings = { ring(0, 100, 0, 40, 0), ring(400, 100, 0, 40, 0), ring(600, 100, 0, 80, 60),
    ring(1000, 100, 0, 80, 60) };
  const TiltedDisk disk(rings, m83Distance);
  const DiskInverse inverse(disk, 0, disk.lastRadius());
  constexpr int side = 240;
  constexpr double kpc = 5 * m83Kpc;
  // One pixel is lit, the first that shows three sheets all over.
  DiskInverse::Sheets sheets;
  const auto threeAbout = [&](double x, double y) {
    bool three = true;
    for (int part = 0; part < 25; ++part)
    {
      three = three &&
        inverse.find(x + (part % 5 - 2) * 0.5 * kpc, y + (part / 5 - 2) * 0.5 * kpc, sheets) == 3;
    }
    return three;
  };
  double litX = INFINITY, litY = INFINITY;
  const auto oneLit = [&](double x, double y) {
    if (std::isinf(litX) && threeAbout(x, y))
    {
      litX = x;
      litY = y;
    }
    return x == litX && y == litY ? 0.8 : 0;
  };
  const Galaxy input = galaxyOf(rings, { thickLayer(ThicknessModel::Rings) }, oneLit, 5, side);
  ASSERT_TRUE(std::isfinite(litX));
  const Particles particles = buildGalaxy(input);
  EXPECT_NEAR(lightOf(particles) / (0.8 * kpc * kpc), 1, 2e-4);
  expectPictureKept(input, particles);
  ASSERT_EQ(inverse.find(litX, litY, sheets), 3);
  double light[3] = {};
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    // Without thickness a place's distance from the centre is its ring's radius.
    const double r = length(seenFromEarth(particles, i).place);
    const double* nearest = nullptr;
    int sheet = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (!nearest || std::abs(sheets[k].r - r) < std::abs(*nearest - r))
      {
        nearest = &sheets[k].r;
        sheet = k;
      }
    }
    light[sheet] += particles.intensity[i];
  }
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_GT(sheets[k].share, 0.05);
    EXPECT_NEAR(light[k] / lightOf(particles), sheets[k].share, 0.03) << k;
  }
}

TEST(HardCase, N18_OddRingTables)
{
  RingTable hole = flatDisk(10), step = flatDisk(10);
  hole.rings = { ring(200, 200, 10, 30, 40), ring(420, 200, 10, 50, 70) };
  step.rings = { ring(0, 200, 10, 20, 40), ring(200, 200, 10, 20, 40), ring(200, 150, 20, 40, 60),
    ring(200, 180, 15, 30, 50), ring(420, 180, 15, 30, 50) };
  RingTable zeros = step;
  zeros.rings[1].radius = 0;
  // One ring; a first ring that is not at the centre; rings of equal radii, there and further out.
  for (const RingTable& rings : { flatDisk(10, 50, 70), hole, step, zeros })
  {
    const Galaxy input = galaxyOf(rings, { thickLayer() });
    const Particles particles = buildGalaxy(input, withVelocities());
    expectFinite(particles);
    expectPictureKept(input, particles);
    EXPECT_GT(EarthView(input, particles).light[(pictureSide + 1) * pictureSide / 2], 0);
  }
  RingTable unsorted = step;
  std::swap(unsorted.rings[1], unsorted.rings[4]);
  EXPECT_EQ(messageOf(galaxyOf(unsorted, { thickLayer() })).rfind("flat.txt: ring 3: ", 0), 0u);
  EXPECT_THROW(parseRingTable("0 1 1 0 0\n300 1 1 0 0\n200 1 1 0 0\n", "two.txt"), Error);
}

TEST(HardCase, N19_BeyondTheLastRing)
{
  RingTable rings = flatDisk(5);
  rings.rings = { ring(0, 200, 0, 10, 0), ring(5 / m83Kpc, 200, 0, 50, 30) };
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    ComponentDescription stars = thickLayer(ThicknessModel::Rings);
    stars.sampling = sampling;
    stars.outerRadius = 9;
    Galaxy input = galaxyOf(rings, { stars });
    // A ring's light may spill over the edge by a pixel, whose middle is on the disc.
    const Particles dropped = buildGalaxy(input);
    EXPECT_NEAR(reach(dropped), 5, 1e-3);
    expectPictureKept(input, dropped);
    input.description.beyondLastRing = BeyondLastRing::HoldLast;
    const Particles held = buildGalaxy(input);
    EXPECT_NEAR(reach(held), 9, 0.05);
    EXPECT_LT(reach(held), 9 + 1e-5);
    expectPictureKept(input, held);
    EXPECT_GT(lightOf(held), 2 * lightOf(dropped));
    // What lies beyond lies in the last ring's plane.
    const Vec3 n = TiltedDisk(rings, m83Distance).frame(5).n;
    for (std::size_t i = 0; i < held.size(); ++i)
    {
      const Vec3 p = seenFromEarth(held, i).place;
      ASSERT_TRUE(length(p) <= 5 || std::abs(dot(p, n)) < 1e-5);
    }
    // Nothing asks for more than the rings: they are the disc's end in either case.
    input.description.components[0].outerRadius = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(reach(buildGalaxy(input)), 5, 1e-3);
  }
}
} // namespace galaxy
