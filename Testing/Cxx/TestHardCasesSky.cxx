#include "Filters/Model/GroupBuilder.h"
#include "Filters/Model/Placement.h"
#include "Testing/Cxx/CoordinateFixtures.h"
#include "Testing/Cxx/FitsFixtures.h"
#include "Testing/Cxx/HardCaseFixtures.h"

#include <fstream>

// Hard cases of images, of their coordinates and of places in space, numbered as in the other
// TestHardCases files.

namespace galaxy
{
namespace
{
using HardCase = testing::FitsFolder;
using testing::Cards;

constexpr double kpcPerDegree = 1000 * m83Distance * degree;

/// A round source on the sky, of width sigma = 0.012 degrees.
struct Source
{
  SkyPosition sky;
  double peak;
};

/// A galaxy, face-on and flat, whose picture shows the sources with the given coordinates.
Galaxy galaxyOfSources(const SkyPosition& centre, const ImageDescription& description,
  const Cards& cards, const std::vector<Source>& sources)
{
  RingTable rings = flatDisk(10);
  rings.rings[0].scaleHeight = 0;
  Galaxy input = galaxyOf(rings, { thickLayer(ThicknessModel::Rings) });
  input.description.centre = centre;
  input.description.images = { description };
  input.images[0].cards = testing::header(cards);
  const WorldCoordinates world = coordinatesOf(input.images[0], description);
  for (int k = 0; k < pictureSide * pictureSide; ++k)
  {
    const SkyPosition here =
      testing::sky(world, 1 + k % pictureSide, 1 + static_cast<double>(k / pictureSide));
    double value = 0;
    for (const Source& source : sources)
    {
      const double t = testing::separationArcsec(here, source.sky) / (0.012 * 3600);
      value += source.peak * std::exp(-0.5 * t * t);
    }
    input.images[0].values[k] = value;
  }
  return input;
}

ImageDescription headerDescription()
{
  ImageDescription description;
  description.name = "picture";
  return description;
}

/// Cards of such a picture about a point, North up and East left.
Cards pictureCards(const std::string& projection, const SkyPosition& centre)
{
  Cards cards = testing::simple(projection, 0, 0);
  const std::string size = std::to_string(pictureSide);
  const std::string middle = testing::exact(0.5 * (pictureSide + 1));
  const std::pair<const char*, std::string> changes[] = { { "NAXIS1", size }, { "NAXIS2", size },
    { "CRPIX1", middle }, { "CRPIX2", middle }, { "CRVAL1", testing::exact(centre.ra) },
    { "CRVAL2", testing::exact(centre.dec) }, { "CDELT1", testing::exact(-picturePixel / 3600) },
    { "CDELT2", testing::exact(picturePixel / 3600) } };
  for (const auto& [keyword, value] : changes)
  {
    cards = testing::with(cards, keyword, value);
  }
  return cards;
}

/// The light of a build of its sources and where it is, kpc, after a look at every pixel.
struct Seen
{
  explicit Seen(const Galaxy& input)
  {
    const Particles particles = buildGalaxy(input);
    expectFinite(particles);
    expectPictureKept(input, particles);
    this->light = lightOf(particles);
    for (std::size_t i = 0; i < particles.size(); ++i)
    {
      const auto [p, h, light] = seenFromEarth(particles, i);
      this->middle = this->middle + light / this->light * p;
      this->xy += light / this->light * p.x * p.y;
    }
  }
  double light = 0;
  Vec3 middle = { 0, 0, 0 };
  double xy = 0; ///< mean of X Y
};

const double sourceLight = 2 * pi * std::pow(0.012 * kpcPerDegree, 2);

/// Of a spheroid and nothing else.
std::string spheroidGalaxy(const std::string& name, double ra, double dec, double distance)
{
  return "[galaxy]\nname = \"" + name + "\"\nra = " + std::to_string(ra) +
    "\ndec = " + std::to_string(dec) + "\ndistance = " + std::to_string(distance) +
    "\ninclination = 40\nposition_angle = 70\n[[component]]\nname = \"stars\"\n"
    "type = \"Spheroid\"\nparticles = 2000\n[component.spheroid]\nsigma = [1, 0.8, 0.5]\n";
}

void writeText(const std::string& file, const std::string& text)
{
  std::ofstream(file) << text;
}
} // namespace

TEST_F(HardCase, N11_NegativeAndNaNPixelsAreDark)
{
  for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
  {
    ComponentDescription stars = thickLayer();
    stars.sampling = sampling;
    Galaxy input = galaxyOf(flatDisk(10, 40, 20), { stars });
    const std::size_t middle = (pictureSide + 1) * pictureSide / 2;
    const std::size_t negative[] = { middle, middle + 5, middle - 3 * pictureSide };
    const std::size_t missing[] = { middle + 1, middle - 7, middle + 4 * pictureSide };
    for (int k = 0; k < 3; ++k)
    {
      input.images[0].values[negative[k]] = -0.3;
      input.images[0].values[missing[k]] = NAN;
    }
    const Particles particles = buildGalaxy(input);
    expectFinite(particles);
    expectPictureKept(input, particles);
    const EarthView view(input, particles);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(view.light[negative[k]], 0);
      EXPECT_EQ(view.light[missing[k]], 0);
    }
    EXPECT_GT(view.light[middle + 2], 0);
  }
}

