#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using galaxy::GalaxyDescription;
using galaxy::parseGalaxyDescription;
using galaxy::parseGroupDescription;

namespace
{
const std::string least = "[galaxy]\n"
                          "ra = 204.2504\n"
                          "dec = -29.8678\n"
                          "distance = 4.9\n";

const std::string full = R"([galaxy]
name = "M83"
ra = -155.7496
dec = -29.8678
distance = 4.9
rings = "m83.rings"
spin = "clockwise"
interpolation = "SLERP"
beyond_last_ring = "HoldLast"
mock = true
credit = "someone"

[image.zulu]
file = "z.fits"
hdu = 2
plane = 3
background = "auto"
mask_stars_above = 5

[image.alpha]
file = "a.fits"
extension = "SCI"
ra = 204
dec = -30
pixel_scale = 1.5
position_angle = 12
mirrored = true
reference_pixel = [3, 4.5]
background = -0.25

[[component]]
name = "stars"
particles = 2e6
color = [1, 0.5, 0.25]
inner_radius = 1
outer_radius = 9
smoothing_length = 0.1
size = 2
brightness = 3
layers = [
  { image = "zulu", color = [0, 1, 2], weight = 0.5, clip = [1, 9], threshold = 0.1, stretch = "asinh" },
  { image = "alpha" },
]
[component.thickness]
model = "Flared"
law = "Box"
children = 2.5
maximum_children = 7
fwhm_edge = 1.25
taper_thickness = true

[[component]]
name = "dust"
role = "Absorbs"
profile = "Exponential"
scale_length = 2
optical_depth = 0.7
absorption = [0.5, 1, 2]
[component.dust]
model = "RingVelocity"
steps = 12
damping_time = 3

[[component]]
name = "bulge"
type = "Spheroid"
particles = 10
[component.spheroid]
sigma = [1, 2, 3]
tilted = false
central_brightness = 4
)";

std::string messageOf(const std::string& text)
{
  return galaxy::errorOf([&] { parseGalaxyDescription(text, "some.galaxy"); });
}

