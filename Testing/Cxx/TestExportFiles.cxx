#include "Testing/Cxx/ExportFixtures.h"

#include "Filters/Export/AtomicFile.h"
#include "Filters/Export/GadgetBinary.h"

#include <limits>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace galaxy::testing
{
namespace
{
constexpr std::uint64_t splitBlock = 12 * 300; ///< of a thousand particles makes 4 files

const ParticleFormat allFormats[] = { ParticleFormat::Gadget1, ParticleFormat::Gadget2,
  ParticleFormat::GadgetHDF5, ParticleFormat::CSV };

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
      EXPECT_EQ(message.find(file + ": cannot be written: File too large; "), 0u) << message;
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
    EXPECT_EQ(
      message(missing).find(missing + ": cannot be written: No such file or directory; "), 0u);
    EXPECT_EQ(
      message(this->folder.string()), this->folder.string() + ": is a folder; choose another name");
    EXPECT_EQ(message("/dev/full"), "/dev/full: is not a regular file; choose another name");
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

namespace
{
/// Writes a file anew for ever.
[[noreturn]] void writeOn(const std::string& file, AtomicFile::Until until)
{
  const std::vector<char> content(1 << 16, 'x');
  for (;;)
  {
    AtomicFile target(file, until);
    for (int k = 0; k < 20; ++k)
    {
      target.write(content.data(), content.size());
    }
    target.commit();
  }
}
} // namespace

TEST_F(TestExportFiles, WhoIsKilledLeavesNothing)
{
  for (const AtomicFile::Until until : { AtomicFile::Until::Unnamed, AtomicFile::Until::Named })
  {
    SCOPED_TRACE(static_cast<int>(until));
    const std::string file = this->oldFile();
    for (int turn = 0; turn < 20; ++turn)
    {
      const pid_t child = fork();
      if (child == 0)
      {
        writeOn(file, until);
      }
      usleep(1000 + 700 * turn);
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
      const std::size_t size = contentOf(file).size();
      EXPECT_TRUE(size == 14 || size == 20 << 16) << size;
    }
    AtomicFile(file, until).commit(); // what had a name goes with the next one
    EXPECT_EQ(this->filesThere(), 1u);
  }
}

TEST_F(TestExportFiles, WhatIsBeingWrittenStays)
{
  const std::string file = this->path("model");
  AtomicFile first(file, AtomicFile::Until::Named), second(file, AtomicFile::Until::Named);
  first.write("first", 5);
  second.write("second", 6);
  second.commit();
  EXPECT_EQ(contentOf(file), "second");
  first.commit();
  EXPECT_EQ(contentOf(file), "first");
  EXPECT_EQ(this->filesThere(), 1u);
  std::ofstream(this->path(".galaxy-mine")) << "no temporary file";
  AtomicFile(file).commit();
  EXPECT_EQ(this->filesThere(), 2u);
}

TEST_F(TestExportFiles, ANameAsLongAsTheSystemAllows)
{
  const Particles particles = mixedParticles(10);
  for (const ParticleFormat format : allFormats)
  {
    const std::string file = this->path(std::string(255, 'm'));
    ASSERT_TRUE(exportTo(file, tableOf(particles), format));
    EXPECT_GT(std::filesystem::file_size(file), 0u);
  }
  EXPECT_EQ(this->filesThere(), 1u);
}

TEST_F(TestExportFiles, AFileKeepsItsPermissions)
{
  namespace fs = std::filesystem;
  const Particles particles = mixedParticles(10);
  const std::string file = this->oldFile();
  for (const ParticleFormat format : allFormats)
  {
    for (const int mode : { 0600, 0640, 0664, 0444 })
    {
      fs::permissions(file, fs::perms(mode));
      ASSERT_TRUE(exportTo(file, tableOf(particles), format));
      EXPECT_EQ(int(fs::status(file).permissions()), mode);
    }
  }
  // A new one gets what the user's umask leaves.
  const mode_t mask = umask(027);
  ASSERT_TRUE(exportTo(this->path("fresh"), tableOf(particles), ParticleFormat::CSV));
  umask(mask);
  EXPECT_EQ(int(fs::status(this->path("fresh")).permissions()), 0640);
}

TEST_F(TestExportFiles, ASplitSnapshotAppearsAsAWhole)
{
  const Particles before = mixedParticles(1000), after = mixedParticles(1100);
  const std::string file = this->path("model");
  ASSERT_TRUE(exportTo(file, tableOf(before), ParticleFormat::Gadget2, splitBlock));
  const std::size_t parts = this->filesThere();
  ASSERT_GE(parts, 4u);
  const std::string first = contentOf(file + ".0"), second = contentOf(file + ".1");
  // The third part's place is taken when all is written and none has its place.
  ExportOptions options;
  options.format = ParticleFormat::Gadget2;
  options.largestBlock = splitBlock;
  options.progress = [&](double fraction) {
    if (fraction == 1)
    {
      std::filesystem::remove(file + ".2");
      std::filesystem::create_directory(file + ".2");
    }
    return true;
  };
  EXPECT_THROW(exportParticles(tableOf(after), file, options), Error);
  EXPECT_EQ(contentOf(file + ".0"), first);
  EXPECT_EQ(contentOf(file + ".1"), second);
  EXPECT_EQ(this->filesThere(), parts); // and nothing beside them
  // The same where nothing was there.
  for (const char* part : { ".0", ".1", ".3" })
  {
    std::filesystem::remove(file + part);
  }
  const std::size_t others = this->filesThere();
  EXPECT_THROW(exportParticles(tableOf(after), file, options), Error);
  EXPECT_EQ(this->filesThere(), others);
}

TEST_F(TestExportFiles, WhatAnEarlierSplitHasLeftGoes)
{
  const Particles particles = mixedParticles(1000);
  for (const ParticleFormat format : { ParticleFormat::Gadget1, ParticleFormat::Gadget2 })
  {
    const auto write = [&](std::uint64_t largestBlock) {
      ASSERT_TRUE(exportTo(this->path("model"), tableOf(particles), format, largestBlock));
    };
    // Names alike, but no parts of this snapshot.
    std::ofstream(this->path("model.6")) << "notes";
    std::ofstream(this->path("model.bak")) << "notes";
    ASSERT_TRUE(exportTo(this->path("model.07"), tableOf(particles), format));
    ASSERT_TRUE(exportTo(this->path("model.9"), tableOf(particles), format)); // not split
    const std::size_t others = 4;

    write(2 * splitBlock);
    const std::size_t few = this->filesThere();
    EXPECT_GT(few, others + 1);
    write(largestGadgetBlock);
    EXPECT_EQ(this->filesThere(), others + 1);
    EXPECT_TRUE(std::filesystem::exists(this->path("model")));
    write(splitBlock);
    EXPECT_FALSE(std::filesystem::exists(this->path("model")));
    EXPECT_GT(this->filesThere(), few);
    write(2 * splitBlock);
    EXPECT_EQ(this->filesThere(), few);
    EXPECT_EQ(contentOf(this->path("model.6")), "notes");
    write(largestGadgetBlock);
    std::filesystem::remove(this->path("model"));
  }
}

TEST_F(TestExportFiles, ParticlesNoProgramCouldReadAreNamed)
{
  Particles particles = mixedParticles(1000);
  const std::string file = this->oldFile();
  const auto message = [&] { return messageOf(file, tableOf(particles), ParticleFormat::CSV); };
  particles.component[700] = 4;
  EXPECT_EQ(message(),
    file + ": particle 700: its component must be below 4, the component table's size, not 4");
  particles.position[3 * 17 + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(message(), file + ": particle 17: its position must be finite");
  EXPECT_EQ(messageOf(file, ParticleTable(), ParticleFormat::CSV),
    file + ": there are no particles to write; check the writer's input");
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
