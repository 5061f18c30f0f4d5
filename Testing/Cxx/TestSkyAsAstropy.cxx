#include "CoordinateFixtures.h"

#include <algorithm>

using namespace galaxy::testing;
using galaxy::SkyPosition;
using galaxy::WorldCoordinates;

namespace
{
/// 100 x 100 pixels about 204.25 -29.87, with these cards beside or in place of the plain ones.
Cards about(const Cards& others, const std::string& projection = "TAN")
{
  Cards cards = simple(projection, 204.25, -29.87);
  for (const auto& [keyword, value] : others)
  {
    cards = with(cards, keyword, value);
  }
  return cards;
}

/// Where astropy 5.2 puts pixel (10, 80) in ICRS: WCS(header).celestial and SkyCoord(...).icrs.
struct KnownPosition
{
  Cards cards;
  SkyPosition sky;
};

void expectAstropy(const std::vector<KnownPosition>& positions)
{
  for (const KnownPosition& known : positions)
  {
    const WorldCoordinates world = make(known.cards);
    EXPECT_LT(separationArcsec(sky(world, 10, 80), known.sky), 1e-4)
      << ::testing::PrintToString(known.cards);
    expectRoundTrip(world);
  }
}

const Cards sip = { { "CTYPE1", "'RA---TAN-SIP'" }, { "CTYPE2", "'DEC--TAN-SIP'" },
  { "A_ORDER", "3" }, { "B_ORDER", "2" }, { "A_2_0", "2e-4" }, { "A_1_1", "-1e-4" },
  { "A_0_2", "3e-5" }, { "A_1_2", "2e-6" }, { "B_2_0", "-1e-4" }, { "B_1_1", "5e-5" },
  { "B_0_2", "2e-4" } };

Cards tpv()
{
  Cards cards =
    about({ { "PV1_0", "1e-3" }, { "PV1_1", "1.01" }, { "PV1_2", "-.02" }, { "PV1_4", ".03" },
            { "PV1_7", ".02" }, { "PV2_0", "-2e-3" }, { "PV2_1", ".99" }, { "PV2_4", "-.02" },
            { "PV2_10", ".03" }, { "CD1_1", "-.008" }, { "CD1_2", ".004" }, { "CD2_1", ".0041" },
            { "CD2_2", ".0079" } },
      "TPV");
  cards.erase(cards.begin() + 9, cards.begin() + 11); // CDELT
  return cards;
}
} // namespace

TEST(AsAstropy, Frames)
{
  const auto equatorial = [](const std::string& system, const std::string& equinox) {
    return about({ { "RADESYS", "'" + system + "'" }, { "EQUINOX", equinox } });
  };
  const auto ecliptic = [](const Cards& cards) {
    Cards all = { { "CTYPE1", "'ELON-TAN'" }, { "CTYPE2", "'ELAT-TAN'" } };
    all.insert(all.end(), cards.begin(), cards.end());
    return about(all);
  };
  const SkyPosition fk4 = { 205.423628398, -29.826407269 };
  expectAstropy({
    { about({}), { 204.715655855, -29.574190346 } },
    { equatorial("FK5", "2000."), { 204.715646044, -29.574190361 } },
    { equatorial("FK5", "1975."), { 205.069243958, -29.700446364 } },
    { equatorial("FK5", "1950."), { 205.423413255, -29.826351670 } },
    { equatorial("FK4", "1950."), fk4 },
    { equatorial("fk4", "1950."), fk4 },
    { about({ { "RADESYS", "'FK4'" } }), fk4 },
    { about({ { "EQUINOX", "1950" } }), fk4 },
    { about({ { "EPOCH", "1950.0" } }), fk4 },
    { equatorial("FK4", "1900."), { 206.133545309, -30.077155278 } },
    { equatorial("FK4", "1975."), { 205.069534609, -29.700496273 } },
    { equatorial("FK4-NO-E", "1950."), { 205.423602553, -29.826368688 } },
    { about({ { "CTYPE1", "'GLON-TAN'" }, { "CTYPE2", "'GLAT-TAN'" } }),
      { 72.911870926, -6.570928926 } },
    { ecliptic({}), { 189.859676512, -36.689054888 } },
    { ecliptic({ { "RADESYS", "'FK5'" }, { "EQUINOX", "1950." } }),
      { 190.532279695, -36.964162060 } },
  });
}

