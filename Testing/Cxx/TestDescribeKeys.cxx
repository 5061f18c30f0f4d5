#include "Readers/Formats/GalaxyDescription.h"

#include <gtest/gtest.h>

#include <filesystem>

// Each key of the full example is documented, with the struct's default.
TEST(DescribeKeys, ComesFromTheTable)
{
  const std::string table = galaxy::describeKeys();
  EXPECT_NE(table.find("| `[galaxy]` | `distance` | number greater than 0, Mpc | required | "),
    std::string::npos);
  EXPECT_NE(
    table.find("| `[component.thickness]` | `flare_length` | number greater than 0, kpc | 17.4 | "),
    std::string::npos);
  EXPECT_NE(table.find("| `[component.thickness]` | `law` | \"Gaussian\", \"Sech2\", "
                       "\"Exponential\", \"Lorentzian\", \"Box\" | \"Gaussian\" | "),
    std::string::npos);
  EXPECT_NE(table.find("| `[component.spheroid]` | `sigma` | 3 numbers greater than 0, kpc | [0.3, "
                       "0.3, 0.2] | "),
    std::string::npos);
  EXPECT_NE(table.find("| `[[member]]` | `galaxy` | text | required | "), std::string::npos);
}

TEST(DescribeKeys, ExamplesReadmeListsEveryKey)
{
  const std::string readme = galaxy::readText(GALAXY_SOURCE_DIR "/Examples/README.md");
  EXPECT_NE(readme.find(galaxy::describeKeys()), std::string::npos)
    << "Examples/README.md must hold this table:\n"
    << galaxy::describeKeys();
}

TEST(DescribeKeys, EveryExampleIsRead)
{
  int read = 0;
  for (const auto& entry :
    std::filesystem::recursive_directory_iterator(GALAXY_SOURCE_DIR "/Examples"))
  {
    const std::string file = entry.path().string();
    if (entry.path().extension() == ".galaxy")
    {
      EXPECT_NO_THROW(galaxy::readGalaxyDescription(file)) << file;
      ++read;
    }
    else if (entry.path().extension() == ".galaxygroup")
    {
      EXPECT_NO_THROW(galaxy::readGroupDescription(file)) << file;
      ++read;
    }
  }
  EXPECT_GE(read, 8);
}
