#include "Testing/Cxx/ExportFixtures.h"

#include <csignal>
#include <limits>

#include <sys/resource.h>

namespace galaxy::testing
{
namespace
{
const ParticleFormat allFormats[] = { ParticleFormat::Gadget1, ParticleFormat::Gadget2,
  ParticleFormat::GadgetHDF5, ParticleFormat::CSV };

/// No file may grow beyond this many bytes, which to a writer is what a full disk is.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t bytes)
  {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &this->before);
    rlimit limit = this->before;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &this->before); }

private:
  rlimit before;
};

class TestExportFiles : public ExportFolder
{
protected:
  /// A file that is already there.
  std::string oldFile() const
  {
    std::ofstream(this->path("model")) << "what was there";
    return this->path("model");
  }
  void expectUntouched() const
  {
    EXPECT_EQ(contentOf(this->path("model")), "what was there");
    EXPECT_EQ(this->filesThere(), 1u);
  }
};
} // namespace

TEST_F(TestExportFiles, AFullDiskLeavesTheOldFile)
{
  const Particles particles = mixedParticles(20000);
  const std::string file = this->oldFile();
  for (const ParticleFormat format : allFormats)
  {
    for (const rlim_t bytes : { 0, 100, 5000, 300000, 900000 })
    {
      FileSizeLimit limit(bytes);
      const std::string message = messageOf(file, tableOf(particles), format);
      EXPECT_EQ(message, file + ": cannot be written: File too large") << bytes;
      this->expectUntouched();
    }
  }
}

TEST_F(TestExportFiles, AFileIsReplacedAsAWhole)
{
  const Particles particles = mixedParticles(100);
  const std::string file = this->oldFile();
  for (const ParticleFormat format : allFormats)
  {
    ASSERT_TRUE(exportTo(file, tableOf(particles), format));
    ASSERT_TRUE(exportTo(this->path("fresh"), tableOf(particles), format));
    EXPECT_EQ(contentOf(file), contentOf(this->path("fresh")));
    EXPECT_EQ(this->filesThere(), 2u);
  }
}

TEST_F(TestExportFiles, AnAbortLeavesNothing)
{
  const Particles particles = mixedParticles(200000);
  const std::string file = this->oldFile();
  for (const ParticleFormat format : allFormats)
  {
    std::vector<double> fractions;
    ExportOptions options;
    options.format = format;
    options.progress = [&](double fraction) {
      fractions.push_back(fraction);
      return fraction < 0.5;
    };
    EXPECT_FALSE(exportParticles(tableOf(particles), file, options));
    this->expectUntouched();
    EXPECT_GT(fractions.size(), 2u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.back(), 0.7);
  }
}

TEST_F(TestExportFiles, ProgressEndsAtOne)
{
  const Particles particles = mixedParticles(100000);
  for (const ParticleFormat format : allFormats)
  {
    double last = 0;
    ExportOptions options;
    options.format = format;
    options.progress = [&last](double fraction) {
      last = fraction;
      return true;
    };
    EXPECT_TRUE(exportParticles(tableOf(particles), this->path("model"), options));
    EXPECT_EQ(last, 1.0);
  }
}

TEST_F(TestExportFiles, PlacesThatCannotBeWritten)
{
  const Particles particles = mixedParticles(10);
  for (const ParticleFormat format : allFormats)
  {
    const auto message = [&](const std::string& file) {
      return messageOf(file, tableOf(particles), format);
    };
    const std::string missing = this->path("none/model");
    EXPECT_EQ(message(missing), missing + ": cannot be written: No such file or directory");
    EXPECT_EQ(message(this->folder.string()), this->folder.string() + ": is a folder");
    EXPECT_EQ(message("/dev/full"), "/dev/full: is not a regular file");
    EXPECT_NE(message("/proc/model").find("/proc/model: cannot be written: "), std::string::npos);
    EXPECT_EQ(this->filesThere(), 0u);
  }
}

TEST_F(TestExportFiles, ALinkIsWrittenThrough)
{
  const Particles particles = mixedParticles(10);
  std::filesystem::create_directory(this->folder / "there");
  std::filesystem::create_symlink("there/model", this->folder / "link");
  ASSERT_TRUE(exportTo(this->path("link"), tableOf(particles), ParticleFormat::CSV));
  EXPECT_TRUE(std::filesystem::is_symlink(this->folder / "link"));
  EXPECT_TRUE(std::filesystem::is_regular_file(this->folder / "there" / "model"));
}

TEST_F(TestExportFiles, ParticlesNoProgramCouldReadAreNamed)
{
  Particles particles = mixedParticles(1000);
  const std::string file = this->oldFile();
  const auto message = [&] { return messageOf(file, tableOf(particles), ParticleFormat::CSV); };
  particles.component[700] = 4;
  EXPECT_EQ(
    message(), file + ": particle 700: its component 4 is not among the 4 of the component table");
  particles.position[3 * 17 + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(message(), file + ": particle 17: its position is not finite");
  EXPECT_EQ(messageOf(file, ParticleTable(), ParticleFormat::CSV),
    file + ": there are no particles to write");
  this->expectUntouched();
}

TEST(TestFormatOfFile, ByExtension)
{
  EXPECT_EQ(formatOfFile("a/m83.g1"), ParticleFormat::Gadget1);
  EXPECT_EQ(formatOfFile("m83.gad"), ParticleFormat::Gadget2);
  EXPECT_EQ(formatOfFile("m83.GADGET"), ParticleFormat::Gadget2);
  EXPECT_EQ(formatOfFile("m83.hdf5"), ParticleFormat::GadgetHDF5);
  EXPECT_EQ(formatOfFile("m83.particles.csv"), ParticleFormat::CSV);
  EXPECT_THROW(formatOfFile("m83.fits"), Error);
  EXPECT_THROW(formatOfFile("m83"), Error);
}
} // namespace galaxy::testing
