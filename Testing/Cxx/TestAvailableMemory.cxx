// What does not fit into memory is refused before it is begun, by name and with the numbers.
#include "Filters/Model/GroupBuilder.h"
#include "Filters/Splatting/JointParticles.h"
#include "Filters/Splatting/Panorama.h"
#include "Readers/Formats/AvailableMemory.h"
#include "Testing/Cxx/FitsFixtures.h"
#include "Testing/Cxx/RenderFixtures.h"

#include <fstream>

#include <sys/resource.h>

namespace galaxy::testing
{
namespace
{
/// The address space may grow by so many bytes and no more.
class AddressSpaceLimit
{
public:
  explicit AddressSpaceLimit(double more)
  {
    getrlimit(RLIMIT_AS, &this->before);
    rlimit limit = this->before;
    std::ifstream pages("/proc/self/statm");
    double used = 0;
    pages >> used;
    limit.rlim_cur = static_cast<rlim_t>(4096 * used + more);
    setrlimit(RLIMIT_AS, &limit);
  }
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &this->before); }

private:
  rlimit before;
};

/// A folder that looks like a machine's root.
class TestAvailableMemory : public FitsFolder
{
protected:
  void file(const std::string& name, const std::string& text) const
  {
    const std::filesystem::path path = this->path(name);
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  double available() const { return availableMemory(this->folder.string()); }
};

constexpr double MiB = 1 << 20;
} // namespace

TEST_F(TestAvailableMemory, OfTheMachine)
{
  EXPECT_TRUE(std::isinf(this->available()));
  this->file("proc/meminfo",
    "MemTotal:       16000000 kB\nMemFree:          100000 kB\nMemAvailable:    2048000 kB\n");
  EXPECT_EQ(this->available(), 2048000 * 1024.0);
}

TEST_F(TestAvailableMemory, OfNestedGroups)
{
  this->file("proc/meminfo", "MemAvailable:    20480000 kB\n");
  this->file("proc/self/cgroup", "0::/user/job\n");
  this->file("proc/self/mountinfo",
    "24 1 8:1 / / rw,relatime shared:1 - ext4 /dev/sda1 rw\n"
    "30 23 0:26 / /sys/fs/cgroup rw,nosuid,nodev shared:4 - cgroup2 cgroup2 rw,nsdelegate\n");
  this->file("sys/fs/cgroup/user/job/memory.max", "max\n");
  this->file("sys/fs/cgroup/user/job/memory.current", "1000000000\n");
  EXPECT_EQ(this->available(), 20480000 * 1024.0);
  this->file("sys/fs/cgroup/user/memory.max", "3000000000\n");
  this->file("sys/fs/cgroup/user/memory.current", "2500000000\n");
  EXPECT_EQ(this->available(), 5e8);
  // What was read from files gives way.
  this->file("sys/fs/cgroup/user/memory.stat",
    "anon 1000000000\nfile 1500000000\nactive_file 300000000\ninactive_file 900000000\n");
  EXPECT_EQ(this->available(), 17e8);
  this->file("sys/fs/cgroup/user/job/memory.max", "1200000000\n");
  EXPECT_EQ(this->available(), 2e8);
  this->file("sys/fs/cgroup/user/job/memory.current", "1300000000\n");
  EXPECT_EQ(this->available(), 0);
}

TEST_F(TestAvailableMemory, OfOldGroupsAsAContainerSeesThem)
{
  this->file("proc/self/cgroup", "5:cpu,cpuacct:/docker/a1\n4:memory:/docker/a1/b\n0::/\n");
  this->file("proc/self/mountinfo",
    "34 31 0:30 /docker/a1 /sys/fs/cgroup/cpu rw - cgroup cgroup rw,cpu,cpuacct\n"
    "35 31 0:32 /docker/a1 /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n");
  const std::string memory = "sys/fs/cgroup/memory/";
  this->file(memory + "b/memory.limit_in_bytes", "9223372036854771712\n");
  this->file(memory + "b/memory.usage_in_bytes", "500\n");
  EXPECT_TRUE(std::isinf(this->available()));
  this->file(memory + "memory.limit_in_bytes", "2000000000\n");
  this->file(memory + "memory.usage_in_bytes", "1500000000\n");
  this->file(memory + "memory.stat", "inactive_file 1\ntotal_inactive_file 400000000\n");
  EXPECT_EQ(this->available(), 9e8);
  this->file("proc/self/cgroup", "4:memory:/elsewhere\n");
  EXPECT_EQ(this->available(), 9e8);
}

TEST_F(TestAvailableMemory, OfTheProcess)
{
  const AddressSpaceLimit limit(100 * MiB);
  EXPECT_LE(availableMemory(), 101 * MiB);
  EXPECT_GT(availableMemory(), 50 * MiB);
}

