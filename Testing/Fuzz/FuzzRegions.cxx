// FuzzRegions COUNT SEED [FILES...|none]: region lists of DS9 and CASA on images with and without
// coordinates, the pixels they mark, see TextFuzz.h.

#include "Readers/Formats/RegionList.h"
#include "Testing/Fuzz/TextFuzz.h"

#include <algorithm>
#include <cmath>

namespace galaxy
{
namespace
{
const std::vector<std::string> texts = {
  "# Region file format: DS9 version 4.1\nglobal color=green font=\"helvetica 10\" width=1 fk5\n"
  "circle(13:29:52.7,+47:11:43,10\") # color=red\n-box(202.47,47.195,4.2\",1',30)\n"
  "image;ellipse(20,30,4,2,45);polygon(1,1,9,1,9,9)\n",
  "\xef\xbb\xbfphysical\ncircle 3 4 5\n!box(5i,5i,2p,2p)\n",
  "galactic;circle(+104:51:05.4,+68:33:39.2,21.6\")\necliptic\ncircle(175.2d,50.9d,0.1r)\n",
  "fk4;circle(13h27m46.3s,47d27m10s,16\")\nwcsa\ncircle(1,2,3)\n",
  "#CRTFv0\nglobal coord=J2000\ncircle[[13h29m52.7s, 47.11.43.0], 10arcsec], color=red\n"
  "rotbox[[202.47deg, 47.195deg], [20arcsec, 4arcsec], 30deg], coord=GALACTIC\n"
  "poly[[1pix,1pix],[9pix,1pix],[9pix,9pix]]\ncenterbox[[51pix, 51pix], [20pix, 4pix]]\n",
};

const std::vector<std::string> words = { "fk5\n", "image;", "galactic;", "ecliptic;", "physical;",
  "circle(", "annulus(", "ellipse(", "polygon", "box", "16\"", "16'", "16d", "16p", "nanpix",
  "1e30arcsec", "1e300", "-1i", "180", "90", "-90", "coord=", "global ", "#CRTF\n", "||", "+",
  "-" };

bool readRegions(const std::string& text, Random& random)
{
  static const WorldCoordinates near = [] {
    SuppliedCoordinates supplied;
    supplied.centre = { 202.47, 47.195 };
    supplied.pixelScale = 2;
    return WorldCoordinates(supplied, 101, 101);
  }();
  RegionCanvas canvas;
  canvas.coordinates = random() % 4 ? &near : nullptr;
  canvas.shift = { random() % 2 ? 0.5 : 1e300, 0.25 };
  const std::vector<PixelRegion> regions = parseRegions(text, "some.reg", canvas);
  return std::all_of(regions.begin(), regions.end(), [](const PixelRegion& region) {
    region.contains({ 51, 51 });
    const auto isNumber = [](const PixelPosition& p) {
      return !std::isnan(p.x) && !std::isnan(p.y);
    };
    return !region.corners.empty() && isNumber(region.middle) &&
      std::all_of(region.corners.begin(), region.corners.end(), isNumber);
  });
}
} // namespace
} // namespace galaxy

int main(int argc, char* argv[])
{
  return galaxy::fuzzTexts(
    argc, argv, { { "regions", galaxy::texts, galaxy::words, galaxy::readRegions, 4 } });
}