std::string groupMessageOf(const std::string& text)
{
  return galaxy::errorOf([&] { parseGroupDescription(text, "some.galaxygroup"); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}
} // namespace

TEST(GalaxyDescription, LeastFileHasTheStructsDefaults)
{
  const GalaxyDescription galaxy = parseGalaxyDescription(least, "folder/some.galaxy");
  EXPECT_EQ(galaxy.name, "some");
  EXPECT_EQ(galaxy.centre.dec, -29.8678);
  EXPECT_EQ(galaxy.radius, GalaxyDescription().radius);
  EXPECT_EQ(galaxy.spin, galaxy::SpinSense::FromCode);
  EXPECT_TRUE(galaxy.images.empty() && galaxy.components.empty());
}

TEST(GalaxyDescription, GalaxyAndImages)
{
  const GalaxyDescription galaxy = parseGalaxyDescription(full, "some.galaxy");
  EXPECT_EQ(galaxy.name, "M83");
  EXPECT_NEAR(galaxy.centre.ra, 204.2504, 1e-12) << "wrapped";
  EXPECT_EQ(galaxy.spin, galaxy::SpinSense::Clockwise);
  EXPECT_EQ(galaxy.interpolation, galaxy::RingInterpolation::Slerp);
  EXPECT_EQ(galaxy.beyondLastRing, galaxy::BeyondLastRing::HoldLast);
  EXPECT_TRUE(galaxy.mock);
  ASSERT_EQ(galaxy.images.size(), 2u);
  const galaxy::ImageDescription& zulu = galaxy.images[0];
  EXPECT_EQ(zulu.name, "zulu") << "in the order of the file";
  EXPECT_EQ(zulu.selection.hdu, 2);
  EXPECT_EQ(zulu.selection.plane, 3);
  EXPECT_TRUE(zulu.automaticBackground);
  EXPECT_EQ(zulu.maskStarsAbove, 5);
  EXPECT_FALSE(zulu.suppliesCoordinates);
  const galaxy::ImageDescription& alpha = galaxy.images[1];
  EXPECT_EQ(alpha.selection.extension, "SCI");
  EXPECT_EQ(alpha.selection.hdu, -1);
  EXPECT_TRUE(alpha.suppliesCoordinates);
  EXPECT_EQ(alpha.coordinates.centre.ra, 204);
  EXPECT_EQ(alpha.coordinates.pixelScale, 1.5);
  EXPECT_EQ(alpha.coordinates.positionAngle, 12);
  EXPECT_TRUE(alpha.coordinates.mirrored);
  EXPECT_EQ(alpha.coordinates.pixel.y, 4.5);
  EXPECT_EQ(alpha.background, -0.25);
  EXPECT_FALSE(alpha.automaticBackground);
  EXPECT_TRUE(std::isinf(alpha.maskStarsAbove));
}

TEST(GalaxyDescription, Components)
{
  const GalaxyDescription galaxy = parseGalaxyDescription(full, "some.galaxy");
  ASSERT_EQ(galaxy.components.size(), 3u);
  const galaxy::ComponentDescription& stars = galaxy.components[0];
  EXPECT_EQ(stars.particles, 2000000);
  EXPECT_EQ(stars.color[1], 0.5);
  EXPECT_EQ(stars.innerRadius, 1);
  EXPECT_EQ(stars.outerRadius, 9);
  ASSERT_EQ(stars.layers.size(), 2u);
  EXPECT_EQ(stars.layers[0].color[2], 2);
  EXPECT_TRUE(stars.layers[0].clips);
  EXPECT_EQ(stars.layers[0].clip[1], 9);
  EXPECT_EQ(stars.layers[0].stretch, galaxy::IntensityStretch::Asinh);
  EXPECT_FALSE(stars.layers[1].clips);
  EXPECT_EQ(stars.thickness.model, galaxy::ThicknessModel::Flared);
  EXPECT_EQ(stars.thickness.law, galaxy::LayerLaw::Box);
  EXPECT_EQ(stars.thickness.maximumChildren, 7);
  EXPECT_EQ(stars.thickness.fwhmEdge, 1.25);
  EXPECT_TRUE(stars.thickness.taperThickness);
  EXPECT_FALSE(stars.hasDust);
  const galaxy::ComponentDescription& dust = galaxy.components[1];
  EXPECT_TRUE(dust.hasDust);
  EXPECT_EQ(dust.role, galaxy::ComponentRole::Absorbs);
  EXPECT_EQ(dust.profile, galaxy::DiskProfile::Exponential);
  EXPECT_EQ(dust.absorption[2], 2);
  EXPECT_EQ(dust.dust.model, galaxy::DustModel::RingVelocity);
  EXPECT_EQ(dust.dust.steps, 12);
  EXPECT_EQ(galaxy.components[2].type, galaxy::ComponentType::Spheroid);
  EXPECT_EQ(galaxy.components[2].spheroid.sigma[2], 3);
  EXPECT_FALSE(galaxy.components[2].spheroid.tilted);
}

TEST(GalaxyDescription, UnknownKeySuggestsTheNearest)
{
  EXPECT_EQ(messageOf(least + "distanse = 3\n"),
    "some.galaxy: line 5: distanse: unknown key of [galaxy]; did you mean `distance`?");
  EXPECT_EQ(messageOf(replaced(full, "fwhm_edge", "fwhm_egde")),
    "some.galaxy: line 49: fwhm_egde: unknown key of [component.thickness]; did you mean "
    "`fwhm_edge`?");
  EXPECT_EQ(messageOf(least + "[[components]]\n"),
    "some.galaxy: line 5: components: unknown key; did you mean `component`?");
  EXPECT_NE(
    messageOf(least + "[xyzzy]\n").find("use one of galaxy, image, component"), std::string::npos);
  EXPECT_EQ(messageOf(replaced(full, "\"asinh\"", "\"asin\"")),
    "some.galaxy: line 41: stretch: must be one of Linear, Sqrt, Asinh, Density, Log, not 'asin'; "
    "did you mean `Asinh`?");
}

TEST(GalaxyDescription, PreparedAndCombinedImages)
{
  const std::string images = least +
    "[image.high]\nfile = \"h.fits\"\nmask = \"m.fits\"\nregions = \"s.reg\"\nbeam = 15\n"
    "[image.low]\nfile = \"l.fits\"\n"
    "[image.hi]\ncombine = [\"high\", \"low\"]\nsignal_above = 3\n";
  const GalaxyDescription galaxy = parseGalaxyDescription(images, "some.galaxy");
  EXPECT_EQ(galaxy.images[0].mask, "m.fits");
  EXPECT_EQ(galaxy.images[0].regions, "s.reg");
  EXPECT_EQ(galaxy.images[0].beam, 15);
  EXPECT_TRUE(std::isnan(galaxy.images[0].signalAbove));
  EXPECT_EQ(galaxy.images[2].combine, (std::vector<std::string>{ "high", "low" }));
  EXPECT_EQ(galaxy.images[2].signalAbove, 3);
  EXPECT_EQ(messageOf(replaced(images, "\"high\", ", "\"hihg\", ")),
    "some.galaxy: line 13: combine: there is no [image.hihg] with a file; did you mean `high`?");
  EXPECT_EQ(messageOf(replaced(images, "\"high\", ", "")),
    "some.galaxy: line 13: combine: must be a list of 2 or more images' names, the sharpest first");
  EXPECT_EQ(messageOf(replaced(images, "signal_above = 3", "background = 3")),
    "some.galaxy: line 14: background: has no place beside combine; give it to the images "
    "combined");
  EXPECT_EQ(messageOf(replaced(images, "beam = 15", "signal_above = 3")),
    "some.galaxy: line 9: signal_above: needs combine; give it, or leave signal_above out");
  EXPECT_EQ(messageOf(replaced(full, "clip = [1, 9]", "clip = [1, 9], clip_percentile = [1, 9]")),
    "some.galaxy: line 41: clip_percentile: contradicts clip; give one or the other");
  EXPECT_EQ(messageOf(replaced(full, "clip = [1, 9]", "clip_percentile = [1, 101]")),
    "some.galaxy: line 41: clip_percentile: must be 0 to 100");
}

TEST(GalaxyDescription, WrongTypeOrRange)
{
  const auto expectAt = [](
                          const std::string& from, const std::string& to, const std::string& what) {
    EXPECT_EQ(messageOf(replaced(full, from, to)), "some.galaxy: line " + what);
  };
  expectAt("ra = -155.7496", "ra = \"13h37m\"", "3: ra: must be a number");
  expectAt("ra = -155.7496", "ra = 1000", "3: ra: must be -360 to 720");
  expectAt("dec = -29.8678", "dec = -90.5", "4: dec: must be -90 to 90");
  expectAt("dec = -29.8678", "dec = nan", "4: dec: must be a finite number");
  expectAt("distance = 4.9", "distance = 0", "5: distance: must be greater than 0");
  expectAt("distance = 4.9", "distance = inf", "5: distance: must be a finite number");
  expectAt("distance = 4.9", "distance = 1e300", "5: distance: must be at most 1e+30");
  expectAt("mock = true", "mock = 1", "10: mock: must be true or false");
  expectAt("credit = \"someone\"", "credit = 7", "11: credit: must be a text in quotes");
  expectAt("background = \"auto\"", "background = \"none\"",
    "17: background: must be a number or \"Auto\"");
  expectAt("pixel_scale = 1.5", "pixel_scale = -1", "25: pixel_scale: must be greater than 0");
  expectAt("[3, 4.5]", "[3]", "28: reference_pixel: must be a list of 2 numbers");
  expectAt("particles = 2e6", "particles = -1", "33: particles: must be 0 to 1099511627776");
  expectAt("particles = 2e6", "particles = 1.5", "33: particles: must be a whole number");
  expectAt("[1, 0.5, 0.25]", "[1, -0.5, 0.25]", "34: color: must be at least 0");
  expectAt(
    "clip = [1, 9]", "clip = [9, 9]", "41: clip: the second value must be greater than the first");
  expectAt(
    "outer_radius = 9", "outer_radius = 1", "36: outer_radius: must be greater than inner_radius");
  expectAt("model = \"Flared\"", "compression = 1.01", "45: compression: must be 0 to 1");
  expectAt("steps = 12", "steps = 0", "61: steps: must be 1 to 2147483647");
  expectAt("damping_time = 3", "damping_time = 0", "62: damping_time: must be greater than 0");
}

TEST(GalaxyDescription, MissingAndContradicting)
{
  EXPECT_EQ(messageOf(""), "some.galaxy: galaxy: missing; add a section [galaxy]");
  EXPECT_EQ(messageOf("[galaxy]\nra = 1\ndec = 2\n"),
    "some.galaxy: line 1: distance: missing in [galaxy]; give a number greater than 0, Mpc");
  EXPECT_EQ(messageOf(replaced(full, "file = \"a.fits\"\n", "")),
    "some.galaxy: line 20: file: missing in [image.alpha]; give a FITS file");
  EXPECT_EQ(messageOf(replaced(full, "dec = -30\n", "")),
    "some.galaxy: line 20: dec: missing in [image.alpha]; give a number, degrees");
  EXPECT_EQ(messageOf(replaced(full, "pixel_scale = 1.5\n", "")),
    "some.galaxy: line 23: ra: needs pixel_scale; give it, or leave ra out");
  EXPECT_EQ(messageOf(replaced(full, "mock = true", "radius = 3")),
    "some.galaxy: line 10: radius: contradicts rings; give one or the other");
  EXPECT_EQ(messageOf(replaced(full, "\"alpha\" }", "\"alfa\" }")),
    "some.galaxy: line 42: image: there is no [image.alfa]; did you mean `alpha`?");
  EXPECT_EQ(messageOf(replaced(full, "\"bulge\"", "\"dust\"")),
    "some.galaxy: line 65: name: there is another component 'dust'; give each its own name");
  EXPECT_EQ(messageOf(least + "[[component]]\nname = \"bare\"\n"),
    "some.galaxy: line 5: layers: missing; give a disk layers, or profile = \"Exponential\"");
}

TEST(GalaxyDescription, NoMoreComponentsThanAByteCounts)
{
  std::string text = least;
  for (int i = 0; i < 256; ++i)
  {
    text += "[[component]]\ntype = \"Spheroid\"\nname = \"" + std::to_string(i) + "\"\n";
  }
  EXPECT_EQ(messageOf(text), "");
  EXPECT_EQ(messageOf(text + "[[component]]\n"),
    "some.galaxy: line 773: component: more than 256 components; leave some out");
}

TEST(GalaxyDescription, BrokenToml)
{
  EXPECT_EQ(messageOf(least + "= 3\n").find("some.galaxy: line 5: "), 0u);
  EXPECT_EQ(messageOf("galaxy = 3\n"), "some.galaxy: line 1: galaxy: must be a section, [galaxy]");
  EXPECT_EQ(messageOf(least + "[component]\nname = \"x\"\n"),
    "some.galaxy: line 5: component: must be a list of sections, each headed [[component]]");
}

TEST(GroupDescription, MembersAndErrors)
{
  const std::string member = "[[member]]\ngalaxy = \"a.galaxy\"\n";
  const galaxy::GroupDescription group = parseGroupDescription(
    "[group]\nmagnification = 20\nseparation = 0.5\n" + member + member + "magnification = 2\n",
    "some.galaxygroup");
  EXPECT_EQ(group.name, "some");
  EXPECT_EQ(group.magnification, 20);
  EXPECT_EQ(group.separation, 0.5);
  ASSERT_EQ(group.members.size(), 2u);
  EXPECT_EQ(group.members[0].magnification, 1);
  EXPECT_EQ(group.members[1].magnification, 2);
  EXPECT_EQ(groupMessageOf(member), "");
  const std::string none =
    "some.galaxygroup: member: missing; add a section [[member]] for every galaxy";
  EXPECT_EQ(groupMessageOf(""), none);
  EXPECT_EQ(groupMessageOf("member = []\n"), none);
  EXPECT_EQ(groupMessageOf("[[member]]\n"),
    "some.galaxygroup: line 1: galaxy: missing in [[member]]; give a text");
  EXPECT_EQ(groupMessageOf(member + "magnify = 2\n"),
    "some.galaxygroup: line 3: magnify: unknown key of [[member]]; use one of galaxy, "
    "magnification");
}

TEST(Rings, FlatDiscHasTheRadiusInArcsec)
{
  const galaxy::RingTable table = readRings(parseGalaxyDescription(
    least + "radius = 20\ninclination = 24\nposition_angle = 226\nrotation_velocity = 170\n",
    "some.galaxy"));
  ASSERT_EQ(table.rings.size(), 2u);
  EXPECT_EQ(table.rings[0].radius, 0);
  EXPECT_NEAR(std::tan(table.rings[1].radius / 3600 * std::acos(-1.0) / 180) * 4900, 20, 1e-3);
  for (const galaxy::Ring& ring : table.rings)
  {
    EXPECT_EQ(ring.inclination, 24);
    EXPECT_EQ(ring.positionAngle, 226);
    EXPECT_EQ(ring.rotationVelocity, 170);
  }
}

TEST(Rings, FileBesideTheDescription)
{
  std::string name = (std::filesystem::temp_directory_path() / "galaxy-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  const std::filesystem::path folder = name;
  std::ofstream(folder / "m83.rings") << "0 1 2 3 4\n5 6 7 8 9\n";
  std::ofstream(folder / "m83.galaxy") << full;
  const std::string file = (folder / "m83.galaxy").string();
  EXPECT_EQ(readRings(galaxy::readGalaxyDescription(file)).rings[1].positionAngle, 9);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(galaxy::readGalaxyDescription(file), galaxy::Error);
}

TEST(BesideFile, RelativeAndAbsolute)
{
  EXPECT_EQ(galaxy::besideFile("a/b.galaxy", "c/d.fits"), "a/c/d.fits");
  EXPECT_EQ(galaxy::besideFile("b.galaxy", "d.fits"), "d.fits");
  EXPECT_EQ(galaxy::besideFile("a/b.galaxy", "/d.fits"), "/d.fits");
}
