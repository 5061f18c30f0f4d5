// Where memory is not to be had a picture is not drawn, and nothing else happens.
#include "Filters/Export/ExportPicture.h"
#include "Filters/Splatting/JointParticles.h"
#include "Filters/Splatting/LightGroups.h"
#include "Filters/Splatting/Panorama.h"
#include "Filters/Splatting/Preview.h"
#include "Filters/Splatting/TilePieces.h"
#include "Filters/Splatting/Tiles.h"
#include "Testing/Cxx/ExportFixtures.h"
#include "Testing/Cxx/FailingMemory.h"
#include "Testing/Cxx/RenderFixtures.h"

#include <omp.h>

namespace galaxy::testing
{
namespace
{
constexpr long tries = 60;

std::vector<float> allOf(const RenderedImage& image)
{
  std::vector<float> all = image.radiance;
  all.insert(all.end(), image.transmittance.begin(), image.transmittance.end());
  return all;
}

class TestMemoryOfPictures : public ::testing::Test
{
protected:
  void SetUp() override { omp_set_num_threads(3); }
};

TEST_F(TestMemoryOfPictures, Levels)
{
  const Scene scene = randomScene(1500, true);
  for (const Accuracy accuracy : { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Overlapping })
  {
    SCOPED_TRACE(int(accuracy));
    RenderOptions options;
    options.accuracy = accuracy;
    options.allowed = { 1e-3, 1e-3 };
    options.slices = 0.1;
    const int width = accuracy == Accuracy::Overlapping ? 16 : 90;
    RenderMemory kept;
    const auto work = [&] {
      return allOf(render(scene.view(), testCamera(false, width, width), options));
    };
    expectToSurvive(work, tries);
    options.memory = &kept;
    expectToSurvive(work, tries);
  }
}

TEST_F(TestMemoryOfPictures, ATileInPieces)
{
  Scene scene = randomScene(1000, true);
  std::vector<int> again(TilePieces::fewestSplats);
  for (std::size_t i = 0; i < again.size(); ++i)
  {
    again[i] = static_cast<int>(i % 1000);
  }
  scene = scene.inOrder(again);
  for (float& x : scene.position)
  {
    x *= 0.02F; // all in one tile
  }
  expectToSurvive([&] { return allOf(renderSorted(scene.view(), testCamera(true, 16, 16))); }, 30);
}

TEST_F(TestMemoryOfPictures, Preview)
{
  const Scene scene = randomScene(1500, true);
  RenderOptions options;
  expectToSurvive(
    [&] {
      Preview preview;
      return allOf(preview.render(scene.view(), 1, testCamera(false, 100, 70), options, 100));
    },
    tries);
}

TEST_F(TestMemoryOfPictures, Panorama)
{
  const Scene scene = randomScene(300, true);
  galaxy::Panorama panorama;
  panorama.width = 40;
  panorama.height = 20;
  panorama.ahead = Camera::lookAt({}, { 0, 0, -1 }, { 0, 1, 0 }, false, 1, 90, 40, 20);
  expectToSurvive([&] { return allOf(renderPanorama(scene.view(), panorama)); }, tries);
}

TEST_F(TestMemoryOfPictures, Joint)
{
  const Scene scenes[] = { randomScene(800, true, 1), randomScene(700, true, 2) };
  const std::vector<ParticleView> parts = { scenes[0].view(), scenes[1].view() };
  expectToSurvive(
    [&] {
      JointParticles joint(parts);
      return allOf(renderSorted(joint.view(parts), testCamera(false, 100, 70)));
    },
    tries);
}

TEST_F(TestMemoryOfPictures, LightGroups)
{
  Particles particles = mixedParticles(2000);
  for (std::size_t i = 0; i < particles.size(); ++i)
  {
    particles.intensity[i] = 0.01F * static_cast<float>(1 + i % 50);
  }
  std::vector<ComponentInfo> components = particles.components;
  const std::vector<bool> visible(components.size(), true);
  ParticleView view;
  view.size = particles.size();
  view.position = particles.position.data();
  view.smoothingLength = particles.smoothingLength.data();
  view.intensity = particles.intensity.data();
  view.color = particles.color.data();
  view.component = particles.component.data();
  view.components = &components;
  view.visible = &visible;
  galaxy::LightGroups groups; // outlives what fails
  const auto show = [&](double brightness) {
    components[0].brightness = brightness;
    ComponentLights lights;
    lights.add(components, visible, false, false);
    return allOf(*groups.render(view, lights.gains, testCamera(true, 100, 70), {}, {}));
  };
  expectToSurvive(
    [&] {
      groups.clear();
      const std::vector<float> before = show(1);
      std::vector<float> all = show(2);
      all.insert(all.end(), before.begin(), before.end());
      return all;
    },
    tries, Kept::Some);
}

class TestMemoryOfPictureFiles : public ExportFolder
{
};

TEST_F(TestMemoryOfPictureFiles, FitsAndExr)
{
  const RenderedImage image =
    renderSorted(randomScene(200, true).view(), testCamera(false, 40, 30));
  LightPicture picture;
  picture.width = image.width;
  picture.height = image.height;
  picture.radiance = image.radiance.data();
  picture.transmittance = image.transmittance.data();
  picture.camera = PictureCamera();
  for (const char* name : { "picture.fits", "picture.exr" })
  {
    SCOPED_TRACE(name);
    const bool isExr = std::string(name) == "picture.exr";
    expectToSurvive([&] { return exportPicture(picture, this->path(name)); }, tries,
      isExr ? Kept::Some : Kept::Nothing); // OpenEXR itself keeps it, and speaks of files
    EXPECT_EQ(this->filesThere(), 1u);
    std::filesystem::remove(this->path(name));
  }
}
} // namespace
} // namespace galaxy::testing