TEST_F(HardCase, N12_BlankPixelsOfIntegersAndBlankImages)
{
  constexpr int blank = -7;
  const auto integers = [&](const std::string& name, bool allBlank) {
    return this->write(name, [&](fitsfile* file, int* status) {
      long axes[2] = { pictureSide, pictureSide };
      fits_create_img(file, SHORT_IMG, 2, axes, status);
      int undefined = blank;
      double scale = 0.001, zero = 0.2;
      fits_write_key(file, TINT, "BLANK", &undefined, nullptr, status);
      fits_write_key(file, TDOUBLE, "BSCALE", &scale, nullptr, status);
      fits_write_key(file, TDOUBLE, "BZERO", &zero, nullptr, status);
      fits_set_bscale(file, 1, 0, status);
      std::vector<int> values(pictureSide * pictureSide);
      for (int k = 0; k < pictureSide * pictureSide; ++k)
      {
        values[k] = allBlank || k % 3 == 0 ? blank : 400;
      }
      fits_write_img(file, TINT, 1, static_cast<LONGLONG>(values.size()), values.data(), status);
    });
  };
  Galaxy input = galaxyOf(flatDisk(10, 40, 20), { thickLayer() });
  input.images[0] = readFitsImage(integers("some.fits", false), {});
  ASSERT_NEAR(input.images[0].values[1], 0.6, 1e-6);
  const Particles some = buildGalaxy(input);
  expectPictureKept(input, some);
  const EarthView view(input, some);
  for (std::size_t k = 0; k < view.light.size(); k += 3)
  {
    EXPECT_EQ(view.light[k], 0);
  }
  input.images[0] = readFitsImage(integers("none.fits", true), {});
  ComponentDescription bulge;
  bulge.type = ComponentType::Spheroid;
  bulge.particles = 100;
  bulge.spheroid.lightFrom = "stars";
  for (const bool clips : { true, false })
  {
    for (const SeedSampling sampling : { SeedSampling::ImageDriven, SeedSampling::SurfaceUniform })
    {
      ComponentDescription stars = thickLayer();
      stars.layers[0].clips = clips;
      stars.sampling = sampling;
      input.description.components = { stars };
      BuildReport report;
      EXPECT_EQ(buildGalaxy(input, {}, &report).size(), 0u);
      EXPECT_EQ(report.components[0].flux, 0);
      stars.automaticCount = true;
      input.description.components = { stars, bulge };
      const Particles dark = buildGalaxy(input);
      expectFinite(dark);
      EXPECT_EQ(lightOf(dark), 0);
    }
  }
}

