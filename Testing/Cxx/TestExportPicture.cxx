// Pictures in linear light as files: whole or not at all. What is in them, test_save_picture says.
#include "Filters/Export/ExportPicture.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/ExportFixtures.h"

#include <limits>

namespace galaxy::testing
{
namespace
{
const char* const names[] = { "picture.fits", "picture.FTS", "picture.exr" };

/// Numbers that no compression makes smaller.
struct NoisyPicture
{
  std::vector<float> radiance, transmittance;
  LightPicture view;

  NoisyPicture(int width, int height)
    : radiance(3 * std::size_t(width * height))
    , transmittance(this->radiance.size())
  {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::size_t i = 0; i < this->radiance.size(); ++i)
    {
      this->radiance[i] = uniform(random);
      this->transmittance[i] = uniform(random);
    }
    this->view.width = width;
    this->view.height = height;
    this->view.radiance = this->radiance.data();
    this->view.transmittance = this->transmittance.data();
  }
};

class TestExportPicture : public ExportFolder
{
protected:
  std::string messageOf(const LightPicture& picture, const std::string& file) const
  {
    return errorOf([&] { exportPicture(picture, file); });
  }
  std::string oldFile(const std::string& name) const
  {
    std::ofstream(this->path(name)) << "what was there";
    return this->path(name);
  }
};
} // namespace

TEST_F(TestExportPicture, AFullDiskLeavesTheOldFile)
{
  const NoisyPicture picture(200, 150);
  for (const char* name : names)
  {
    const std::string file = this->oldFile(name);
    for (const rlim_t bytes : { 0, 100, 5000, 300000, 650000 })
    {
      FileSizeLimit limit(bytes);
      EXPECT_EQ(
        this->messageOf(picture.view, file).find(file + ": cannot be written: File too large; "),
        0u);
      EXPECT_EQ(contentOf(file), "what was there");
    }
  }
  EXPECT_EQ(this->filesThere(), 3u);
}

TEST_F(TestExportPicture, AnAbortLeavesTheOldFile)
{
  const NoisyPicture picture(20, 15);
  for (const char* name : names)
  {
    const std::string file = this->oldFile(name);
    PictureExportOptions options;
    options.progress = [](double fraction) { return fraction < 0.5; };
    EXPECT_FALSE(exportPicture(picture.view, file, options));
    EXPECT_EQ(contentOf(file), "what was there");
  }
  EXPECT_EQ(this->filesThere(), 3u);
}

TEST_F(TestExportPicture, ThePictureMakesTheFileAndNothingElse)
{
  const NoisyPicture picture(20, 15);
  for (const char* name : names)
  {
    ASSERT_TRUE(exportPicture(picture.view, this->path(name)));
    const std::string first = contentOf(this->path(name));
    ASSERT_TRUE(exportPicture(picture.view, this->path(name)));
    EXPECT_EQ(contentOf(this->path(name)), first);
    EXPECT_GE(first.size(), 2 * 12 * 300U);
  }
}

TEST_F(TestExportPicture, WhatIsNoPictureIsRefused)
{
  const std::string file = this->path("picture.fits");
  EXPECT_EQ(this->messageOf({}, file), file + ": the picture must have a pixel");
  const std::string other = this->path("picture.png");
  const NoisyPicture picture(2, 2);
  EXPECT_NE(
    this->messageOf(picture.view, other).find(other + ": its extension"), std::string::npos);
  EXPECT_EQ(this->filesThere(), 0u);
}

TEST_F(TestExportPicture, HalfPrecisionHasAnEnd)
{
  NoisyPicture picture(3, 2);
  PictureExportOptions options;
  options.pixel = ExrPixel::Half;
  picture.radiance[7] = 65504;
  EXPECT_TRUE(exportPicture(picture.view, this->path("picture.exr"), options));
  for (const float value : { 65600.0F, std::numeric_limits<float>::infinity() })
  {
    picture.radiance[7] = value;
    EXPECT_THROW(exportPicture(picture.view, this->path("picture.exr"), options), Error);
  }
  EXPECT_EQ(this->filesThere(), 1u);
}
} // namespace galaxy::testing
