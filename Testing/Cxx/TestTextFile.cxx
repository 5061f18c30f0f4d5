// What every text passes through: kind and size of the file, its bytes, its numbers, and what a
// message may quote of it.
#include "Readers/Formats/FitsFile.h"
#include "Readers/Formats/GalaxyDescription.h"
#include "Readers/Formats/RingTable.h"
#include "Readers/Formats/Sexagesimal.h"
#include "Readers/Formats/SpheroidTables.h"
#include "Readers/Formats/TextFile.h"
#include "Readers/Formats/WidthTable.h"
#include "Testing/Cxx/ErrorOf.h"
#include "Testing/Cxx/TemporaryFolder.h"

#include <sys/stat.h>

#include <clocale>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace galaxy::testing
{
namespace
{
using Reader = std::function<void(const std::string&)>;

/// All that reads a file.
const std::vector<std::pair<const char*, Reader>> readers = {
  { "rings", [](const std::string& file) { readRingTable(file); } },
  { "widths", [](const std::string& file) { readWidthTable(file); } },
  { "clusters", [](const std::string& file) { parseClusterList(readText(file), file); } },
  { "shells", [](const std::string& file) { parseEllipsoidShells(readText(file), file); } },
  { "galaxy", [](const std::string& file) { readGalaxyDescription(file); } },
  { "group", [](const std::string& file) { readGroupDescription(file); } },
  { "FITS", [](const std::string& file) { readFitsImage(file); } },
};

class TextFiles : public TemporaryFolder
{
protected:
  void expectAll(const std::string& file, const std::string& words) const
  {
    for (const auto& [name, read] : readers)
    {
      const std::string message = errorOf([&read = read, &file] { read(file); });
      EXPECT_NE(message.find(words), std::string::npos) << name << " gave: " << message;
    }
  }
};
} // namespace

TEST_F(TextFiles, OnlyARegularFileIsOpened)
{
  this->expectAll(this->path("absent"), "no such file");
  this->expectAll(this->folder.string(), "is a folder, must be a file");
  this->expectAll("/dev/zero", "is a device, must be a file");
  // A pipe would be waited for.
  ASSERT_EQ(mkfifo(this->path("pipe").c_str(), 0600), 0);
  this->expectAll(this->path("pipe"), "is a pipe (FIFO), must be a file");
  std::filesystem::create_symlink(this->path("pipe"), this->path("to-pipe"));
  this->expectAll(this->path("to-pipe"), "is a pipe (FIFO), must be a file");
  std::filesystem::create_symlink(this->path("loop"), this->path("loop"));
  this->expectAll(this->path("loop"), "is a symbolic link that leads back to itself");
  std::filesystem::create_symlink(this->path("absent"), this->path("dangling"));
  this->expectAll(this->path("dangling"), "is a symbolic link to a file that is not there");
}

TEST_F(TextFiles, AGiantIsNotReadToItsEnd)
{
  // Blanks up to the limit are read; a hole of 50 GB behind a good line is not.
  std::ofstream(this->path("large.rings")) << "10 100 2 45 80\n"
                                           << std::string(mostTextBytes - 15, '\n');
  EXPECT_EQ(readRingTable(this->path("large.rings")).rings.size(), 1u);
  std::ofstream(this->path("larger.rings")) << "10 100 2 45 80\n"
                                            << std::string(mostTextBytes, '\n');
  EXPECT_NE(errorOf([&] { readRingTable(this->path("larger.rings")); }).find("at most 32 MB"),
    std::string::npos);
  std::ofstream(this->path("sparse.rings")) << "10 100 2 45 80\n";
  std::filesystem::resize_file(this->path("sparse.rings"), std::uintmax_t(50) << 30);
  EXPECT_NE(errorOf([&] { readRingTable(this->path("sparse.rings")); }).find("at most 32 MB"),
    std::string::npos);
}

TEST_F(TextFiles, DescriptionsHaveMarksAndOldLineEndsToo)
{
  const std::string text = "\xef\xbb\xbf[galaxy]\rra = 1\rdec = 2\rdistance = 3.5\r";
  EXPECT_EQ(parseGalaxyDescription(text, "some.galaxy").distance, 3.5);
  const std::string message =
    errorOf([&] { parseGalaxyDescription(text + "distanse = 3\r", "some.galaxy"); });
  EXPECT_NE(message.find("line 5"), std::string::npos) << message;
  EXPECT_NE(
    errorOf([] { parseGroupDescription("\xff\xfe[\0", "g"); }).find("UTF-16"), std::string::npos);
}

TEST(TextFile, LinesKeepTheirNumbers)
{
  const std::vector<TextLine> lines = splitLines(plainText("a\r\n\r\nb\rc\n\n\nd", "x"));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].number, 3);
  EXPECT_EQ(lines[2].number, 4);
  EXPECT_EQ(lines[3].number, 7);
  EXPECT_EQ(plainText(plainText("a\r\n\rb", "x"), "x"), plainText("a\r\n\rb", "x"));
}