TEST_F(HardCase, N34_FiveMpcAwayIsTheSameGalaxy)
{
  writeText(this->path("near.galaxy"), spheroidGalaxy("near", 204.25, -29.87, 4.9));
  writeText(this->path("far.galaxy"), spheroidGalaxy("far", 204.25, -29.87, 9.9));
  const Particles group = buildGroup(parseGroupDescription("[group]\nname = \"two\"\n"
                                                           "[[member]]\ngalaxy = \"near.galaxy\"\n"
                                                           "[[member]]\ngalaxy = \"far.galaxy\"\n",
    this->path("two.galaxygroup")));
  BuildOptions options;
  options.seed = 2;
  const Particles alone = buildGalaxy(readGalaxy(this->path("far.galaxy")), options);
  ASSERT_EQ(group.size(), 2 * alone.size());
  double most = 0;
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    const std::size_t k = alone.size() + i;
    const Vec3 moved = positionOf(group, k) - positionOf(alone, i);
    most = std::max(most, length(moved - Vec3{ 0, 0, -5000 }));
    ASSERT_EQ(group.intensity[k], alone.intensity[i]);
    ASSERT_EQ(group.smoothingLength[k], alone.smoothingLength[i]);
  }
  EXPECT_LT(most / 5000, 1e-7); // single precision
  // The way there, in double, is exact.
  const Placement there = placementOf(SkyFrame(m83Centre, 9.9), SkyFrame(m83Centre, 4.9));
  EXPECT_NEAR(length(there.apply({ 1, 2, 3 }) - there.apply({ 4, 0, -2 })), std::sqrt(38.0), 1e-9);
}

TEST_F(HardCase, N35_AnyLieOfTheImageShowsTheSameSky)
{
  const double cosDec = std::cos(m83Centre.dec * degree);
  // 0.04 degrees to the West and 0.02 to the North; 0.01 to the East and 0.05 to the South.
  const std::vector<Source> sources = { { { m83Centre.ra - 0.04 / cosDec, m83Centre.dec + 0.02 },
                                          0.6 },
    { { m83Centre.ra + 0.01 / cosDec, m83Centre.dec - 0.05 }, 0.2 } };
  std::vector<std::pair<ImageDescription, Cards>> lies;
  const Cards plain = pictureCards("TAN", m83Centre);
  lies.emplace_back(headerDescription(), plain);
  lies.emplace_back(
    headerDescription(), testing::with(plain, "CDELT1", testing::exact(picturePixel / 3600)));
  for (const char* projection : { "TAN", "SIN" })
  {
    // CD of a North that is turned by 33 degrees, and mirrored as well.
    for (const double side : { -1.0, 1.0 })
    {
      Cards turned = pictureCards(projection, { m83Centre.ra + 0.01, m83Centre.dec - 0.005 });
      const double step = picturePixel / 3600, c = std::cos(33 * degree), s = std::sin(33 * degree);
      turned = testing::with(turned, "CDELT1", "1");
      turned = testing::with(turned, "CDELT2", "1");
      turned = testing::with(turned, "PC1_1", testing::exact(side * step * c));
      turned = testing::with(turned, "PC1_2", testing::exact(step * s));
      turned = testing::with(turned, "PC2_1", testing::exact(-side * step * s));
      turned = testing::with(turned, "PC2_2", testing::exact(step * c));
      for (auto& [keyword, value] : turned)
      {
        const bool isMatrix = keyword.rfind("PC", 0) == 0;
        keyword = isMatrix ? "CD" + keyword.substr(2) : keyword;
      }
      turned.erase(std::remove_if(turned.begin(), turned.end(),
                     [](const auto& card) { return card.first.rfind("CDELT", 0) == 0; }),
        turned.end());
      lies.emplace_back(headerDescription(), turned);
    }
  }
  ImageDescription supplied = pictureDescription("picture", picturePixel);
  for (const bool mirrored : { false, true })
  {
    supplied.coordinates.mirrored = mirrored;
    supplied.coordinates.positionAngle = mirrored ? 0 : 140;
    lies.emplace_back(supplied, Cards{});
    supplied.coordinates.positionAngle = 75;
    lies.emplace_back(supplied, Cards{});
  }
  for (const auto& [description, cards] : lies)
  {
    const Seen seen(galaxyOfSources(m83Centre, description, cards, sources));
    EXPECT_NEAR(seen.light / (0.8 * sourceLight), 1, 2e-3);
    EXPECT_NEAR(seen.middle.x, (0.75 * 0.04 - 0.25 * 0.01) * kpcPerDegree, 0.02);
    EXPECT_NEAR(seen.middle.y, (0.75 * 0.02 - 0.25 * 0.05) * kpcPerDegree, 0.02);
    EXPECT_NEAR(
      seen.xy, (0.75 * 0.04 * 0.02 + 0.25 * 0.01 * 0.05) * kpcPerDegree * kpcPerDegree, 0.08);
  }
}

