#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/SpheroidTables.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace galaxy
{
namespace
{
const std::string head = "[galaxy]\nra = 204.2504\ndec = -29.8678\ndistance = 4.9\n"
                         "[image.r]\nfile = \"r.fits\"\n"
                         "[[component]]\nname = \"stars\"\nlayers = [ { image = \"r\" } ]\n"
                         "[[component]]\nname = \"bulge\"\ntype = \"Spheroid\"\n"
                         "[component.spheroid]\n";

SpheroidDescription parsed(const std::string& keys)
{
  return parseGalaxyDescription(head + keys, "some.galaxy").components[1].spheroid;
}

std::string messageOfKeys(const std::string& keys)
{
  return errorOf([&] { parsed(keys); });
}

/// A text file that lives as long as this.
class TextFile
{
public:
  explicit TextFile(const std::string& text)
    : path((std::filesystem::path(testing::TempDir()) /
        (std::string("spheroid-") + testing::UnitTest::GetInstance()->current_test_info()->name() +
          ".csv"))
             .string())
  {
    std::ofstream(this->path) << text;
  }
  ~TextFile() { std::filesystem::remove(this->path); }

  const std::string path;
};

constexpr SkyPosition centre = { 204.2504, -29.8678 };

std::vector<StarCluster> clustersOf(const std::string& text)
{
  return parseClusterList(text, "clusters.txt", centre, 4.9);
}

std::vector<EllipsoidShell> shellsOf(const std::string& text)
{
  return parseEllipsoidShells(text, "shells.txt");
}
} // namespace

TEST(SpheroidKeys, AllAreRead)
{
  const SpheroidDescription s =
    parsed("profile = \"Cored\"\nscale_radius = 1.5\nslope = 4\ntruncation = 30\naxis_ratios = "
           "[0.9, 0.5]\n"
           "position_angle = 40\ninclination = -20\nluminosity = 12\nlight_from = \"stars\"\n"
           "light_fraction = 0.2\nclusters = 150\ncluster_radius = 0.01\n");
  EXPECT_EQ(s.profile, SpheroidProfile::Cored);
  EXPECT_EQ(s.scaleRadius, 1.5);
  EXPECT_EQ(s.slope, 4);
  EXPECT_EQ(s.truncation, 30);
  EXPECT_EQ(s.axisRatios[1], 0.5);
  EXPECT_TRUE(s.oriented);
  EXPECT_EQ(s.positionAngle, 40);
  EXPECT_EQ(s.inclination, -20);
  EXPECT_EQ(s.luminosity, 12);
  EXPECT_EQ(s.lightFrom, "stars");
  EXPECT_EQ(s.lightFraction, 0.2);
  EXPECT_EQ(s.clusters, 150);
  EXPECT_EQ(s.clusterRadius, 0.01);
  const SpheroidDescription sersic =
    parsed("profile = \"sersic\"\neffective_radius = 0.3\nsersic_index = 1.3\n");
  EXPECT_EQ(sersic.effectiveRadius, 0.3);
  EXPECT_EQ(sersic.sersicIndex, 1.3);
  EXPECT_FALSE(sersic.oriented);
  EXPECT_TRUE(std::isnan(sersic.luminosity));
  EXPECT_EQ(parsed("profile = \"NFW\"\nconcentration = 7\n").concentration, 7);
}

TEST(SpheroidKeys, OutOfRangeIsRefusedByName)
{
  const std::vector<std::pair<std::string, std::string>> refused = {
    { "", "preset = \"Blob\"" },
    { "", "profile = \"King\"" },
    { "", "sigma = [1, 1, 0]" },
    { "Sersic", "effective_radius = 0" },
    { "Sersic", "sersic_index = 0.4" },
    { "Sersic", "sersic_index = 10.5" },
    { "Plummer", "scale_radius = -1" },
    { "Cored", "slope = 3" },
    { "Cored", "slope = 21" },
    { "NFW", "concentration = 0" },
    { "NFW", "concentration = inf" },
    { "", "truncation = 0" },
    { "", "truncation = nan" },
    { "NFW", "truncation = 1e-6" },
    { "Plummer", "axis_ratios = [0, 1]" },
    { "Plummer", "axis_ratios = [1, 1.1]" },
    { "Plummer", "axis_ratios = [1]" },
    { "", "tilted = 1" },
    { "", "position_angle = inf" },
    { "", "inclination = 181" },
    { "", "central_brightness = -1" },
    { "", "luminosity = -1" },
    { "", "light_from = \"bulge\"" },
    { "", "light_from = \"star\"" },
    { "", "light_fraction = 0.1" },
    { "", "clusters = -1" },
    { "", "clusters = 1.5" },
    { "", "cluster_radius = 0" },
    { "", "cluster_list = 3" },
    { "", "shells = false" },
    { "", "radius = 1" },
  };
  for (const auto& [profile, line] : refused)
  {
    const std::string key = line.substr(0, line.find(' '));
    const std::string message =
      messageOfKeys((profile.empty() ? "" : "profile = \"" + profile + "\"\n") + line + "\n");
    EXPECT_NE(message.find(key), std::string::npos) << line << " gave: " << message;
    EXPECT_EQ(message.find("some.galaxy: line "), 0u) << line << " gave: " << message;
  }
  const std::string message = messageOfKeys("light_from = \"stars\"\nlight_fraction = 1.1\n");
  EXPECT_NE(message.find("light_fraction"), std::string::npos) << message;
  EXPECT_NE(
    messageOfKeys("light_from = \"star\"\n").find("did you mean `stars`?"), std::string::npos);
}

TEST(SpheroidKeys, ContradictionsAreRefused)
{
  const std::vector<std::pair<std::string, std::string>> refused = {
    { "effective_radius", "effective_radius = 1" },
    { "scale_radius", "scale_radius = 1" },
    { "axis_ratios", "axis_ratios = [1, 1]" },
    { "concentration", "concentration = 3" },
    { "slope", "profile = \"NFW\"\nslope = 4" },
    { "sigma", "profile = \"NFW\"\nsigma = [1, 1, 1]" },
    { "position_angle", "tilted = true\nposition_angle = 3" },
    { "inclination", "tilted = false\ninclination = 3" },
    { "shells", "tilted = false\nshells = \"a.csv\"" },
    { "axis_ratios", "profile = \"NFW\"\naxis_ratios = [1, 1]\nshells = \"a.csv\"" },
    { "inclination", "inclination = 3\nshells = \"a.csv\"" },
    { "central_brightness", "luminosity = 1\ncentral_brightness = 1" },
    { "cluster_list", "clusters = 1\ncluster_list = \"a.csv\"" },
    { "cluster_list", "cluster_list = \"a.csv\"" },
  };
  for (const auto& [key, lines] : refused)
  {
    EXPECT_NE(messageOfKeys(lines + "\n").find(": " + key + ": "), std::string::npos) << lines;
  }
}

TEST(SpheroidKeys, LightIsTakenFromTheLayersOfAnEmittingDiskOnly)
{
  const auto messageOfDisk = [](const std::string& keys) {
    std::string text = head + "light_from = \"stars\"\n";
    text.insert(text.find("layers = "), keys);
    return errorOf([&] { parseGalaxyDescription(text, "some.galaxy"); });
  };
  EXPECT_EQ(messageOfDisk(""), "");
  for (const char* keys :
    { "profile = \"Exponential\"\n", "role = \"Absorbs\"\n", "type = \"Spheroid\"\n" })
  {
    const std::string message = messageOfDisk(keys);
    EXPECT_NE(message.find(": light_from: there is no component 'stars'"), std::string::npos)
      << keys << message;
  }
}

TEST(SpheroidKeys, DescriptionsOutOfRangeAreRefusedByName)
{
  const double nan = std::nan("");
  const auto expectRefused = [](const char* name, const auto& change) {
    SpheroidDescription spheroid;
    requireInRange(spheroid, "some.galaxy", "bulge");
    change(spheroid);
    const std::string message = errorOf([&] { requireInRange(spheroid, "some.galaxy", "bulge"); });
    EXPECT_EQ(message.find(std::string("some.galaxy: bulge: spheroid: ") + name + " must be "), 0u)
      << message;
  };
  using S = SpheroidDescription;
  expectRefused("profile", [](S& s) { s.profile = static_cast<SpheroidProfile>(7); });
  expectRefused("sigma", [](S& s) { s.sigma[1] = -1; });
  expectRefused("effective_radius", [=](S& s) { s.effectiveRadius = nan; });
  expectRefused("sersic_index", [](S& s) { s.sersicIndex = 11; });
  expectRefused("scale_radius", [](S& s) { s.scaleRadius = 0; });
  expectRefused("slope", [](S& s) { s.slope = 3; });
  expectRefused("concentration", [](S& s) { s.concentration = 0; });
  expectRefused("truncation", [=](S& s) { s.truncation = nan; });
  expectRefused("truncation", [](S& s) { s.truncation = -1; });
  expectRefused("axis_ratios", [](S& s) { s.axisRatios[0] = -0.5; });
  expectRefused("axis_ratios", [](S& s) { s.axisRatios[1] = 0; });
  expectRefused("position_angle", [=](S& s) { s.positionAngle = nan; });
  expectRefused("inclination", [](S& s) { s.inclination = 200; });
  expectRefused("central_brightness", [](S& s) { s.centralBrightness = -1; });
  expectRefused("luminosity", [](S& s) { s.luminosity = -1; });
  expectRefused("light_fraction", [](S& s) { s.lightFraction = 1.5; });
  expectRefused("clusters", [](S& s) { s.clusters = -1; });
  expectRefused("cluster_radius", [](S& s) { s.clusterRadius = 0; });
}

TEST(SpheroidKeys, PresetsAreOverriddenInAnyOrder)
{
  for (const char* keys :
    { "preset = \"Bulge\"\nsersic_index = 3\n", "sersic_index = 3\npreset = \"Bulge\"\n" })
  {
    const SpheroidDescription s = parsed(keys);
    EXPECT_EQ(s.preset, SpheroidPreset::Bulge);
    EXPECT_EQ(s.profile, SpheroidProfile::Sersic);
    EXPECT_EQ(s.sersicIndex, 3);
    EXPECT_EQ(s.effectiveRadius, 0.7) << "the preset's";
  }
  const std::vector<std::pair<std::string, SpheroidProfile>> presets = {
    { "None", SpheroidProfile::Gaussian }, { "Bulge", SpheroidProfile::Sersic },
    { "StellarHalo", SpheroidProfile::Cored }, { "DarkHalo", SpheroidProfile::NFW },
    { "Elliptical", SpheroidProfile::Sersic }, { "DwarfSpheroidal", SpheroidProfile::Plummer },
    { "DwarfElliptical", SpheroidProfile::Sersic },
    { "DwarfIrregular", SpheroidProfile::Exponential }
  };
  for (const auto& [name, profile] : presets)
  {
    EXPECT_EQ(parsed("preset = \"" + name + "\"\n").profile, profile) << name;
  }
}

TEST(SpheroidKeys, EveryProfileEndsSomewhere)
{
  EXPECT_EQ(parsed("sigma = [2, 1, 1]\n").truncation, 10);
  EXPECT_EQ(parsed("profile = \"Sersic\"\neffective_radius = 0.5\n").truncation, 10);
  EXPECT_EQ(parsed("profile = \"Hernquist\"\nscale_radius = 0.5\n").truncation, 20);
  EXPECT_EQ(parsed("profile = \"Exponential\"\nscale_radius = 2\n").truncation, 30);
  EXPECT_EQ(parsed("profile = \"Plummer\"\nscale_radius = 2\n").truncation, 40);
  EXPECT_EQ(parsed("profile = \"Plummer\"\ntruncation = 7\n").truncation, 7);
  EXPECT_EQ(parsed("preset = \"StellarHalo\"\n").truncation, 100);
  EXPECT_EQ(parsed("preset = \"Elliptical\"\n").truncation, 100);
  for (const char* profile : { "NFW", "Cored" })
  {
    const SpheroidDescription s = parsed("profile = \"" + std::string(profile) + "\"\n");
    EXPECT_TRUE(std::isinf(s.truncation)) << "its concentration ends it";
  }
}

TEST(SpheroidKeys, ListsStandBesideTheDescription)
{
  const TextFile file("x,y,z\n1,2,3\n");
  const std::filesystem::path path(file.path);
  const GalaxyDescription galaxy = parseGalaxyDescription(
    head + "luminosity = 3\ncluster_list = \"" + path.filename().string() + "\"\n",
    (path.parent_path() / "some.galaxy").string());
  ASSERT_EQ(galaxy.components[1].spheroid.listed.size(), 1u);
  EXPECT_EQ(galaxy.components[1].spheroid.listed[0].position.y, 2);
  EXPECT_NE(messageOfKeys("shells = \"absent.csv\"\n").find("absent.csv"), std::string::npos);
}

TEST(SpheroidKeys, TablesTravelWithTheDescription)
{
  TextFile file("x,y,z\n1,2,3\n");
  const std::filesystem::path path(file.path);
  const std::string text =
    head + "luminosity = 3\ncluster_list = \"" + path.filename().string() + "\"\n";
  const std::string galaxy = (path.parent_path() / "some.galaxy").string();
  const GalaxyDescription read = parseGalaxyDescription(text, galaxy);
  std::filesystem::remove(path);
  const GalaxyDescription again = parseGalaxyDescription(read.text, galaxy, read.tables);
  ASSERT_EQ(again.components[1].spheroid.listed.size(), 1u);
  EXPECT_EQ(again.components[1].spheroid.listed[0].position.z, 3);
  const std::string message =
    errorOf([&] { parseGalaxyDescription(read.text, galaxy, NamedTexts{}); });
  EXPECT_NE(message.find(path.filename().string()), std::string::npos) << message;
}

TEST(SpheroidKeys, ClusterListInTheGalaxysFrame)
{
  const std::vector<StarCluster> clusters =
    clustersOf("# made up\nName, X, Y, Z, Luminosity, radius\n"
               "M54, 1, 2, -3.5, 10, 0.01 # far\n\nM2, 0, 0, 1e1, 2, 0.02\n");
  ASSERT_EQ(clusters.size(), 2u);
  EXPECT_EQ(clusters[0].position.x, 1);
  EXPECT_EQ(clusters[0].position.z, -3.5);
  EXPECT_EQ(clusters[0].luminosity, 10);
  EXPECT_EQ(clusters[1].position.z, 10);
  EXPECT_EQ(clusters[1].radius, 0.02);
  EXPECT_EQ(clustersOf("x y z\n1 2 3\n")[0].luminosity, 1);
}

TEST(SpheroidKeys, ClusterListOnTheSky)
{
  const double degree = 3.14159265358979323846 / 180;
  // 0.1 degrees to the South: 8.55 kpc in the plane of the sky.
  const StarCluster south = clustersOf("ra,dec\n204.2504,-29.9678\n")[0];
  EXPECT_NEAR(south.position.x, 0, 1e-9);
  EXPECT_NEAR(south.position.y, -4900 * std::tan(0.1 * degree), 1e-9);
  EXPECT_EQ(south.position.z, 0);
  // 20 kpc in front of the centre.
  const StarCluster front = clustersOf("ra,dec,distance\n204.2504,-29.8678,4.88\n")[0];
  EXPECT_NEAR(front.position.z, 20, 1e-9);
  // To the East, at the distance of the galaxy: on the sphere about us.
  const StarCluster east = clustersOf("ra,dec,distance\n204.5,-29.8678,4.9\n")[0];
  EXPECT_LT(east.position.x, -18);
  EXPECT_NEAR(std::hypot(east.position.x, east.position.y, 4900 - east.position.z), 4900, 1e-9);
}

TEST(SpheroidKeys, ErrorsOfListsNameTheLine)
{
  const std::vector<std::pair<std::string, std::string>> refused = {
    { "x,y,z\n1,2,3\n1,2\n", "line 3: has 2 columns, must have 3" },
    { "x,y,z\n\n1,b,3\n", "line 3: y must be a finite number, not 'b'" },
    { "x,y\n1,2\n", "the heading must name a column z" },
    { "a,b\n1,2\n", "the heading must name a column ra" },
    { "x,y,z\n", "must hold rows" },
    { "", "must hold rows" },
    { "ra,dec\n10,91\n", "line 2: dec must be -90 to 90" },
    { "ra,dec\n24.2504,29.8678\n", "line 2: ra, dec must lie less than 90 degrees" },
    { "ra,dec,distance\n204,-29,0\n", "line 2: distance must be greater than 0" },
    { "x,y,z,luminosity\n1,2,3,-1\n", "line 2: luminosity must be at least 0" },
    { "x,y,z,luminosity\n1,2,3,0\n", "luminosity: the sum must be greater than 0" },
    { "x,y,z,radius\n1,2,3,0\n", "line 2: radius must be greater than 0" },
  };
  for (const auto& [text, expected] : refused)
  {
    const std::string message = errorOf([&text = text] { clustersOf(text); });
    EXPECT_NE(message.find(expected), std::string::npos) << text << " gave: " << message;
    EXPECT_NE(message.find("clusters.txt"), std::string::npos) << "the file";
  }
}

TEST(SpheroidKeys, ShellsTakeTheShorterWay)
{
  const std::string heading = "semi_major,axis_ratio_b,axis_ratio_c,position_angle";
  const auto flat = shellsOf(heading + "\n0,1,0.9,170\n2,0.8,0.7,10\n");
  ASSERT_EQ(flat.size(), 2u);
  EXPECT_EQ(flat[1].semiMajor, 2);
  EXPECT_EQ(flat[1].axisRatios[1], 0.7);
  EXPECT_EQ(flat[1].positionAngle, 190) << "an axis comes back after half a turn";
  EXPECT_EQ(flat[1].inclination, 0);
  const auto inclined = shellsOf(heading + ",inclination\n0,1,0.9,350,-170\n2,0.8,0.7,190,170\n");
  EXPECT_EQ(inclined[1].positionAngle, 190) << "a tilted one does not";
  EXPECT_EQ(inclined[1].inclination, -190);
  EXPECT_EQ(shellsOf(heading + ",inclination\n0,1,1,350,1\n2,1,1,10,1\n")[1].positionAngle, 370);
}

TEST(SpheroidKeys, ErrorsOfShellsNameTheLine)
{
  const std::string heading = "semi_major,axis_ratio_b,axis_ratio_c,position_angle,inclination\n";
  const std::vector<std::pair<std::string, std::string>> refused = {
    { "-1,1,1,0,0\n", "line 2: semi_major must be at least 0" },
    { "1,1,1,0,0\n1,1,1,0,0\n", "line 3: semi_major must be greater than in the row before" },
    { "1,0,1,0,0\n", "line 2: axis_ratio_b must be 0 to 1" },
    { "1,1,1.5,0,0\n", "line 2: axis_ratio_c must be 0 to 1" },
    { "1,1,1,nan,0\n", "line 2: position_angle must be a finite number" },
    { "1,1,1,0,200\n", "line 2: inclination must be -180 to 180" },
  };
  for (const auto& [rows, expected] : refused)
  {
    const std::string message = errorOf([text = heading + rows] { shellsOf(text); });
    EXPECT_NE(message.find(expected), std::string::npos) << rows << " gave: " << message;
  }
}
} // namespace galaxy