TEST(AsAstropy, Projections)
{
  const auto wide = [](const std::string& projection, const Cards& others = {}) {
    Cards cards = { { "CDELT1", "-0.5" }, { "CDELT2", "0.5" } };
    cards.insert(cards.end(), others.begin(), others.end());
    return about(cards, projection);
  };
  expectAstropy({
    { wide("ZEA"), { 225.019197331, -13.449485603 } },
    { wide("STG"), { 224.579714779, -13.859547946 } },
    { wide("ARC"), { 224.867949795, -13.590856098 } },
    { wide("AIT"), { 224.908858806, -13.284430947 } },
    { wide("CAR"), { 224.372079662, -13.360259203 } },
    { wide("MER"), { 224.401284832, -13.517995443 } },
    { wide("SFL"), { 225.046589581, -13.240131023 } },
    { wide("HPX"), { 224.763153843, -15.454248290 } },
    { wide("ZPN", { { "PV2_1", "1.0" }, { "PV2_3", "-0.04" } }), { 225.013367907, -13.454939127 } },
    { wide("COE", { { "PV2_1", "45." }, { "PV2_2", "25." } }), { 226.639043792, -12.908308976 } },
    { about({ { "CRVAL2", "60." }, { "CDELT1", "-0.1" }, { "CDELT2", "0.1" } }, "NCP"),
      { 213.072670372, 62.557138268 } },
  });
}

TEST(AsAstropy, PlacesAndMatrices)
{
  expectAstropy({
    { about({ { "CRVAL2", "89.999" } }), { 330.226870283, 89.499551984 } },
    { about({ { "CRVAL2", "-90." }, { "RADESYS", "'FK4'" } }), { 290.311430519, -89.477565296 } },
    { about({ { "CRVAL1", "0.02" } }), { 0.485655855, -29.574190346 } },
    { about({ { "CRVAL1", "-51.28" } }), { 309.185655855, -29.574190346 } },
    { about({ { "PC1_1", ".9" }, { "PC1_2", "-.3" }, { "PC2_1", ".31" }, { "PC2_2", ".95" } }),
      { 204.771573133, -29.714278356 } },
    { about({ { "CROTA2", "33." } }), { 204.455448866, -29.401866239 } },
  });
}

TEST(AsAstropy, Distortions)
{
  const SkyPosition known = { 204.772801881, -29.802140587 };
  Cards scamp = with(with(tpv(), "CTYPE1", "'RA---TAN'"), "CTYPE2", "'DEC--TAN'");
  expectAstropy({ { about(sip), { 204.711023148, -29.574703531 } }, { tpv(), known },
    // The polynomials of TPV under the name that SCAMP gave them before TPV had one.
    { scamp, known } });
  Cards both = about(sip);
  both = with(with(both, "PV1_1", "1.2"), "PV2_1", "1.3");
  expectAstropy({ { both, { 204.711023148, -29.574703531 } } });
  // Absent, the linear terms are 1.
  Cards plain = with(with(tpv(), "CTYPE1", "'RA---TAN'"), "CTYPE2", "'DEC--TAN'");
  plain.erase(std::remove_if(plain.begin(), plain.end(),
                [](const auto& card) { return card.first.rfind("PV", 0) == 0; }),
    plain.end());
  const Cards bare = with(with(plain, "CTYPE1", "'RA---TPV'"), "CTYPE2", "'DEC--TPV'");
  EXPECT_LT(separationArcsec(sky(make(bare), 10, 80), sky(make(plain), 10, 80)), 1e-6);
}
