#include "CoordinateFixtures.h"
#include "FitsFixtures.h"

#include "Readers/Formats/Beam.h"
#include "Readers/Formats/BrightnessUnit.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cstdlib>
#include <string>

using namespace galaxy::testing;
using galaxy::SkyPosition;
using galaxy::WorldCoordinates;

namespace
{
/// A language that writes 0,5: one of the machine's, or one compiled for the test.
class DecimalComma : public FitsFolder
{
protected:
  void SetUp() override
  {
    FitsFolder::SetUp();
    const std::string own = this->path("de_DE");
    const std::string command =
      "localedef -i de_DE -f UTF-8 '" + own + "' > /dev/null 2>&1 || true";
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && std::system(command.c_str()) == 0)
    {
      setenv("LOCPATH", this->folder.c_str(), 1);
      std::setlocale(LC_ALL, "de_DE");
    }
    if (std::string(std::localeconv()->decimal_point) != ",")
    {
      GTEST_SKIP() << "no language with a decimal comma, and no localedef to make one";
    }
  }
  void TearDown() override
  {
    std::setlocale(LC_ALL, "C");
    FitsFolder::TearDown();
  }
};
} // namespace

TEST_F(DecimalComma, FilesAreReadAsEverywhere)
{
  const std::string comma = std::setlocale(LC_ALL, nullptr);
  const auto speak = [](const std::string& language) { std::setlocale(LC_ALL, language.c_str()); };
  speak("C");
  const std::string file = this->write("image.fits", [](fitsfile* f, int* status) {
    addImage(f, SHORT_IMG, { 0, 1, 2, 3, 4, 5 }, status);
    fits_update_key_dbl(f, "BSCALE", 0.25, 10, nullptr, status);
    fits_update_key_dbl(f, "BZERO", 1.5, 10, nullptr, status);
    fits_write_history(f, "AIPS   CLEAN BMAJ=  2.5E-03 BMIN=  2.5E-03 BPA= 1.5", status);
  });
  Cards sip = with(simple("TAN-SIP", 150.5, 20.25), "A_ORDER", "2");
  sip = with(with(with(sip, "B_ORDER", "2"), "A_2_0", "1.5D-5"), "CDELT2", "0.01");
  const Cards tnx = with(with(simple("TNX", 150.5, 20.25), "WAT1_001",
                           "'wtype=tnx lngcor = \"3. 2. 2. 1. -1. 1. -1. 1. 0.5 0.25 0. 0. \"'"),
    "EQUINOX", "'B1950.5'");
  for (const Cards& cards : { sip, tnx })
  {
    const std::string text = header(cards);
    const SkyPosition everywhere = sky(WorldCoordinates("a.fits", text, 100, 100), 9, 7);
    speak(comma);
    const SkyPosition here = sky(WorldCoordinates("a.fits", text, 100, 100), 9, 7);
    speak("C");
    EXPECT_EQ(separationArcsec(here, everywhere), 0) << text;
  }

  speak(comma);
  const galaxy::Image image = galaxy::readFitsImage(file);
  EXPECT_EQ(image.values[5], 2.75);
  const auto beam = galaxy::beamOf(image);
  ASSERT_TRUE(beam);
  EXPECT_NEAR(beam->major, 9, 1e-9);
  EXPECT_EQ(galaxy::parseBrightnessUnit("2.5 mJy/beam").scale, 2.5e-3);
  EXPECT_EQ(std::string(std::localeconv()->decimal_point), ",") << "the user's language is kept";
}
