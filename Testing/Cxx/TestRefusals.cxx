// Every number that a file or a user can give: it makes a model of finite numbers, or is refused by
// its name.
#include "Filters/Model/GalaxyBuilder.h"
#include "Filters/Model/GroupBuilder.h"
#include "Readers/Formats/Error.h"
#include "Readers/Formats/GalaxyKeys.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/FitsFixtures.h"
#include "Testing/Cxx/HardCaseFixtures.h"
#include "Testing/Cxx/RefusalFixtures.h"

#include <omp.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <set>

namespace galaxy::testing
{
namespace
{
const char* const extremes[] = { "-1", "0", "nan", "inf", "-inf", "1e300" };

/// A cube of three channels about M83, brighter in the middle, and rings.
class Refusals : public FitsFolder
{
protected:
  void SetUp() override
  {
    FitsFolder::SetUp();
    omp_set_num_threads(1); // many small models, for which threads are more work than they do
    this->write("cube.fits", [](fitsfile* file, int* status) {
      constexpr int side = 24;
      std::vector<double> values;
      for (int k = 0; k < 3 * side * side; ++k)
      {
        const double x = k % side - 11.5, y = k / side % side - 11.5;
        values.push_back((1 + k / (side * side)) * std::exp(-std::hypot(x, y) / 5));
      }
      addImage(file, DOUBLE_IMG, values, status, { side, side, 3 });
      const std::pair<const char*, std::string> texts[] = { { "CTYPE1", "RA---TAN" },
        { "CTYPE2", "DEC--TAN" }, { "CTYPE3", "VRAD" }, { "CUNIT3", "m/s" } };
      for (const auto& [key, text] : texts)
      {
        fits_update_key_str(file, key, text.c_str(), nullptr, status);
      }
      const std::pair<const char*, double> numbers[] = { { "CRVAL1", 204.25 }, { "CRVAL2", -29.87 },
        { "CRVAL3", 5e5 }, { "CRPIX1", 12.5 }, { "CRPIX2", 12.5 }, { "CRPIX3", 1 },
        { "CDELT1", -20. / 3600 }, { "CDELT2", 20. / 3600 }, { "CDELT3", 1e4 } };
      for (const auto& [key, number] : numbers)
      {
        fits_update_key_dbl(file, key, number, 15, nullptr, status);
      }
    });
    std::ofstream(this->path("model.rings")) << "0 100 5 30 40\n200 200 5 40 50\n";
  }

  /// What is wrong with the model of this text, or empty.
  std::string refusalOf(const std::string& text) const
  {
    const std::string file = this->path("scene.galaxy");
    std::ofstream(file) << text;
    return errorOf([&] {
      const Particles particles = buildGalaxy(readGalaxy(file), withVelocities());
      expectFinite(particles);
      for (const ComponentInfo& info : particles.components)
      {
        EXPECT_TRUE(std::isfinite(info.size) && std::isfinite(info.brightness));
        EXPECT_TRUE(std::isfinite(info.absorption[0] + info.absorption[1] + info.absorption[2]));
      }
    });
  }

