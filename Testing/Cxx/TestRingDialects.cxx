// One table of rings in the writings of many programs: the same rings, or a refusal that names the
// cause.
#include "Testing/Cxx/RingFixtures.h"

namespace galaxy::testing
{
namespace
{
std::string replacedAll(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
  {
    text.replace(at, from.size(), to);
  }
  return text;
}

const std::string csvHeading = "r,vrot,Z0,i,PA\n";
const std::string heading = "r vrot Z0 i PA\n";

const std::string tirific = "NUR= 2\nRADI= 10 20\nVROT= 100 101\nZ0= 2 3\nINCL= 45 46\nPA= 80 81\n";

std::string tirificWith(const std::string& velocities)
{
  return replacedAll(tirific, "100 101", velocities);
}
} // namespace

TEST(RingDialects, MarksAndEndsOfLines)
{
  expectTwoRings("\xef\xbb\xbf" + heading + twoRows());
  expectTwoRings("\xef\xbb\xbf" + twoRows());
  expectTwoRings("\xef\xbb\xbf" + tirific);
  for (const char* end : { "\r", "\r\n" })
  {
    expectTwoRings(replacedAll(heading + twoRows(), "\n", end));
    expectTwoRings(replacedAll(tirific, "\n", end));
  }
}

TEST(RingDialects, Separators)
{
  for (const char* separator : { ";", "; ", ",", ", ", "\t", " \t ", " | ", " & " })
  {
    expectTwoRings(twoRows(separator));
    expectTwoRings(replacedAll(heading, " ", separator) + twoRows(separator));
    expectTwoRings("# " + replacedAll(heading, " ", separator) + twoRows(separator));
  }
  // As spreadsheets end their lines, with a heading and without.
  expectTwoRings(replacedAll("r;vrot;Z0;i;PA\n" + twoRows(";"), "\n", ";\n"));
  expectTwoRings(replacedAll(twoRows(";"), "\n", ";\n"));
  // A column without any value, a cell with a comma, a column of numbers of rows without a name.
  expectTwoRings("r,vrot,Z0,i,PA,note\n10,100,2,45,80,\"a, b\"\n20,101,3,46,81,c d\n");
  expectTwoRings("r\tvrot\tnote\tZ0\ti\tPA\n10\t100\t\t2\t45\t80\n20\t101\t\t3\t46\t81\n");
  expectTwoRings(",r,vrot,Z0,i,PA\n0,10,100,2,45,80\n1,20,101,3,46,81\n");
  expectTwoRings("Name r vrot Z0 i PA\n\"NGC 1\" 10 100 2 45 80\n\"NGC 1\" 20 101 3 46 81\n");
  expectTwoRings("\"r\",\"vrot\",\"Z0\",\"i\",\"PA\"\n\"10\",\"100\",\"2\",\"45\",\"80\"\n"
                 "20,101,3,46,81\n");
}

TEST(RingDialects, DecimalCommas)
{
  const std::string rows = "10,0 100,0 2 45,0 80,0\n20,0 101,0 3 46,0 81,0\n";
  for (const char* separator : { " ", ";", "\t" })
  {
    expectTwoRings(replacedAll(heading + rows, " ", separator));
    expectTwoRings(replacedAll(rows, " ", separator));
  }
  // A number in thousands is not one with three decimals.
  expectRefusal("r;vrot;Z0;i;PA\n1,000;100;2;45;80\n2,000;101;3;46;81\n",
    "line 2: column 1 (r) must be a finite number, not '1,000'; use a decimal point");
}

TEST(RingDialects, SignsOfPapers)
{
  // No-break blanks, the minus sign, primes, degrees in UTF-8 and Latin-1.
  expectTwoRings("10\xc2\xa0"
                 "100\xe2\x80\x89"
                 "2 45 80\n20 101 3 46 81\n");
  const RingTable table = parseRingTable("10 \xe2\x88\x92"
                                         "5 2 45 \xe2\x80\x93"
                                         "80\n",
    "some.rings");
  EXPECT_EQ(table.rings[0].rotationVelocity, -5);
  EXPECT_EQ(table.rings[0].positionAngle, -80);
  expectTwoRings("r (\xe2\x80\xb3),vrot,Z0 (\xe2\x80\xb3),i (\xc2\xb0),PA (\xb0)\n" + twoRows(","));
}

TEST(RingDialects, RulesTitlesTypesAndColumnNumbers)
{
  expectTwoRings(heading + "-----------------\n" + twoRows());
  expectTwoRings("===== =====\n" + heading + "===== =====\n" + twoRows() + "===== =====\n");
  expectTwoRings("| r | vrot | Z0 | i | PA |\n|---|:---:|---|--:|---|\n" + twoRows(" | "));
  expectTwoRings("+---+---+\n| r | vrot | Z0 | i | PA |\n+---+---+\n| 10 | 100 | 2 | 45 | 80 |\n"
                 "| 20 | 101 | 3 | 46 | 81 |\n+---+---+\n");
  expectTwoRings("Rings of NGC 3198, version 2\n" + heading + twoRows());
  expectTwoRings("Rings, version 2\n" + heading + twoRows());
  expectTwoRings("2024 October 12\n" + heading + twoRows());
  expectTwoRings(heading + "(1) (2) (3) (4) (5)\n" + twoRows());
  expectRefusal("By hand\n" + twoRows(), "line 1: must be a row of numbers or names");
  expectRefusal(heading + twoRows() + "(2 rows)\n", "line 4: has 2 columns, must have 5");
  expectRefusal(heading + "made by hand, in two days\n" + twoRows(),
    "line 2: must be a row of 5 numbers, or their units");
}

TEST(RingDialects, MarksOfComments)
{
  for (const char* mark : { "#", "!", "%", "//", ";", "# !" })
  {
    expectTwoRings(mark + (" r vrot PA i Z0\n" + std::string("10 100 80 45 2\n20 101 81 46 3\n")));
  }
  expectTwoRings("% made by hand\n10 100 2 45 80 % inner\n20 101 3 46 81 # outer\n");
}

TEST(RingDialects, Latex)
{
  expectTwoRings("\\begin{tabular}{ccccc}\n\\hline\n"
                 "$r$ & $V_{\\rm rot}$ & $z_0$ & $i$ & P.A. \\\\\n"
                 "(kpc) & (km s$^{-1}$) & (kpc) & (deg) & (deg) \\\\\n\\hline\n"
                 "10 & 100 & 2 & 45 & 80 \\\\\n20 & 101 & 3 & 46 & 81 \\\\\n\\hline\n"
                 "\\end{tabular}\n",
    atArcsecDistance());
  expectTwoRings("\\tablehead{\\colhead{r} & \\colhead{V} & \\colhead{PA} & \\colhead{i} & "
                 "\\colhead{z0}}\n\\startdata\n10 & 100 & 80 & 45 & 2 \\\\\n"
                 "20 & 101 & 81 & 46 & 3\n\\enddata\n");
}

TEST(RingDialects, Ipac)
{
  expectTwoRings("\\fixlen = T\n\\origin = made up\n"
                 "|    r |  vrot |   Z0 |    i |   PA |\n| real | real  | real | real | real |\n"
                 "| kpc  | km/s  | kpc  | deg  | deg  |\n| null | null  | null | null | null |\n"
                 "    10     100      2     45     80 \n    20     101      3     46     81 \n",
    atArcsecDistance());
}

TEST(RingDialects, VizieRAndCds)
{
  expectTwoRings(
    "#RESOURCE=made up\n#Column\tr\t(F5.1)\tRadius\t[ucd=pos]\n"
    "_RAJ2000\tName\tr\tVrot\te_Vrot\tz0\ti\tPA\ndeg\t\tkpc\tkm/s\tkm/s\tkpc\tdeg\tdeg\n"
    "------\t----\t---\t---\t---\t--\t--\t--\n10.5\tNGC 1\t10\t100\t1\t2\t45\t80\n"
    "10.5\tNGC 1\t20\t101\t\t3\t46\t81\n",
    atArcsecDistance());
  const std::string rule(80, '-');
  const std::string described = "Title: Made up\nByte-by-byte Description of file: table2.dat\n" +
    rule + "\n   Bytes Format Units   Label   Explanations\n" + rule +
    "\n   1-  6 A6     ---     Name    Galaxy name\n   8- 11 F4.1   kpc     Rad     Radius\n"
    "  13- 17 F5.1   km/s    Vrot    [0/300] Velocity\n  19- 21 I3     deg     PA      Angle\n"
    "  23- 24 I2     deg     Inc     Angle\n  26- 27 I2     kpc     z0      ?=-9 Height\n" +
    rule + "\nNote (1): 3 rings were left out\n" + rule + "\n";
  expectTwoRings(
    described + "N 1000 10.0 100.0  80 45  2\nN 1000 20.0 101.0  81 46  3\n", atArcsecDistance());
  expectRefusal(described + "N 1000 10.0 100.0  80 45 -9\n", "line 15: column 6 (Z0) must be",
    atArcsecDistance());
}

TEST(RingDialects, NemosRotcurIsNotGipsys)
{
  const std::string log = "rotcur: VERSION 2.13 [NEMO]\n\n free angle : 20.0 (degrees)\n\n"
                          "  radius systemic error rotation error position error inclination error "
                          "x-position error y-position error\n velocity velocity angle angle\n"
                          " (arcsec) (km/s) (km/s)\n";
  const RingTable table = parseRingTable(
    log + "10 500 0 100 1 80 1 45 1 64 1 63 1 100 5\n20 500 0 101 1 81 1 46 1 64 1 63 1 200 5\n",
    "log.rings");
  ASSERT_EQ(table.rings.size(), 2u);
  EXPECT_EQ(table.rings[1].radius, 20);
  EXPECT_EQ(table.rings[1].rotationVelocity, 101);
  EXPECT_EQ(table.rings[1].positionAngle, 81);
  EXPECT_EQ(table.rings[1].inclination, 46);
  EXPECT_EQ(table.rings[1].systemicVelocity, 500);
  EXPECT_EQ(table.code, RingCode::Rotcur);
  const RingTable named = parseRingTable(
    "# rotcur: in=map\n# RAD VSYS XPOS YPOS VROT PA INC\n10 500 64 64 100 80 45\n", "x");
  EXPECT_EQ(named.rings[0].rotationVelocity, 100);
  EXPECT_EQ(named.code, RingCode::Rotcur);
  expectRefusal("# rotcur: in=map\n10 500 1 100 1 80 1 45 1 64 1 63 1 100 5\n",
    "line 2: is a table of NEMO's rotcur without names");
}

TEST(RingDialects, TirificValuesGoToTheNextKeyword)
{
  expectTwoRings(tirific);
  expectTwoRings(tirificWith("100\n      101"));
  expectTwoRings(tirificWith("\n100\n# between\n\t101\n"));
  expectTwoRings(tirificWith("100 \\\n 101"));
  expectTwoRings(tirificWith("100 # inner # 101 # to the end"));
  expectTwoRings(replacedAll(tirific, "\n", " ") + "\n");
  expectTwoRings(replacedAll(tirific, "=", " = "));
  expectTwoRings("## VROT= 7 7 ##\n" + tirific + "# VROT= 8 8\n");
  expectRefusal(tirificWith("100\n 10l"), "line 4: must be KEYWORD= values");
  expectRefusal(tirificWith("100\n 101 1o2"), "line 4: VROT: value 3 must be a finite number");
  expectRefusal("Rings of M83\n" + tirific, "line 1: must be KEYWORD= values");
}

TEST(RingDialects, TirificCentresMayBeSexagesimal)
{
  for (const char* place : { "XPOS= 06:07:12.0\nYPOS= -61:48:00\n",
         "XPOS= 6h7m12s\nYPOS= -61d48m\n", "XPOS= 91.8\nYPOS= -61.8\n" })
  {
    const RingTable table = parseRingTable(tirific + place, "some.def");
    ASSERT_EQ(table.columns.size(), 2u) << place;
    EXPECT_NEAR(table.columns[0].values[1], 91.8, 1e-9) << place;
    EXPECT_NEAR(table.columns[1].values[1], -61.8, 1e-9) << place;
  }
  expectRefusal(tirific + "XPOS= 06:71:12.0\n", "line 7: XPOS: value 1 must be");
}

TEST(RingDialects, OtherFilesAreNamed)
{
  expectRefusal(
    std::string("\xff\xfe") + std::string("1\0 \0", 4), "is UTF-16 text; save it as UTF-8");
  expectRefusal(std::string("1\0 \0002\0 \0003\0\n\0", 12), "is UTF-16 text");
  expectRefusal("\x1f\x8b\x08", "gzip");
  expectRefusal("PK\x03\x04", "spreadsheet");
  expectRefusal("SIMPLE  =                    T", "FITS");
  expectRefusal("<?xml version=\"1.0\"?>\n<VOTABLE/>\n", "VOTable");
  expectRefusal(std::string("10 100 2 45 80\n20 1\0 3 46 81\n", 28), "line 2: holds a NUL byte");
}
} // namespace galaxy::testing
