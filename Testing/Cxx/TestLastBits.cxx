// The particles do not hang on the last bits of the images' world coordinates, which differ between
// versions of WCSLIB, C libraries and processors. Grids, radii and pixels are chosen to meet: edges
// of maps on borders of pixels, middles of pixels on edges of discs, one image's pixels half a
// pixel beside another's.
#include "Testing/Cxx/HardCaseFixtures.h"

namespace galaxy
{
namespace
{
/// Light whose every pixel differs, over all of an image.
double grainyLight(double x, double y)
{
  return 0.4 + 0.3 * std::sin(7 * x) * std::cos(5 * y) + 0.2 * std::exp(-std::hypot(x, y));
}

/// The images' coordinates moved by some bits of a degree.
Galaxy moved(Galaxy input, double ra, double dec)
{
  for (ImageDescription& image : input.description.images)
  {
    image.coordinates.centre.ra += ra;
    image.coordinates.centre.dec += dec;
  }
  return input;
}

void expectSame(const Particles& p, const Particles& q)
{
  ASSERT_EQ(p.size(), q.size());
  double farthest = 0, widest = 0, brightest = 0;
  std::size_t colors = 0;
  for (std::size_t i = 0; i < 3 * p.size(); ++i)
  {
    farthest = std::max(farthest, std::abs(double(p.position[i]) - q.position[i]));
    colors += p.color[i] != q.color[i];
  }
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    widest = std::max(widest, std::abs(q.smoothingLength[i] / double(p.smoothingLength[i]) - 1));
    brightest = std::max(brightest,
      std::abs(q.intensity[i] - double(p.intensity[i])) / std::max(1e-30, double(p.intensity[i])));
  }
  EXPECT_LE(farthest, 1e-5); // kpc, of some 10
  EXPECT_LE(widest, 1e-5);
  EXPECT_LE(brightest, 1e-5);
  EXPECT_EQ(colors, 0u);
}

void expectSameWherever(const Galaxy& input)
{
  const Particles still = buildGalaxy(input);
  ASSERT_GT(still.size(), 1000u);
  for (const double shift : { 1e-13, -1e-13, 3e-13 })
  {
    SCOPED_TRACE(shift);
    expectSame(still, buildGalaxy(moved(input, shift, 0)));
    expectSame(still, buildGalaxy(moved(input, 0, shift)));
    expectSame(still, buildGalaxy(moved(input, shift, -shift)));
  }
}

/// An image beside the first one, whose light counts in every component.
void addLayer(Galaxy& input, int side, double pixel)
{
  input.images.push_back(skyPicture(side, grainyLight, pixel));
  input.description.images.push_back(pictureDescription("other", pixel));
  for (ComponentDescription& component : input.description.components)
  {
    component.layers.push_back(component.layers.front());
    component.layers.back().image = "other";
    component.layers.back().color = { 0.3, 0.5, 0.1 };
  }
}
} // namespace

// The box about an image, a part in 32 wider to every side, ends on borders of its pixels.
TEST(LastBits, OfTheEdgesOfAnImage)
{
  expectSameWherever(galaxyOf(flatDisk(20, 40, 30), { thickLayer() }, grainyLight, 15, 64));
}

// A map that ends with its radius ends on a border of pixels, or on their middles.
TEST(LastBits, OfTheEdgesOfAMap)
{
  const double pixel = 0.25 / m83Kpc;
  for (const int side : { 80, 81 })
  {
    expectSameWherever(galaxyOf(flatDisk(5), { thickLayer() }, grainyLight, pixel, side));
  }
}

// 3, 4 and 5, among others: middles of pixels on the edge of the disc.
TEST(LastBits, OfTheEdgesOfADisc)
{
  ComponentDescription ring = thickLayer();
  ring.innerRadius = 2.5;
  ring.particles = 20000;
  expectSameWherever(galaxyOf(flatDisk(5), { ring }, grainyLight, 0.25 / m83Kpc, 61));
}

TEST(LastBits, OfBordersOfAnotherImagesPixels)
{
  Galaxy input = galaxyOf(flatDisk(8, 50, 20), { thickLayer() }, grainyLight, 15, 64);
  addLayer(input, 65, 15);
  expectSameWherever(input);
}

// Six fifths of the map's pixels: those of whole seconds of arc.
TEST(LastBits, OfTheRatioOfPixels)
{
  Galaxy input = galaxyOf(flatDisk(8, 50, 20), { thickLayer() }, grainyLight, 15, 64);
  addLayer(input, 60, 18);
  expectSameWherever(input);
}

// Coarse pixels, some of them blank, whose middles are seen in the middles of fine ones.
TEST(LastBits, OfMiddlesOfBlankPixels)
{
  Galaxy input = galaxyOf(flatDisk(8, 50, 20), { thickLayer() }, grainyLight, 15, 63);
  addLayer(input, 21, 45);
  for (std::size_t i = 0; i < input.images[1].values.size(); i += 5)
  {
    input.images[1].values[i] = std::nan("");
  }
  expectSameWherever(input);
}

// Hundreds of thousands of seeds, whose places in a long sum decide of their pixels.
TEST(LastBits, OfManySeeds)
{
  ComponentDescription stars = thickLayer();
  stars.particles = 300000;
  stars.thickness.children = 1;
  expectSameWherever(galaxyOf(flatDisk(8, 50, 20), { stars }, grainyLight, 3, 300));
}
} // namespace galaxy
