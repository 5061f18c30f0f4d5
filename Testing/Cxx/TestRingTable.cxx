#include "Readers/Formats/Error.h"
#include "Readers/Formats/RingTable.h"
#include "Testing/Cxx/ErrorOf.h"

#include <gtest/gtest.h>

namespace
{
/// The message of the Error that this text causes, or "" where it causes none.
std::string messageOf(const std::string& text)
{
  return galaxy::errorOf([&] { galaxy::parseRingTable(text, "some.rings"); });
}

const std::string rotcurRow = "86.00 43.00 513.10 0.5 68.84 1.15 -3.5 0.25 224.46 0.75 48.50 0.1 "
                              "-1.58 0.00 1.37 0.00 232 9.71\n";

// Short value lists, an empty keyword, tabs, a comment in a value line, and a second disk whose
// values all differ from the first's.
const std::string tirific = "# a comment with = in it\n"
                            "INSET= cube.fits v\n"
                            "BOX=\n"
                            "\n"
                            "NUR= 4\n"
                            "\tRADI= +0.00000E+00 1.5D+01\t30 45 # arcsec\n"
                            "VROT= 0 50 100\n"
                            "Z0= 3\n"
                            "SBR= 1e-3 2e-3 3e-3 4e-3\n"
                            "INCL= 60 61 62 63\n"
                            "PA= 350 355 0 5\n"
                            "VRAD= -7\n"
                            "VSYS= 555\n"
                            "VROT_2= 9 9 9 9\n"
                            "INCL_2= 1\n"
                            "LTYPE= 3.0\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}
} // namespace

TEST(RingTable, PlainColumns)
{
  const auto table = galaxy::parseRingTable("# r vrot Z0 i PA, all made up\r\n\r\n0 10.5 2 30 -10 "
                                            "# inner\r\n! note\r\n60,+120,2.5,31,350\r\n",
    "some.rings");
  EXPECT_EQ(table.file, "some.rings");
  EXPECT_EQ(table.code, galaxy::RingCode::Plain);
  ASSERT_EQ(table.rings.size(), 2u);
  EXPECT_EQ(table.rings[0].rotationVelocity, 10.5);
  EXPECT_EQ(table.rings[0].positionAngle, -10);
  EXPECT_EQ(table.rings[0].surfaceBrightness, 1);
  EXPECT_EQ(table.rings[1].radius, 60);
  EXPECT_EQ(table.rings[1].rotationVelocity, 120);
  EXPECT_EQ(table.rings[1].scaleHeight, 2.5);
  EXPECT_EQ(table.rings[1].inclination, 31);
  EXPECT_EQ(table.rings[1].positionAngle, -10) << "350, within half a turn of the ring before";
}

TEST(RingTable, HeadingNamesColumns)
{
  const auto table =
    galaxy::parseRingTable("pa,i,radius,vrot\n10,20,30,40\n11,21,31,41\n", "some.csv");
  ASSERT_EQ(table.rings.size(), 2u);
  EXPECT_EQ(table.rings[1].positionAngle, 11);
  EXPECT_EQ(table.rings[1].inclination, 21);
  EXPECT_EQ(table.rings[1].radius, 31);
  EXPECT_EQ(table.rings[1].rotationVelocity, 41);
  EXPECT_EQ(table.rings[1].scaleHeight, 0);
}

TEST(RingTable, BaroloTakesArcsecRatherThanKpc)
{
  const auto table = galaxy::parseRingTable("#RAD(Kpc) RAD(arcs) VROT(km/s) INC(deg) P.A.(deg) "
                                            "Z0(pc) Z0(arcs)\n0.5 25 100 60 200 300 12\n",
    "rings_final1.txt");
  EXPECT_EQ(table.code, galaxy::RingCode::Rotcur);
  ASSERT_EQ(table.rings.size(), 1u);
  EXPECT_EQ(table.rings[0].radius, 25);
  EXPECT_EQ(table.rings[0].scaleHeight, 12);
  EXPECT_EQ(table.rings[0].positionAngle, 200);
}

TEST(RingTable, Rotcur)
{
  const auto table = galaxy::parseRingTable(
    "! ROTCUR  version 1.4 (Jan 21 2015)\n! parameters : VROT\n!\txpos_pix =1\n" + rotcurRow,
    "some.rotcur");
  EXPECT_EQ(table.code, galaxy::RingCode::Rotcur);
  ASSERT_EQ(table.rings.size(), 1u);
  const galaxy::Ring& ring = table.rings[0];
  EXPECT_EQ(ring.radius, 86);
  EXPECT_EQ(ring.rotationVelocity, 68.84);
  EXPECT_EQ(ring.scaleHeight, 0);
  EXPECT_EQ(ring.inclination, 48.5);
  EXPECT_EQ(ring.positionAngle, 224.46);
  EXPECT_EQ(ring.expansionVelocity, 3.5);
  EXPECT_EQ(ring.systemicVelocity, 513.1);
}