namespace
{
/// Of two spheroids, one of which is small.
GalaxyDescription largeGalaxy()
{
  GalaxyDescription galaxy;
  galaxy.file = galaxy.name = "large.galaxy";
  galaxy.distance = 1;
  galaxy.components.resize(2);
  galaxy.components[0].name = "few";
  galaxy.components[0].particles = 1000;
  galaxy.components[1].name = "many";
  galaxy.components[1].particles = 300000000;
  for (ComponentDescription& component : galaxy.components)
  {
    component.type = ComponentType::Spheroid;
  }
  return galaxy;
}

Galaxy read(const GalaxyDescription& description)
{
  Galaxy galaxy;
  galaxy.description = description;
  galaxy.rings.rings.resize(1);
  return galaxy;
}

void expectRefusal(const std::string& message, const std::string& begin, const std::string& end)
{
  EXPECT_EQ(message.find(begin), 0u) << message;
  EXPECT_NE(message.find(" of memory, but only "), std::string::npos) << message;
  EXPECT_NE(message.find(end), std::string::npos) << message;
}
} // namespace

TEST_F(TestAvailableMemory, AModelIsRefusedBeforeItIsBuilt)
{
  const Galaxy galaxy = read(largeGalaxy());
  const AddressSpaceLimit limit(3000 * MiB);
  BuildOptions options;
  options.progress = [](double) {
    ADD_FAILURE() << "it has begun";
    return true;
  };
  expectRefusal(errorOf([&] { buildGalaxy(galaxy, options); }),
    "large.galaxy: many: 300001000 particles: the model takes 8.4 GB of memory, but only ",
    "; use a smaller ParticleScale");
  options.velocities = true;
  options.particleScale = 0.5;
  expectRefusal(
    errorOf([&] { buildGalaxy(galaxy, options); }), "large.galaxy: many: 150000500 ", "6 GB");
}

TEST_F(TestAvailableMemory, AGroupIsRefusedBeforeItIsBuilt)
{
  GalaxyDescription galaxy = largeGalaxy();
  galaxy.components[1].particles = 10000000;
  std::vector<GroupPlace> places(2);
  for (GroupPlace& place : places)
  {
    place.galaxy = galaxy;
  }
  GroupDescription group;
  group.members.resize(2);
  const AddressSpaceLimit limit(600 * MiB);
  expectRefusal(errorOf([&] { buildGroup(group, places, {}); }),
    "large.galaxy: many: 20002000 particles: the model takes 1.12 GB", "; use a smaller");
}

TEST_F(TestAvailableMemory, APictureIsRefusedBeforeItIsDrawn)
{
  const Scene scene = randomScene(10, true);
  const Camera camera = testCamera(false, 100000, 100000);
  const AddressSpaceLimit limit(1000 * MiB);
  for (const Accuracy accuracy :
    { Accuracy::Sorted, Accuracy::Bounded, Accuracy::Preview, Accuracy::Overlapping })
  {
    RenderOptions options;
    options.accuracy = accuracy;
    expectRefusal(errorOf([&] { render(scene.view(), camera, options); }),
      "picture: ImageSize: one of 100000 x 100000 pixels takes 240 GB", "; choose a smaller one");
  }
  Panorama panorama;
  panorama.ahead = camera;
  panorama.width = panorama.height = 100000;
  expectRefusal(
    errorOf([&] { renderPanorama(scene.view(), panorama); }), "picture: ImageSize: one of ", "GB");
}

TEST_F(TestAvailableMemory, ManyParticlesAreRefusedBeforeTheyAreDrawn)
{
  const Scene scene = randomScene(3000000, false);
  const AddressSpaceLimit limit(32 * MiB);
  expectRefusal(errorOf([&] { renderSorted(scene.view(), testCamera(true, 16, 16)); }),
    "particles: drawing 3000000 of them takes 48 MB", "; use a smaller ParticleScale");
  const std::vector<ParticleView> parts(2, scene.view());
  expectRefusal(errorOf([&] { JointParticles joint(parts); }),
    "particles: a changed copy of 6000000 of them takes 246 MB", "; use a smaller ParticleScale");
}

TEST_F(TestAvailableMemory, AnImageIsRefusedBeforeItIsRead)
{
  constexpr long side = 6000;
  const std::string file = this->write("large.fits", [](fitsfile* to, int* status) {
    long axes[] = { side, side };
    fits_create_img(to, BYTE_IMG, 2, axes, status);
  });
  std::filesystem::resize_file(file, 2880 * (2 + side * side / 2880));
  const AddressSpaceLimit limit(300 * MiB);
  expectRefusal(messageOf(file), file + ": NAXIS: the image of 6000 x 6000 pixels takes 576 MB",
    "; cut out or bin the image");
}
} // namespace galaxy::testing
