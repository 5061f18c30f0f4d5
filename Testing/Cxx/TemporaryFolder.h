#ifndef galaxy_TemporaryFolder_h
#define galaxy_TemporaryFolder_h

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace galaxy::testing
{
/// A test with a folder of its own, which is gone after it.
class TemporaryFolder : public ::testing::Test
{
protected:
  void SetUp() override
  {
    std::string name = (std::filesystem::temp_directory_path() / "galaxy-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    this->folder = name;
  }
  void TearDown() override { std::filesystem::remove_all(this->folder); }

  std::string path(const std::string& name) const { return (this->folder / name).string(); }

  std::filesystem::path folder;
};
} // namespace galaxy::testing

#endif