TEST_F(HardCase, N36_RightAscensionZeroAndThePoles)
{
  struct Place
  {
    SkyPosition galaxy, image, source;
    double west, north; ///< from galaxy to source, degrees
  };
  const Place places[] = {
    { { 0.01, 0 }, { 359.99, 0 }, { 359.98, 0.03 }, 0.03, 0.03 },
    { { 359.99, 0 }, { 0.01, 0 }, { 0.02, -0.02 }, -0.03, -0.02 },
    { { 0, 0 }, { 360, 0 }, { 359.96, 0 }, 0.04, 0 },
    // Towards the South from 0.01 degrees off the pole, and over the pole to the other side.
    { { 10, 89.99 }, { 10, 89.99 }, { 10, 89.95 }, 0, -0.04 },
    { { 10, 89.99 }, { 190, 89.99 }, { 190, 89.97 }, 0, 0.04 },
    { { 10, -89.99 }, { 190, -89.99 }, { 190, -89.97 }, 0, -0.04 },
    { { 0, 90 }, { 0, 90 }, { 90, 89.96 }, -0.04, 0 },
    { { 0, -90 }, { 120, -89.99 }, { 270, -89.96 }, 0.04, 0 },
  };
  for (const Place& place : places)
  {
    const char* projection = (&place - places) % 2 == 0 ? "TAN" : "SIN";
    const Seen seen(galaxyOfSources(place.galaxy, headerDescription(),
      pictureCards(projection, place.image), { { place.source, 0.7 } }));
    const std::string where =
      std::to_string(place.galaxy.ra) + " " + std::to_string(place.galaxy.dec);
    EXPECT_NEAR(seen.light / (0.7 * sourceLight), 1, 2e-3) << where;
    EXPECT_NEAR(seen.middle.x, place.west * kpcPerDegree, 0.02) << where;
    EXPECT_NEAR(seen.middle.y, place.north * kpcPerDegree, 0.02) << where;
  }
}

TEST_F(HardCase, N42_MagnificationKeepsRelativePositions)
{
  const SkyPosition aside = { 205.0754, -28.8944 };
  writeText(this->path("first.galaxy"), spheroidGalaxy("first", 204.2504, -29.8678, 4.9));
  writeText(this->path("second.galaxy"), spheroidGalaxy("second", aside.ra, aside.dec, 4.35));
  const auto built = [this](double magnification, double separation) {
    GroupDescription group;
    group.file = this->path("two.galaxygroup");
    group.magnification = magnification;
    group.separation = separation;
    group.members = { { "first.galaxy", 1 }, { "second.galaxy", 2 } };
    return buildGroup(group);
  };
  const Particles plain = built(1, 1), large = built(3, 1), close = built(3, 0.5);
  ASSERT_EQ(plain.size(), large.size());
  ASSERT_EQ(plain.size(), close.size());
  const Vec3 second = placementOf(SkyFrame(aside, 4.35), SkyFrame(m83Centre, 4.9)).centre;
  double grown = 0, moved = 0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    const Vec3 centre = i < plain.size() / 2 ? Vec3{ 0, 0, 0 } : second;
    const Vec3 offset = positionOf(plain, i) - centre;
    grown = std::max(grown, length(positionOf(large, i) - centre - 3 * offset));
    moved = std::max(moved, length(positionOf(close, i) - 0.5 * centre - 3 * offset));
    // Surface brightness stays: light as the square of the size.
    ASSERT_NEAR(large.intensity[i] / (9 * plain.intensity[i]), 1, 1e-6);
    ASSERT_NEAR(large.smoothingLength[i] / (3 * plain.smoothingLength[i]), 1, 1e-6);
  }
  EXPECT_GT(length(second), 500);
  EXPECT_LT(grown, 5e-7 * length(second)); // single precision
  EXPECT_LT(moved, 5e-7 * length(second));
}
} // namespace galaxy