  std::string refusalOf(const NumericKey& key, std::vector<std::string> numbers) const
  {
    std::string value;
    for (const std::string& number : numbers)
    {
      value += (value.empty() ? "" : ", ") + number;
    }
    Scene scene(key);
    scene.set({ key.section, key.key, key.isList ? "[" + value + "]" : value });
    return this->refusalOf(scene.text());
  }
};

/// Whether a text has the key, or its words.
bool names(const std::string& text, const std::string& key)
{
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  return contains(text, key) || contains(text, words);
}

template <class T>
void addNumeric(const std::string& section, const Keys<T>& keys, std::set<std::string>& known)
{
  for (const Key<T>& key : keys)
  {
    const bool isNumeric = key.type.find("number") != std::string::npos ||
      key.type.find("wavelength") != std::string::npos;
    if (isNumeric)
    {
      known.insert(section + "." + key.name);
    }
  }
}
} // namespace

TEST_F(Refusals, EveryKeyOfANumberIsTried)
{
  std::set<std::string> known, tried;
  addNumeric("galaxy", galaxyKeys(), known);
  addNumeric("image", imageKeys(), known);
  addNumeric("component", componentKeys(), known);
  addNumeric("layers", layerKeys(), known);
  addNumeric("thickness", thicknessKeys(), known);
  addNumeric("dust", dustKeys(), known);
  addNumeric("spheroid", spheroidKeys(), known);
  addNumeric("smoothing", smoothingKeys(), known);
  for (const NumericKey& key : numericKeys())
  {
    tried.insert(key.section.substr(0, key.section.find('.')) + "." + key.key);
  }
  tried.insert("spheroid.light_fraction"); // below, for it needs two components
  EXPECT_EQ(tried, known);
}

TEST_F(Refusals, GoodNumbersMakeAModel)
{
  for (const NumericKey& key : numericKeys())
  {
    EXPECT_EQ(this->refusalOf(key, key.good), "") << key.section << " " << key.key;
  }
}

TEST_F(Refusals, ANumberIsRefusedByItsKeyOrMakesAFiniteModel)
{
  for (const NumericKey& key : numericKeys())
  {
    for (std::size_t place = 0; place < key.good.size(); ++place)
    {
      for (const char* extreme : extremes)
      {
        std::vector<std::string> numbers = key.good;
        numbers[place] = extreme;
        SCOPED_TRACE(key.section + " " + key.key + " = " + extreme);
        const std::string refusal = this->refusalOf(key, numbers);
        EXPECT_TRUE(refusal.empty() || names(refusal, key.key)) << refusal;
        const std::string number = extreme;
        if (number.find("n") != std::string::npos) // nan, inf
        {
          EXPECT_TRUE(contains(refusal, "must be a finite number")) << refusal;
        }
      }
    }
  }
}

TEST_F(Refusals, WholeTurnsOfAPositionAngleChangeNothing)
{
  for (const char* section : { "galaxy", "image.i" })
  {
    NumericKey key{ section, "position_angle", {}, false, {} };
    if (std::string(section) == "image.i")
    {
      key.context = { { "image.i", "ra", "204.25" }, { "image.i", "dec", "-29.87" },
        { "image.i", "pixel_scale", "20" } };
    }
    const auto positions = [&](const std::string& angle) {
      Scene scene(key);
      scene.set({ section, "position_angle", angle });
      scene.set({ "galaxy", "inclination", "50" });
      const std::string file = this->path("scene.galaxy");
      std::ofstream(file) << scene.text();
      return buildGalaxy(readGalaxy(file));
    };
    const Particles turned = positions("40"), more = positions("3640"), less = positions("-320");
    EXPECT_TRUE(equalBits(turned.position, more.position));
    ASSERT_EQ(turned.size(), less.size());
    for (std::size_t i = 0; i < less.position.size(); ++i)
    {
      EXPECT_NEAR(turned.position[i], less.position[i], 1e-4);
    }
  }
}

TEST_F(Refusals, OfLightFraction)
{
  const std::string start = Scene({}).text() +
    "[[component]]\nname = 'bulge'\ntype = 'Spheroid'\nparticles = 20\n"
    "[component.spheroid]\nlight_from = 'all'\nlight_fraction = ";
  EXPECT_EQ(this->refusalOf(start + "0.2"), "");
  for (const char* extreme : extremes)
  {
    const std::string refusal = this->refusalOf(start + extreme);
    EXPECT_EQ(contains(refusal, "light_fraction"), std::string(extreme) != "0") << refusal;
  }
}

TEST_F(Refusals, OfAGroup)
{
  std::ofstream(this->path("scene.galaxy")) << Scene({}).text();
  const auto refusal = [&](const std::string& group, const std::string& member) {
    return errorOf([&] {
      expectFinite(buildGroup(parseGroupDescription(
        "[group]\n" + group + "[[member]]\ngalaxy = 'scene.galaxy'\n" + member,
        this->path("a.galaxygroup"))));
    });
  };
  EXPECT_EQ(refusal("magnification = 2\nseparation = 3\n", "magnification = 0.5\n"), "");
  for (const char* extreme : extremes)
  {
    const std::string end = std::string(" = ") + extreme + "\n";
    EXPECT_TRUE(contains(refusal("magnification" + end, ""), "magnification")) << extreme;
    EXPECT_TRUE(contains(refusal("separation" + end, ""), "separation")) << extreme;
    EXPECT_TRUE(contains(refusal("", "magnification" + end), "magnification")) << extreme;
  }
  // Fine by themselves, too large together.
  EXPECT_TRUE(contains(refusal("magnification = 1e25\n", "magnification = 1e25\n"),
    "scene.galaxy: the place of a particle is no finite number"));
}

TEST_F(Refusals, OfAGroupsProperties)
{
  std::ofstream(this->path("scene.galaxy")) << Scene({}).text();
  GroupDescription group =
    parseGroupDescription("[[member]]\ngalaxy = 'scene.galaxy'\n", this->path("a.galaxygroup"));
  for (const double extreme : { -1.0, 0.0, std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    for (double GroupDescription::*factor :
      { &GroupDescription::magnification, &GroupDescription::separation })
    {
      GroupDescription wrong = group;
      wrong.*factor = extreme;
      EXPECT_THROW(buildGroup(wrong), Error) << extreme;
    }
  }
}

TEST(BuildOptions, AreRefusedByTheirNames)
{
  const Galaxy input = galaxyOf(flatDisk(10), { thickLayer() });
  const auto refusal = [&](const BuildOptions& options) {
    std::string texts;
    for (const bool seedsAlone : { false, true })
    {
      texts += errorOf([&] {
        seedsAlone ? void(buildSeeds(input, "stars", options)) : void(buildGalaxy(input, options));
      });
    }
    return texts;
  };
  for (const double wrong : { -1.0, std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300 })
  {
    BuildOptions options;
    options.particleScale = wrong;
    const std::string text = "hard.galaxy: ParticleScale: must be a finite number, 0 to 1e30";
    EXPECT_EQ(refusal(options), text + text);
    options = {};
    options.viewPixel = wrong;
    EXPECT_TRUE(contains(refusal(options), "ViewPixel: must be a finite number, 0 to 1e30"));
  }
  BuildOptions options;
  options.particleScale = 1e15; // times 5000 particles
  EXPECT_TRUE(contains(refusal(options), "ParticleScale"));
}

// A count that rounds to nothing would take the component's light away.
TEST(BuildOptions, LightHasAtLeastOneParticle)
{
  ComponentDescription stars = thickLayer();
  stars.thickness.children = 1;
  for (const bool automatic : { false, true })
  {
    stars.automaticCount = automatic;
    stars.noise = automatic ? 1e9 : 0.1;
    const Galaxy input = galaxyOf(flatDisk(10), { stars });
    const double whole = lightOf(buildGalaxy(galaxyOf(flatDisk(10), { thickLayer() })));
    for (const double scale : { 1.0, 1e-9 })
    {
      for (const double viewPixel : { 0.0, 1e6 })
      {
        BuildOptions options;
        options.particleScale = scale;
        options.viewPixel = viewPixel;
        BuildReport report;
        const Particles particles = buildGalaxy(input, options, &report);
        EXPECT_GE(report.components[0].seedsDrawn, 1u);
        EXPECT_GE(particles.size(), 1u);
        // A pixel that all others are joined to is a square about the round disc.
        EXPECT_GT(lightOf(particles) / whole, 0.99);
        EXPECT_LT(lightOf(particles) / whole, 1.01 * 4 / pi);
      }
    }
  }
  BuildOptions none;
  none.particleScale = 0;
  BuildReport report;
  EXPECT_EQ(buildGalaxy(galaxyOf(flatDisk(10), { stars }), none, &report).size(), 0u);
  EXPECT_GT(report.components[0].flux, 0); // of which a warning tells
}

TEST(BuildReport, CountsBlankAndNegativePixels)
{
  const auto light = [](double x, double y) { return x * y > 0 ? 0.5 : 0.25; };
  ComponentDescription stars = thickLayer(), both = thickLayer(), gas;
  both.name = "both";
  both.layers.push_back(both.layers[0]); // the same image twice
  both.layers.push_back(both.layers[0]);
  both.layers[2].image = "second";
  Galaxy input = galaxyOf(flatDisk(10), { stars, both }, light);
  input.images.push_back(input.images[0]);
  input.description.images.push_back(pictureDescription("second", picturePixel));
  for (const std::size_t k : { 0, 17, 1800 })
  {
    input.images[0].values[k] = std::nan("");
  }
  for (const std::size_t k : { 5, 1801, 1802, 3599 })
  {
    input.images[0].values[k] = -0.5;
  }
  input.images[1].values[1830] = std::nan("");
  input.images[1].values[0] = -HUGE_VAL;
  BuildReport report;
  const Particles particles = buildGalaxy(input, {}, &report);
  EXPECT_EQ(report.components[0].dark.blank, 3u);
  EXPECT_EQ(report.components[0].dark.negative, 4u);
  EXPECT_EQ(report.components[1].dark.blank, 4u);
  EXPECT_EQ(report.components[1].dark.negative, 5u);
  expectFinite(particles);
}
} // namespace galaxy::testing