TEST(TextFile, NumbersArePointedWhateverTheLocale)
{
  const std::string folder = ::testing::TempDir() + "galaxy-locale-" + std::to_string(getpid());
  std::filesystem::create_directories(folder);
  const std::string make =
    "localedef -c -i de_DE -f UTF-8 " + folder + "/de_DE.UTF-8 > /dev/null 2>&1";
  const bool made = std::system(make.c_str()) == 0;
  setenv("LOCPATH", folder.c_str(), 1);
  const bool set = made && std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr;
  if (!set || *std::localeconv()->decimal_point != ',')
  {
    std::setlocale(LC_ALL, "C");
    unsetenv("LOCPATH");
    std::filesystem::remove_all(folder);
    GTEST_SKIP() << "no locale with a decimal comma can be made here";
  }
  const std::locale before = std::locale::global(std::locale("de_DE.UTF-8"));
  const RingTable table = parseRingTable("1234.5 100.25 0.5 45.5 80.5\n", "some.rings");
  const RingTable tirific =
    parseRingTable("RADI= 1234.5\nVROT= 1\nINCL= 45.5\nPA= 1\n", "some.def");
  const GalaxyDescription galaxy =
    parseGalaxyDescription("[galaxy]\nra = 204.25\ndec = -29.87\ndistance = 4.9\n", "some.galaxy");
  const auto angle = sexagesimalAngle("06:07:12.5", true);
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  unsetenv("LOCPATH");
  std::filesystem::remove_all(folder);
  EXPECT_EQ(table.rings[0].radius, 1234.5);
  EXPECT_EQ(table.rings[0].rotationVelocity, 100.25);
  EXPECT_EQ(tirific.rings[0].inclination, 45.5);
  EXPECT_EQ(galaxy.distance, 4.9);
  EXPECT_EQ(galaxy.centre.dec, -29.87);
  EXPECT_NEAR(angle.value_or(0), (6 + 7 / 60.0 + 12.5 / 3600) * 15, 1e-12);
}

TEST(TextFile, AnglesOfManyWritings)
{
  EXPECT_NEAR(sexagesimalAngle("13:29:52.7", true).value(), 202.4695833333, 1e-9);
  EXPECT_NEAR(sexagesimalAngle("13:29:52.7", false).value(), 13.4979722222, 1e-9);
  EXPECT_NEAR(sexagesimalAngle("13h29m52.7s", false).value(), 202.4695833333, 1e-9);
  EXPECT_NEAR(sexagesimalAngle("-00d30m", true).value(), -0.5, 1e-12);
  EXPECT_NEAR(sexagesimalAngle("+47d11'42\"", true).value(), 47.195, 1e-12);
  EXPECT_NEAR(sexagesimalAngle("47\xc2\xb0"
                               "11'42\"",
                true)
                .value(),
    47.195, 1e-12);
  EXPECT_NEAR(sexagesimalAngle("47.11.42.0", true).value(), 47.195, 1e-12);
  for (const char* none :
    { "", "-", "12", "12:60:00", "12:00:60", "1:2:3:4", "12:-5:0", "a:b", ":", "1:2e1", "--1:2" })
  {
    EXPECT_FALSE(sexagesimalAngle(none, true)) << none;
  }
}

TEST(TextFile, MessagesQuoteNothingRaw)
{
  EXPECT_EQ(
    printable(std::string("a\0b\x1b[31m\x07\t\x7f", 11)), "a\\x00b\\x1b[31m\\x07\\x09\\x7f");
  EXPECT_EQ(printable("NGC 1 \xc3\xa9\xe2\x88\x92\xf0\x9f\x8c\x8c"),
    "NGC 1 \xc3\xa9\xe2\x88\x92\xf0\x9f\x8c\x8c");
  // Controls of Unicode, writing from right to left, bytes that are no character.
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");
  EXPECT_EQ(printable("\xe2\x80\xae"), "\\xe2\\x80\\xae");
  EXPECT_EQ(printable("\xff\xc3"), "\\xff\\xc3");
  EXPECT_EQ(printable("\xc0\x80\xed\xa0\x80"), "\\xc0\\x80\\xed\\xa0\\x80");
  EXPECT_LT(quoted(std::string(100000, 'x')).size(), 80u);
  const std::string message = errorOf([] {
    parseRingTable("10 100 2 45 \x1b]0;owned\x07" + std::string(5000, 'y') + "\n", "a\x1b.rings");
  });
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
  EXPECT_EQ(message.find('\x07'), std::string::npos);
  EXPECT_NE(message.find("a\\x1b.rings: line 1"), std::string::npos) << message;
  EXPECT_LT(message.size(), 300u);
  EXPECT_LT(
    std::string(Error("f", "w", "must be " + std::string(1000000, 'x')).what()).size(), 2000u);
}
} // namespace galaxy::testing