TEST(RingTable, TirificFirstDisk)
{
  const auto table = galaxy::parseRingTable(tirific, "some.def");
  EXPECT_EQ(table.code, galaxy::RingCode::Tirific);
  EXPECT_EQ(table.layerLaw, galaxy::LayerLaw::Exponential);
  ASSERT_EQ(table.rings.size(), 4u);
  EXPECT_EQ(table.rings[1].radius, 15);
  EXPECT_EQ(table.rings[1].rotationVelocity, 50);
  EXPECT_EQ(table.rings[3].rotationVelocity, 100) << "the last value holds";
  EXPECT_EQ(table.rings[3].scaleHeight, 3);
  EXPECT_EQ(table.rings[2].surfaceBrightness, 3e-3);
  EXPECT_EQ(table.rings[3].inclination, 63);
  EXPECT_EQ(table.rings[1].positionAngle, 355);
  EXPECT_EQ(table.rings[0].expansionVelocity, -7);
  EXPECT_EQ(table.rings[3].systemicVelocity, 555);
}

TEST(RingTable, EqualRadiiAreAStep)
{
  EXPECT_EQ(
    galaxy::parseRingTable("0 1 0 0 0\n9 1 0 10 0\n9 1 0 20 0\n", "some.rings").rings.size(), 3u);
}

TEST(RingTable, BadColumnsNameTheirLine)
{
  const std::string good = "# heading\n0 100 3 40 200\n";
  EXPECT_EQ(messageOf(good), "");
  EXPECT_EQ(messageOf(good + "9 100 x3 40 200\n"),
    "some.rings: line 3: column 3 (Z0) must be a finite number, not 'x3'");
  EXPECT_EQ(messageOf(good + "\n9 nan 3 40 200\n"),
    "some.rings: line 4: column 2 (vrot) must be a finite number, not 'nan'");
  EXPECT_EQ(messageOf(good + "9 100 3 inf 200\n"),
    "some.rings: line 3: column 4 (i) must be a finite number, not 'inf'");
  EXPECT_EQ(messageOf(good + "9 100 3 40\n"),
    "some.rings: line 3: has 4 columns, must have 5 (r vrot Z0 i PA)");
  EXPECT_EQ(messageOf(good + "9 100 3 40 200 1\n"),
    "some.rings: line 3: has 6 columns, must have 5 (r vrot Z0 i PA)");
  EXPECT_EQ(messageOf(good + "9 1 3 40 200\n8 1 3 40 200\n"),
    "some.rings: line 4: the radius must not be smaller than that of the ring before");
  EXPECT_EQ(messageOf("-1 100 3 40 200\n"), "some.rings: line 1: the radius must be at least 0");
  EXPECT_EQ(
    messageOf("1 100 -3 40 200\n"), "some.rings: line 1: the scale height must be at least 0");
  EXPECT_EQ(messageOf("1e999 100 3 40 200\n"),
    "some.rings: line 1: column 1 (r) must be a finite number, not '1e999'");
  const std::string none = "some.rings: holds no rings; give a row for each: r vrot Z0 i PA";
  EXPECT_EQ(messageOf("# only\n! comments\n\n"), none);
  EXPECT_EQ(messageOf(""), none);
  EXPECT_EQ(messageOf("! ROTCUR\n1 2 3\n"),
    "some.rings: line 2: has 3 columns, must have at least 11 of ROTCUR");
}

TEST(RingTable, BadTirificNamesLineAndKeyword)
{
  EXPECT_EQ(messageOf(tirific), "");
  EXPECT_EQ(messageOf(replaced(tirific, "61", "6l")),
    "some.rings: line 10: INCL: value 2 must be a finite number, not '6l'");
  EXPECT_EQ(messageOf(replaced(tirific, "NUR= 4", "NUR= 5")),
    "some.rings: line 6: RADI: has 4 values, must have NUR = 5");
  EXPECT_EQ(messageOf(replaced(tirific, "NUR= 4", "NUR= 0")),
    "some.rings: line 5: NUR: must be a whole number from 1 to 1000000");
  EXPECT_EQ(messageOf(replaced(tirific, "PA= 350 355 0 5", "")),
    "some.rings: PA: missing, or without a value; give one a ring, or one for all");
  EXPECT_EQ(messageOf(replaced(tirific, "LTYPE= 3.0", "LTYPE= 6")),
    "some.rings: line 16: LTYPE: must be a whole number from 1 to 5");
  EXPECT_EQ(messageOf(replaced(tirific, "30 45", "10 45")),
    "some.rings: line 6: RADI, ring 3: the radius must not be smaller than that of the ring "
    "before");
  EXPECT_EQ(messageOf(replaced(tirific, "BOX=", "BOX")),
    "some.rings: line 3: must be KEYWORD= values or a # comment, not 'BOX'");
  EXPECT_EQ(messageOf("NUR= 3\n"), "some.rings: RADI: missing; give the radius of every ring");
}

TEST(RingTable, MissingFile)
{
  EXPECT_THROW(galaxy::readRingTable("no/such/file.def"), galaxy::Error);
  EXPECT_THROW(galaxy::readRingTable("."), galaxy::Error);
}
